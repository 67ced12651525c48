#include "core/relaxation.hpp"

#include <utility>

#include "core/geometry.hpp"
#include "core/pieces.hpp"

namespace brisance {
namespace {

/// Of pairs of columns the first <- itself over the second, 0 where there is none.
struct NodalMean {
  Table<double> sums;
  int columns;

  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const Bundle& n) const {
    for (int c = 0; c < columns; c += 2) {
      const Wide weight = n.read(&sums(0, c + 1));
      const WideBool any = weight > Wide(0);
      n.write(&sums(0, c), select(any, n.read(&sums(0, c)) / select(any, weight, 1), 0));
    }
  }
};

template <class G>
class Relaxation {
 public:
  static constexpr int D = G::dim;
  std::vector<std::unique_ptr<Group<G>>>& groups;
  const Grid<G>& grid;
  Accumulator* sums;  ///< the latest means at the nodes
  Accumulator* spare;
  Sweep<D> sweep{grid.lattice};  ///< what is to be done before the next means

  template <class F>
  void for_fluids(F&& f) {
    for (auto& group : groups)
      if (group->relaxes()) f(*group);
  }

  /// Does what the sweep holds, the last of which has added to `spare`, and returns the sums.
  Table<double> add_up(int columns) {
    sweep.run();
    std::swap(sums, spare);
    sums->contribute();
    fold(sums->total, 0, columns, grid.lattice, grid.boundaries);
    return sums->total;
  }

  /// The columns 0 and, if there are two, 2 of the sums <- means over what follows them.
  void take_means(int columns) {
    const auto total = add_up(columns);
    for_each("nodal mean", AllNodes{grid.lattice.size}, NodalMean{total, columns});
    fill(total, 0, columns - 1, grid.lattice, grid.boundaries);
  }

  /// Scratch column <- itself without its mean by volume.
  void remove_mean(int column) {
    sweep.clear(*spare, 2);
    for_fluids([&](Group<G>& g) {
      auto& p = g.particles;
      g.transfer->scatter_mean(sweep, p, {{p.scratch, column}, {p.volume}}, 0, *spare);
    });
    take_means(2);
    for_fluids([&](Group<G>& g) {
      auto& p = g.particles;
      g.transfer->gather_scalar(sweep, p, {{sums->total}, {p.scratch, column}, 1, -1});
    });
  }

  /// s_i = sum N V / V_i should be 1. Where a node's surroundings are not full (s_i < 0.7), nothing
  /// is corrected. In the same look at the nodes the pressure without its mean becomes scratch 0.
  void volume(const RelaxationRates& rates, const Table<double>& asleep) {
    const bool presses = rates.pressure > 0;
    if (presses) for_fluids([&](Group<G>& g) { g.load_pressure(sweep); });
    sweep.clear(*spare, 4);
    for (auto& g : groups) {
      auto& p = g->particles;
      const bool relaxes = g->relaxes();
      const Entry value = presses && relaxes ? Entry{p.scratch} : Entry{p.volume};
      g->transfer->scatter_mean(sweep, p, {value, {p.volume}}, relaxes ? 0 : 2, *spare);
    }
    const auto total = add_up(4);
    const auto lattice = grid.lattice;
    const auto boundaries = grid.boundaries;
    const bool any_sleeps = asleep.extent(0) > 0;
    Kokkos::parallel_for(
        "fullness", Kokkos::RangePolicy<Space>(0, lattice.size), KOKKOS_LAMBDA(const int n) {
          const double fluid = total(n, 1),
                       here = fluid + total(n, 3) + (any_sleeps ? asleep(n, 0) : 0),
                       s = here / boundaries.nodal_volume(lattice, n);
          total(n, 0) = fluid > 0 ? total(n, 0) / fluid : 0;
          total(n, 1) = s < 0.7 ? not_full : s;
        });
    fill(total, 0, 2, grid.lattice, grid.boundaries);
    for_fluids([&](Group<G>& g) {
      auto& p = g.particles;
      const Gathering fullness{{total, 1}, {p.scratch, 1}, 0, 1},
          residual{{total, 0}, {p.scratch, 0}, 1, -1};
      if (presses)
        g.transfer->gather_two_scalars(sweep, p, fullness, residual);
      else
        g.transfer->gather_scalar(sweep, p, fullness);
      g.correct_volume(sweep, rates.volume);
    });
  }

  /// r = (1 - S S+)^2 P is the part of the pressure that no node sees. Its first half is there
  /// where volumes have been corrected.
  void pressure(double rate, double dt, bool first_half_is_there) {
    if (!first_half_is_there) {
      for_fluids([&](Group<G>& g) { g.load_pressure(sweep); });
      remove_mean(0);
    }
    remove_mean(0);
    for_fluids([&](Group<G>& g) { g.propose_exchange(sweep, rate, dt); });
    remove_mean(1);
  }

  /// What the exchange of volume costs, without its mean by energy, and the heat shared.
  void energy(bool exchanges, double heat) {
    for_fluids([&](Group<G>& g) { g.exchange_volume(sweep, exchanges, heat); });
    const bool both = exchanges && heat > 0;
    sweep.clear(*spare, both ? 4 : 2);
    for_fluids([&](Group<G>& g) {
      auto& p = g.particles;
      const Weighted cost{{p.scratch, 0}, {p.scratch, 1}}, hot{{p.history}, {p.scratch, 2}};
      if (both)
        g.transfer->scatter_two_means(sweep, p, cost, hot, *spare);
      else
        g.transfer->scatter_mean(sweep, p, exchanges ? cost : hot, 0, *spare);
    });
    take_means(both ? 4 : 2);
    for_fluids([&](Group<G>& g) {
      auto& p = g.particles;
      const Gathering cost{{sums->total, 0}, {p.scratch, 0}, 1, -1},
          hot{{sums->total, both ? 2 : 0}, {p.scratch, 1}, 0, 1};
      if (both)
        g.transfer->gather_two_scalars(sweep, p, cost, hot);
      else
        g.transfer->gather_scalar(sweep, p, exchanges ? cost : hot);
      g.exchange_energy(sweep, exchanges, heat > 0);
    });
  }
};

}  // namespace

template <class G>
void relax(std::vector<std::unique_ptr<Group<G>>>& groups, const Grid<G>& grid, Accumulator& sums,
           Accumulator& spare, const RelaxationRates& rates, double dt,
           const Table<double>& asleep) {
  Relaxation<G> relaxation{groups, grid, &sums, &spare};
  const bool presses = rates.pressure > 0;
  if (rates.volume > 0) relaxation.volume(rates, asleep);
  if (presses) relaxation.pressure(rates.pressure, dt, rates.volume > 0);
  if (presses || rates.heat > 0) relaxation.energy(presses, rates.heat * dt);
  relaxation.sweep.run();
}

#define BRISANCE_RELAX(G)                                                                       \
  template void relax<G>(std::vector<std::unique_ptr<Group<G>>>&, const Grid<G>&, Accumulator&, \
                         Accumulator&, const RelaxationRates&, double, const Table<double>&);
BRISANCE_RELAX(Line)
BRISANCE_RELAX(PlaneStrain)
#undef BRISANCE_RELAX

}  // namespace brisance
