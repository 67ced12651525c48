#include "core/step.hpp"

#include <algorithm>

#include "core/cells.hpp"
#include "core/geometry.hpp"
#include "core/nodal_motion.hpp"
#include "core/split.hpp"

namespace brisance {
namespace {

template <class G>
class Step {
 public:
  static constexpr int D = G::dim;
  State<G>& s;
  Exchange<G>& others;
  double dt = 0;
  bool in_waves = false;           ///< whether the last sweep sorts particles, too
  Sweep<D> sweep{s.grid.lattice};  ///< what is to be done before the next look at the nodes

  void prepare() {
    for (auto& g : s.groups) {
      arrange(*g);
      g->start();
    }
    momentum_to_grid();
    for (auto& g : s.groups) {
      g->transfer->gather_gradient(sweep, g->particles, s.grid.before);
      g->find_signals(sweep);
    }
    sweep.run();
  }

  double begin() {
    sweep.clear(s.spare, D + s.grid.volumes(), s.force_early() ? 0 : D);
    if (s.force_early()) scatter_force(s.spare);
    momentum_to_grid(s.grid.knows_cells());
    if (s.grid.knows_cells()) know_cells();
    double fastest = s.scheme.midpoint ? others.max(strain_signal()) : 0;
    for (auto& g : s.groups) {
      const Signals here = g->signals();
      const Signals asleep = s.sleep.signals(*g);
      g->fastest = {others.max(std::max(here.over_grid, asleep.over_grid)),
                    others.max(std::max(here.in_matter, asleep.in_matter))};
      fastest = std::max(fastest, g->fastest.over_grid);
    }
    return fastest;
  }

  void midpoint() {
    damp_against_walls();
    if (!s.springs.empty()) s.springs.weigh(s.groups, s.grid, s.sums);
    for (auto& g : s.groups) {
      g->transfer->gather_gradient(sweep, g->particles, s.grid.before);
      g->half_step(sweep, s.grid, dt);
    }
    force_to_grid();
    for (auto& g : s.groups) {
      g->transfer->finish_midpoint(sweep, g->particles, s.grid, g->stress(), g->velocity_class,
                                   flip(*g), dt);
      g->finish(sweep, s.grid, dt);
      g->find_signals(sweep);
      to_new_order(*g);
    }
    new_order();
    relax_fluids();
    if (s.scheme.relaxes_stress) relax_stress(s.groups, s.grid, s.means, dt);
    s.sleep.wake(s.groups, s.sorter);
  }

  /// Appendix A of Hu & Chen (2006): the velocities mapped back to the old positions give the
  /// strain.
  void musl() {
    damp_against_walls();
    if (!s.springs.empty()) s.springs.weigh(s.groups, s.grid, s.sums);
    force_to_grid();
    for (auto& g : s.groups)
      g->transfer->accelerate(sweep, g->particles, s.grid, g->velocity_class, flip(*g));
    if (s.grid.mixed()) sweep.run();  // all, before the nodes of one class are summed
    momentum_to_grid();
    for (auto& g : s.groups) {
      g->transfer->gradient_and_move(sweep, g->particles, s.grid, s.grid.before, dt);
      g->update(sweep, s.grid, dt);
      g->find_signals(sweep);
      to_new_order(*g);
    }
    new_order();
  }

 private:
  bool anything_relaxes() const {
    for (const auto& g : s.groups)
      if (g->relaxes()) return true;
    return false;
  }

  /// How many cells sound crosses in the step, at its fastest in a class.
  double crossings(int velocity_class) const {
    double fastest = 0;
    for (const auto& g : s.groups)
      if (g->velocity_class == velocity_class) fastest = std::max(fastest, g->fastest.in_matter);
    return fastest * dt / s.grid.lattice.h;
  }

  /// Damping by the time it takes sound to cross a cell: the same for any time step, in any frame,
  /// and for all of a class, whose drifts from their common field cancel out only then.
  double flip(const Group<G>& g) const {
    return 1 - std::min(0.1, g.scheme.damping * crossings(g.velocity_class));
  }

  /// For all steps since the last time.
  void relax_fluids() {
    const int steps = s.scheme.relaxation_interval;
    if (!anything_relaxes() || (s.step + 1) % steps != 0) return;
    RelaxationRates rates = s.scheme.rates;
    rates.volume = std::min(0.2, rates.volume * steps * crossings(fluid_class));
    relax(s.groups, s.grid, s.sums, s.spare, rates, steps * dt, s.sleep.volume());
  }

