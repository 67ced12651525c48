#include "core/relaxation.hpp"

#include <utility>

#include "core/geometry.hpp"

namespace brisance {
namespace {

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

  /// Does what the sweep holds, the last of which has added to `spare`.
  Table<double> add_up() {
    sweep.run();
    std::swap(sums, spare);
    sums->contribute();
    fold(sums->total, 0, 2, grid.lattice, grid.boundaries);
    return sums->total;
  }

  enum class Weight { volume, scratch };

  /// sums->total(node, 0) <- mean at the nodes of scratch column 0 or 1.
  void average(int column, Weight weight) {
    spare->clear();
    for_fluids([&](Group<G>& g) {
      auto& p = g.particles;
      const Entry by = weight == Weight::volume ? Entry{p.volume, 0} : Entry{p.scratch, 1};
      g.transfer->scatter_mean(sweep, p, Entry{p.scratch, column}, by, *spare);
    });
    const auto total = add_up();
    Kokkos::parallel_for(
        "nodal mean", Kokkos::RangePolicy<Space>(0, grid.lattice.size), KOKKOS_LAMBDA(const int n) {
          total(n, 0) = total(n, 1) > 0 ? total(n, 0) / total(n, 1) : 0;
        });
    fill(total, 0, 1, grid.lattice, grid.boundaries);
  }

  /// scratch(column) <- keep * scratch(column) + factor * nodal field gathered.
  void gather(int field, int column, double keep, double factor) {
    for_fluids([&](Group<G>& g) {
      g.transfer->gather_scalar(sweep, g.particles, {sums->total, field},
                                {g.particles.scratch, column}, keep, factor);
    });
  }

  void remove_mean(int column, Weight weight) {
    average(column, weight);
    gather(0, column, 1, -1);
  }

  /// s_i = sum N V / V_i should be 1. Scratch 0 <- s at the particle; scratch 1 <- how much of its
  /// neighbourhood is not full (s_i < 0.7), where nothing is corrected.
  void volume(double rate, const Table<double>& asleep) {
    spare->clear();
    for (auto& g : groups)
      g->transfer->scatter_mean(sweep, g->particles, Entry{g->particles.volume, 0},
                                Entry{g->particles.volume, 0}, *spare);
    const auto total = add_up();
    const auto lattice = grid.lattice;
    const auto boundaries = grid.boundaries;
    const bool any_sleeps = asleep.extent(0) > 0;
    Kokkos::parallel_for(
        "fullness", Kokkos::RangePolicy<Space>(0, lattice.size), KOKKOS_LAMBDA(const int n) {
          const double here = total(n, 1) + (any_sleeps ? asleep(n, 0) : 0);
          const double s = here / boundaries.nodal_volume(lattice, n);
          total(n, 0) = s;
          total(n, 1) = s < 0.7 ? 1 : 0;
        });
    fill(total, 0, 2, grid.lattice, grid.boundaries);
    gather(0, 0, 0, 1);
    gather(1, 1, 0, 1);
    for_fluids([&](Group<G>& g) { g.correct_volume(sweep, rate); });
  }

  /// r = (1 - S S+)^2 P is the part of the pressure that no node sees.
  void pressure(double rate, double dt) {
    for_fluids([&](Group<G>& g) { g.load_pressure(sweep); });
    remove_mean(0, Weight::volume);
    remove_mean(0, Weight::volume);
    for_fluids([&](Group<G>& g) { g.propose_exchange(sweep, rate, dt); });
    remove_mean(1, Weight::volume);
    for_fluids([&](Group<G>& g) { g.exchange_volume(sweep); });
    remove_mean(0, Weight::scratch);
    for_fluids([&](Group<G>& g) { g.exchange_energy(sweep); });
  }

  void heat(double rate, double dt) {
    for_fluids([&](Group<G>& g) { g.load_heat(sweep, rate, dt); });
    remove_mean(0, Weight::scratch);
    for_fluids([&](Group<G>& g) { g.conduct(sweep); });
  }
};

}  // namespace

template <class G>
void relax(std::vector<std::unique_ptr<Group<G>>>& groups, const Grid<G>& grid, Accumulator& sums,
           Accumulator& spare, const RelaxationRates& rates, double dt,
           const Table<double>& asleep) {
  Relaxation<G> relaxation{groups, grid, &sums, &spare};
  if (rates.volume > 0) relaxation.volume(rates.volume, asleep);
  if (rates.pressure > 0) relaxation.pressure(rates.pressure, dt);
  if (rates.heat > 0) relaxation.heat(rates.heat, dt);
  relaxation.sweep.run();
}

#define BRISANCE_RELAX(G)                                                                       \
  template void relax<G>(std::vector<std::unique_ptr<Group<G>>>&, const Grid<G>&, Accumulator&, \
                         Accumulator&, const RelaxationRates&, double, const Table<double>&);
BRISANCE_RELAX(Line)
BRISANCE_RELAX(PlaneStrain)
#undef BRISANCE_RELAX

}  // namespace brisance
