#pragma once
// Gas at rest that no wave has reached sleeps: an optional part of the step. Its points are kept
// apart, where no kernel sees them; the nodes of their cells hold still, which is exact as long as
// the gas around is at rest at the same pressure. A cell wakes before anything that differs from
// rest comes within `margin` cells of it: linear shapes carry news by two cells in a step,
// relaxations pass on ever smaller shares of it. Measured on blasts in the plane: with 4 cells
// results differ by 1e-5, with 6 by 1e-13 from those with all awake.
//
// One difference remains. Round-off makes gas at rest seem to be compressed here and there, which
// ShockViscosity::speed counts as a faster signal; gas that sleeps has no round-off. Where gas at
// rest is the hottest of all, as behind the diaphragm of a tube, it rules the steps, and they
// differ, with results that differ as they do for other time steps.
#include <memory>
#include <vector>

#include "core/group.hpp"
#include "core/sort.hpp"

namespace brisance {

template <class G>
class Sleep {
 public:
  static constexpr int D = G::dim;
  static constexpr int margin = 6;  ///< [cells]
  /// What counts as rest: pressure within this share of that at the start, velocity below this
  /// share of sqrt(p / rho). [-]
  static constexpr double tolerance = 1e-9;

  using Groups = std::vector<std::unique_ptr<Group<G>>>;

  /// Whether the scene asks for it.
  bool on() const { return asleep_.extent(0) > 0; }
  /// Whether any cell sleeps.
  bool any() const { return count() > 0; }
  /// Points that sleep, in all or of a group.
  long count() const;
  long count(const Group<G>& group) const;
  /// Momentum given to nodes that hold still, beyond what the pressure at rest balances, so far.
  /// [N s]
  const Vec<D>& impulse() const { return impulse_; }
  std::size_t bytes() const;

  /// Once, when the points are sorted and have their pressure: puts to sleep what may. The groups
  /// that may are marked; points longer than `split_length` cells, unless 0, stay awake: they will
  /// be split.
  void lull(const Groups& groups, const std::vector<bool>& may, const Grid<G>& grid,
            double split_length, Sorter<G>& sorter);
  /// At the end of a step: wakes what is near to anything not at rest.
  void wake(const Groups& groups, Sorter<G>& sorter);

  /// What all others have summed, and what the points that sleep press with at the nodes [N]; and,
  /// in column D, the volume of their cells.
  void press(const Accumulator& sums) const;
  void fill(const Accumulator& sums) const;
  /// Sums of the points at the nodes, N V. [m^D]; empty unless any sleep
  const Table<double>& volume() const { return volume_; }
  /// Zeroes momentum or force at nodes that hold still, and returns their sum.
  Vec<D> hold(const Table<double>& sums) const;
  /// What a force so held has given in a step.
  void note(const Vec<D>& force, double dt) {
    for (int d = 0; d < D; ++d) impulse_[d] += dt * force[d];
  }
  /// Of the group's points that sleep. They limit the step as if awake.
  Signals signals(const Group<G>& group) const;

  /// What outlives a step beside the points of each_part(), for restart: 1 for cells that sleep,
  /// and for those that are known to be disturbed.
  const Array<int>& asleep() const { return asleep_; }
  const Array<int>& disturbed() const { return disturbed_; }
  /// Calls f(group, points) for the points of each group that may sleep.
  template <class F>
  void each_part(const F& f) {
    for (Part& part : parts_) f(*part.group, part.points);
  }
  /// After all that has been set to what it was: finds what follows from it.
  void resume(const Vec<D>& impulse, Sorter<G>& sorter);

  /// Calls f() with the group's points that are awake and, if any sleep, with those in their place.
  template <class F>
  void for_all(Group<G>& group, const F& f) const {
    f();
    for (const Part& part : parts_)
      if (part.group == &group && part.points.count > 0) in_place(part, f);
  }

 private:
  struct Part {
    Group<G>* group;
    Particles<G> points;
    Signals signals;
  };
  std::vector<Part> parts_;
  Lattice<D> lattice_;
  Array<int> asleep_;     ///< 1 for cells that sleep
  Array<int> disturbed_;  ///< 1 for cells where something was not at rest
  Array<int> fresh_;      ///< 1 for those of them found in this step
  Array<int> owner_;      ///< of cells at rest at the start: number of their group, else -1
  Table<double> rest_;    ///< pressure and p / rho of those cells at the start [Pa], [m^2/s^2]
  Table<double> force_, volume_;  ///< of points that sleep, at the nodes
  Vec<D> impulse_;

  template <class F>
  static void in_place(const Part& part, const F& f) {
    const Particles<G> awake = part.group->particles;
    part.group->particles = part.points;
    f();
    part.group->particles = awake;
  }
  Signals signals_of(Group<G>& group) const;
  int disturb(const Particles<G>& points, int group);
  int wake_cells();
  int move(Particles<G>& from, Particles<G>& to, const Group<G>& group, int asleep,
           Sorter<G>& sorter) const;
  void settle();
};

}  // namespace brisance