  /// What the strain of cells at the start of the step counts as. Their particles have told of
  /// signals at the end of the step before: matter that meets has not been strained by then. [m/s]
  double strain_signal() const {
    double length = 0;
    for (const auto& g : s.groups) length = std::max(length, g->scheme.strain_length);
    return length * fastest_strain(s.grid);
  }

  /// grid.own and grid.before <- velocities at the nodes, walls at rest; after what the sweep
  /// holds. In the same look at the particles their volumes in cells go to s.spare, if wanted.
  void momentum_to_grid(bool volumes = false) {
    s.stopped.assign(s.grid.own.size(), {});
    for (std::size_t c = 0; c < s.grid.own.size(); ++c) {
      sweep.clear(s.sums, D + 1);
      for (auto& g : s.groups)
        if (g->velocity_class == static_cast<int>(c)) {
          g->transfer->scatter_momentum(sweep, g->particles, s.sums);
          if (volumes) scatter_volume(*g);
        }
      sweep.run();
      s.stopped[c] = collect(s.sums, D + 1, s.grid.image_mass[c]);
      const auto own = s.grid.own[c];
      for_each("nodal velocity", AllNodes{s.grid.lattice.size},
               NodalVelocity<D>{s.sums.total, own});
      fill(own, D, D + 1, s.grid.lattice, s.grid.boundaries);
      s.stopped[c] = difference(s.stopped[c], images(own, c));
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

  void scatter_volume(const Group<G>& g) {
    if (g.fluid())
      g.transfer->scatter_volume(sweep, g.particles, D, s.spare);
    else
      g.transfer->scatter_overlap(sweep, g.particles, D + 1, s.spare);
  }

  /// grid.cell and what follows from it.
  void know_cells() {
    s.spare.contribute();
    if (s.sleep.any()) s.sleep.fill(s.spare);
    double beside = 0;
    for (auto& g : s.groups)
      if (g->fluid()) beside = g->transfer->beside();
    describe_cells(s.grid, s.spare, beside);
    if (s.grid.scale.extent(0) > 0) scale_cells(s.grid);
    if (s.grid.smoothness.extent(0) > 0) limit_cells(s.grid);
  }

  void scatter_force(Accumulator& sums) {
    for (auto& g : s.groups)
      g->transfer->scatter_force(sweep, g->particles, s.grid, g->stress(), sums);
  }

  /// grid.after <- grid.before + dt f / m, after what the sweep holds.
  void force_to_grid() {
    Accumulator& sums = s.force_early() ? s.spare : s.sums;
    if (!s.force_early()) {
      sweep.clear(sums, D);
      scatter_force(sums);
    }
    sweep.run();
    push_walls(collect(sums, D), dt);
    if (!s.springs.empty()) push_walls(s.springs.pull(s.grid, sums.total, dt), 1);
    for (std::size_t c = 0; c < s.grid.own.size(); ++c) push_walls(images(s.grid.before, c), 1);
    const auto after = s.grid.after;
    const double fastest = greatest_of("move grid", AllNodes{s.grid.lattice.size},
                                       MoveNodes<D>{s.grid.before, sums.total, after, dt});
    in_waves = s.wavefront.takes(s.groups, s.grid.lattice, s.grid.boundaries, fastest * dt);
    fill(after, D, D, s.grid.lattice, s.grid.boundaries);
    for (std::size_t c = 0; c < s.grid.own.size(); ++c) push_walls(images(after, c), -1);
  }

  /// Sums of all threads, ranks and mirror images: of forces (D columns), or momentum and mass.
  /// Returns what walls, and gas that sleeps, have stopped.
  Vec<D> collect(Accumulator& sums, int columns, const Table<double>& image_mass = {}) {
    sums.contribute();
    if (s.sleep.any() && columns == D) s.sleep.press(sums);
    others.sum(sums);
    Vec<D> stopped = fold(sums.total, D, columns, s.grid.lattice, s.grid.boundaries, image_mass);
    const Vec<D> held = constrain(sums.total, s.grid.lattice, s.grid.boundaries);
    const Vec<D> still = s.sleep.any() ? s.sleep.hold(sums.total) : Vec<D>();
    if (columns == D) s.sleep.note(still, dt);
    for (int d = 0; d < D; ++d) stopped[d] += held[d] + still[d];
    return stopped;
  }

  Vec<D> images(const Table<double>& velocity, std::size_t c) const {
    return image_momentum(velocity, s.grid.image_mass[c], s.grid.lattice, s.grid.boundaries);
  }

  static Vec<D> difference(Vec<D> a, const Vec<D>& b) {
    for (int d = 0; d < D; ++d) a[d] -= b[d];
    return a;
  }

  void push_walls(const Vec<D>& momentum, double share) {
    for (int d = 0; d < D; ++d) s.wall_impulse[d] += share * momentum[d];
  }

  /// What walls have stopped is lost to the particles as far as their new velocities come from the
  /// grid.
  void damp_against_walls() {
    for (std::size_t c = 0; c < s.stopped.size(); ++c) {
      double share = 0;
      for (auto& g : s.groups)
        if (g->velocity_class == static_cast<int>(c))
          share = g->transfer->affine() ? 1 : 1 - flip(*g);
      push_walls(s.stopped[c], share);
    }
  }

  /// What is asked of moved particles before they come into a new order.
  void to_new_order(const Group<G>& g) {
    g.transfer->find_bins(sweep, g.particles);
    if (s.splits(g)) find_longest(sweep, g.particles, s.longest);
  }

  /// Does what the sweep holds, and sorts.
  void new_order() {
    in_waves ? s.wavefront.run(sweep) : sweep.run();
    const bool any_long = any_are_long();
    for (auto& g : s.groups) {
      // Where most move a wave has sorted already, or would have: parts come after that.
      const bool sorted_first = g->in_motion;
      if (sorted_first) sort_moved(*g);
      const int parts = any_long && s.splits(*g)
                            ? split(g->particles, s.grid.lattice, s.grid.boundaries,
                                    s.scheme.split_length, s.next_id)
                            : 0;
      if (parts > 0 || !sorted_first) arrange(*g, parts == 0);
      g->in_motion = g->in_motion && parts == 0;
    }
    others.migrate(s.groups);
  }

  void sort_moved(Group<G>& g) {
    if (!in_waves || !s.wavefront.sorted(g)) {
      arrange(g, true);
      return;
    }
    g.in_motion = s.wavefront.most_moved(g);
    if (s.wavefront.any_left(g)) arrange(g);
  }

  /// Particles into their bins, where these are known already; those that have left are written
  /// off.
  void arrange(Group<G>& g, bool known = false) {
    if (!known) g.transfer->find_bins(s.grid.lattice, g.particles);
    const int left = s.sorter.sort(g.particles, s.grid.lattice);
    const int count = g.particles.count;
    g.in_motion = s.sorter.most_moved() && left == 0;
    if (left == 0) return;
    s.outflow += g.totals(count, count + left, g.transfer->affine_inertia(s.grid.lattice.h));
    s.left += left;
  }

  /// Whether a particle is to be split.
  bool any_are_long() const {
    const bool asked =
        std::any_of(s.groups.begin(), s.groups.end(), [&](auto& g) { return s.splits(*g); });
    return asked && take_longest(s.longest) > s.scheme.split_length * s.grid.lattice.h;
  }

  Kokkos::RangePolicy<Space> nodes() const {
    return Kokkos::RangePolicy<Space>(0, s.grid.lattice.size);
  }
};

}  // namespace

template <class G>
void prepare(State<G>& state) {
  Exchange<G> alone;
  Step<G>{state, alone}.prepare();
}

template <class G>
double begin_step(State<G>& state, Exchange<G>& others) {
  return Step<G>{state, others}.begin();
}

template <class G>
void finish_step(State<G>& state, Exchange<G>& others, double dt) {
  state.grid.time = state.time;
  Step<G> step{state, others, dt};
  state.scheme.midpoint ? step.midpoint() : step.musl();
  state.time += dt;
  ++state.step;
}

#define BRISANCE_STEP(G)                                  \
  template void prepare<G>(State<G>&);                    \
  template double begin_step<G>(State<G>&, Exchange<G>&); \
  template void finish_step<G>(State<G>&, Exchange<G>&, double);
BRISANCE_STEP(Line)
BRISANCE_STEP(PlaneStrain)
#undef BRISANCE_STEP

}  // namespace brisance
