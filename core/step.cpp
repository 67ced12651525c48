#include "core/step.hpp"

#include <algorithm>

#include "core/cells.hpp"
#include "core/geometry.hpp"
#include "core/split.hpp"

namespace brisance {
namespace {

template <class G>
class Step {
 public:
  static constexpr int D = G::dim;
  State<G>& s;
  Exchange<G>& others;
  double dt;

  /// Bins, gradients and stresses as the first step needs them, and the fastest signal.
  double start() {
    for (auto& g : s.groups) arrange(*g);
    momentum_to_grid(false);
    for (auto& g : s.groups) g->transfer->gather_gradient(g->particles, s.grid.lattice, s.grid.before);
    double fastest = 0;
    for (auto& g : s.groups) fastest = std::max(fastest, g->start(s.grid));
    return others.max(fastest);
  }

  double midpoint() {
    momentum_to_grid(true);
    for (auto& g : s.groups) g->transfer->gather_gradient(g->particles, s.grid.lattice, s.grid.before);
    know_cells();
    for (auto& g : s.groups) g->half_step(s.grid, dt);
    force_to_grid();
    for (auto& g : s.groups)
      g->transfer->finish_midpoint(g->particles, s.grid, g->stress(), g->velocity_class, g->scheme.flip, dt);
    return new_state([&](Group<G>& g) { return g.finish(s.grid, dt); });
  }

  /// Appendix A of Hu & Chen (2006): the velocities mapped back to the old positions give the strain.
  double musl() {
    momentum_to_grid(true);
    know_cells();
    force_to_grid();
    for (auto& g : s.groups) g->transfer->accelerate(g->particles, s.grid, g->velocity_class, g->scheme.flip);
    momentum_to_grid(false);
    for (auto& g : s.groups) g->transfer->gradient_and_move(g->particles, s.grid, s.grid.before, dt);
    return new_state([&](Group<G>& g) { return g.update(s.grid, dt); });
  }

 private:
  /// grid.own and grid.before <- velocities at the nodes, walls at rest. A velocity update that draws particles
  /// toward this field (`damping`) leaves the momentum that walls have stopped with them.
  void momentum_to_grid(bool damping) {
    for (std::size_t c = 0; c < s.grid.own.size(); ++c) {
      double share = 0;
      s.sums.clear();
      for (auto& g : s.groups)
        if (g->velocity_class == static_cast<int>(c)) {
          g->transfer->scatter_momentum(g->particles, s.grid.lattice, s.sums);
          if (damping) share = g->transfer->affine() ? 1 : 1 - g->scheme.flip;
        }
      collect(D + 1, share);
      const auto own = s.grid.own[c], total = s.sums.total;
      Kokkos::parallel_for(
          "nodal velocity", nodes(), KOKKOS_LAMBDA(const int n) {
            const double m = total(n, D);
            own(n, D) = m;
            for (int d = 0; d < D; ++d) own(n, d) = m > 0 ? total(n, d) / m : 0;
          });
      fill(own, D, D + 1, s.grid.lattice, s.grid.boundaries);
    }
    if (s.grid.own.size() > 1) share_velocity();
  }

  /// grid.before <- the common velocity of all classes.
  void share_velocity() {
    const auto before = s.grid.before;
    Kokkos::deep_copy(before, 0.0);
    for (const auto& own : s.grid.own)
      Kokkos::parallel_for(
          "add class", nodes(), KOKKOS_LAMBDA(const int n) {
            const double m = own(n, D);
            for (int d = 0; d < D; ++d) before(n, d) += m * own(n, d);
            before(n, D) += m;
          });
    Kokkos::parallel_for(
        "common velocity", nodes(), KOKKOS_LAMBDA(const int n) {
          const double m = before(n, D);
          for (int d = 0; d < D; ++d) before(n, d) = m > 0 ? before(n, d) / m : 0;
        });
  }

  /// grid.cell and what follows from it, as far as the scheme asks for it.
  void know_cells() {
    if (s.grid.cell.extent(0) == 0) return;
    s.sums.clear();
    for (auto& g : s.groups) g->transfer->scatter_cells(g->particles, s.grid.lattice, s.sums);
    s.sums.contribute();
    average_cells(s.grid, s.sums);
    if (s.grid.scale.extent(0) > 0) scale_cells(s.grid);
    if (s.grid.smoothness.extent(0) > 0) limit_cells(s.grid);
  }

  /// grid.after <- grid.before + dt f / m.
  void force_to_grid() {
    s.sums.clear();
    for (auto& g : s.groups) g->transfer->scatter_force(g->particles, s.grid, g->stress(), s.sums);
    collect(D, dt);
    const auto before = s.grid.before, after = s.grid.after, force = s.sums.total;
    const double step = dt;
    Kokkos::parallel_for(
        "move grid", nodes(), KOKKOS_LAMBDA(const int n) {
          const double m = before(n, D);
          for (int d = 0; d < D; ++d) after(n, d) = before(n, d) + (m > 0 ? step * force(n, d) / m : 0);
        });
    fill(after, D, D, s.grid.lattice, s.grid.boundaries);
  }

  /// Sums of all threads, ranks and mirror images; walls take `share` of what they stop as impulse.
  void collect(int columns, double share) {
    s.sums.contribute();
    others.sum(s.sums);
    const Vec<D> mirrored = fold(s.sums.total, D, columns, s.grid.lattice, s.grid.boundaries);
    const Vec<D> held = constrain(s.sums.total, s.grid.lattice, s.grid.boundaries);
    for (int d = 0; d < D; ++d) s.wall_impulse[d] += share * (mirrored[d] + held[d]);
  }

  template <class F>
  double new_state(F&& f) {
    double fastest = 0;
    for (auto& g : s.groups) fastest = std::max(fastest, f(*g));
    for (auto& g : s.groups) {
      if (g->fluid() && s.scheme.split_length > 0)
        split(g->particles, s.grid.lattice, s.grid.boundaries, s.scheme.split_length, s.next_id);
      arrange(*g);
    }
    others.migrate(s.groups);
    relax(s.groups, s.grid, s.sums, s.scheme.rates, dt);
    s.time += dt;
    ++s.step;
    return others.max(fastest);
  }

  /// Particles into their bins; those that have left are written off.
  void arrange(Group<G>& g) {
    const int left = s.sorter.sort(g.particles, *g.transfer, s.grid.lattice);
    const int count = g.particles.count;
    if (left > 0) s.outflow += g.totals(count, count + left, g.transfer->affine_inertia(s.grid.lattice.h));
  }

  Kokkos::RangePolicy<Space> nodes() const { return Kokkos::RangePolicy<Space>(0, s.grid.lattice.size); }
};

}  // namespace

template <class G>
double start(State<G>& state, Exchange<G>& others) {
  Step<G> none{state, others, 0};
  return none.start();
}

template <class G>
double step(State<G>& state, Exchange<G>& others, double dt) {
  Step<G> one{state, others, dt};
  return state.scheme.midpoint ? one.midpoint() : one.musl();
}

template double start<Line>(State<Line>&, Exchange<Line>&);
template double start<PlaneStrain>(State<PlaneStrain>&, Exchange<PlaneStrain>&);
template double step<Line>(State<Line>&, Exchange<Line>&, double);
template double step<PlaneStrain>(State<PlaneStrain>&, Exchange<PlaneStrain>&, double);

}  // namespace brisance
