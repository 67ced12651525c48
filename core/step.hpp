#pragma once
// One time step, the algorithm on one screen (step.cpp).
#include <algorithm>

#include "core/group.hpp"
#include "core/relaxation.hpp"
#include "core/sleep.hpp"
#include "core/sort.hpp"
#include "core/springs.hpp"
#include "core/stress_relaxation.hpp"
#include "core/wavefront.hpp"

namespace brisance {

/// What neighbouring ranks do for each other. This one is alone and does nothing.
template <class G>
class Exchange {
 public:
  virtual ~Exchange() = default;
  /// Adds what neighbours have summed for the nodes that both hold.
  virtual void sum(Accumulator&) {}
  /// Hands over the particles that have left this rank's box.
  virtual void migrate(std::vector<std::unique_ptr<Group<G>>>&) {}
  /// The largest value of all ranks.
  virtual double max(double value) { return value; }
};

/// The choices of a scheme that concern the step as a whole.
struct StepScheme {
  bool midpoint = true;     ///< compatible energy with half-step stress; else MUSL (Appendix A)
  double split_length = 0;  ///< fluids' particles longer than this many cells are split; 0: never
  RelaxationRates rates;
  int relaxation_interval = 1;  ///< steps from one relaxation of fluids to the next
  bool relaxes_stress = false;  ///< whether any solid does
  Summation summation = Summation::colours;
};

template <class G>
struct State {
  static constexpr int D = G::dim;

  Grid<G> grid;
  std::vector<std::unique_ptr<Group<G>>> groups;
  StepScheme scheme;
  Accumulator sums;
  Accumulator spare;  ///< of relaxations, which read one while they write the other; at the start
                      ///< of a step of forces and, from column D on, of volumes in cells
  Accumulator means;  ///< of stress; empty unless the scheme relaxes it
  Sorter<G> sorter;
  Wavefront<G> wavefront;
  Springs<G> springs;
  Sleep<G> sleep;

  double time = 0;
  long step = 0;
  std::int64_t next_id = 0;

  Array<double> debt;     ///< see Group
  Array<double> longest;  ///< of each row: the greatest length of particles that may be split [m]
  std::vector<Vec<D>>
      stopped;  ///< of each class: nodal momentum that walls took out at the start of the step
  Vec<D> wall_impulse;  ///< momentum given to walls, and to gas that sleeps, so far [N s], per
                        ///< metre or square metre
  Totals outflow;       ///< what left through free ends so far
  long left = 0;        ///< in how many particles

  State(const Grid<G>& grid_, const StepScheme& scheme_)
      : grid(grid_),
        scheme(scheme_),
        sums(grid_.lattice.size, std::max(D + 1, scheme_.rates.any() ? relaxation_columns : 0),
             scheme_.summation),
        spare(scheme_.rates.any() || force_early() || grid_.knows_cells() ? grid_.lattice.size : 0,
              std::max(D + grid_.volumes(), scheme_.rates.any() ? relaxation_columns : 0),
              scheme_.summation),
        means(scheme_.relaxes_stress ? grid_.lattice.size : 0, 4, scheme_.summation),
        longest("longest of rows",
                scheme_.split_length > 0 ? RowLayout<D>(grid_.lattice).rows : 0) {}

  /// Whether particles of a group are split when they get long.
  bool splits(const Group<G>& group) const { return group.fluid() && scheme.split_length > 0; }

  /// Whether forces are summed together with momenta, as the stress of MUSL allows unless it is
  /// scaled by what cells hold: saves another look at the particles.
  bool force_early() const { return !scheme.midpoint && grid.scale.extent(0) == 0; }

  /// Those that sleep included.
  long particles() const {
    long sum = sleep.count();
    for (const auto& g : groups) sum += g->particles.count;
    return sum;
  }
};

/// Sorts the particles into their bins and sets the stress that belongs to their state. Once,
/// before the first step.
template <class G>
void prepare(State<G>& state);

/// The start of a step: velocities of the nodes, and what fills cells. Returns the fastest signal
/// over the grid, which decides how far the step may go. [m/s]
template <class G>
double begin_step(State<G>& state, Exchange<G>& others);

/// The rest of the step, by dt [s].
template <class G>
void finish_step(State<G>& state, Exchange<G>& others, double dt);

}  // namespace brisance
