#pragma once
// The host-side face of the particles of one material. One virtual call per group and stage;
// inside, the law is inlined (materials/group_impl.hpp).
#include <memory>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "core/particles.hpp"
#include "core/transfer.hpp"

namespace brisance {

/// What a state variable is called, for output, restart and export.
struct FieldName {
  std::string name, unit;
};

/// Sums over particles. Energies in J, per metre (plane) or square metre (line).
struct Totals {
  double mass = 0, momentum[3] = {}, kinetic = 0, internal = 0;
  /// Sums of m |v| along each direction and in all: what parts that fly apart have, though their
  /// momenta cancel. [N s]
  double absolute_momentum[3] = {}, motion = 0;
  Energies work;  ///< parts of the internal energy of solids; the rest is heat
  double total() const { return kinetic + internal; }
  KOKKOS_INLINE_FUNCTION Totals& operator+=(const Totals& t) {
    mass += t.mass;
    for (int d = 0; d < 3; ++d) {
      momentum[d] += t.momentum[d];
      absolute_momentum[d] += t.absolute_momentum[d];
    }
    motion += t.motion;
    kinetic += t.kinetic;
    internal += t.internal;
    work.add(t.work, 1);
    return *this;
  }
};

/// How a material's steps are done, from the scheme of the scene.
struct GroupScheme {
  bool midpoint = true;  ///< compatible energy with half-step stress; else MUSL
  double damping =
      0;  ///< FLIP: share of velocity drawn to the grid's in a sound crossing of a cell
  double stress_relaxation =
      0;  ///< solids: share of the stress that no node sees, lost in a sound crossing of a cell
  bool printed_work =
      false;  ///< MUSL: the work divided by the new density, as printed in (A.19), (A.22)
  double strain_length =
      0;  ///< rate of volume change times this counts as a signal; limits it in a step [m]
};

/// How fast news travels. [m/s]
struct Signals {
  double over_grid = 0;  ///< with the velocity of the material: limits the time step
  double in_matter = 0;  ///< relative to the material
};

template <class G>
class Group {
 public:
  std::string label;  ///< the material's name in the scene
  int velocity_class = 0;
  GroupScheme scheme;
  Particles<G> particles;
  std::unique_ptr<Transfer<G>> transfer;
  Signals fastest;         ///< in the step under way
  bool in_motion = false;  ///< whether the last step moved most particles to other places, and none
                           ///< were split or left: how the next sorts them
  Array<double> debt;  ///< of each bin: energy that its fluids were left with and owe [J]; may be
                       ///< empty, and is the same for all groups

  virtual ~Group() = default;
  /// How often a state had to be held at a lower bound, so far.
  long floors() const {
    std::int64_t count = 0;
    Kokkos::deep_copy(count, floors_);
    return static_cast<long>(count);
  }
  void set_floors(long count) { Kokkos::deep_copy(floors_, std::int64_t{count}); }
  virtual Stress stress() const = 0;
  virtual bool fluid() const = 0;
  /// Whether core/relaxation corrects it: a fluid whose pressure depends on its energy.
  virtual bool relaxes() const { return false; }
  virtual std::vector<FieldName> history_fields() const = 0;

  /// Makes room for the particles and their columns; what the scheme of the whole step asks for
  /// comes in `needs`.
  virtual void allocate(int capacity, ColumnNeeds needs) = 0;
  /// State variables of fresh particles from begin on, whose stress column holds a pressure [Pa],
  /// or a specific energy [J/kg].
  virtual void initialise(int begin, bool from_energy) = 0;
  /// The stress that belongs to density and state variables, before the first step.
  virtual void start() = 0;

  // Stages of the step, added to a sweep.

  /// From the gradients; told by signals() when the sweep has run.
  virtual void find_signals(Sweep<G::dim>& in) = 0;
  virtual Signals signals() const = 0;
  virtual void set_signals(const Lattice<G::dim>& lattice, const Signals& fastest) = 0;
  /// Stress <- the stress half a step on, with the gradient at the start of the step.
  virtual void half_step(Sweep<G::dim>& in, const Grid<G>& grid, double dt) = 0;
  /// State at the end of the step from gradient and work (midpoint).
  virtual void finish(Sweep<G::dim>& in, const Grid<G>& grid, double dt) = 0;
  /// State at the end of the step from the gradient alone (MUSL).
  virtual void update(Sweep<G::dim>& in, const Grid<G>& grid, double dt) = 0;

  /// Fluids only, for core/relaxation: see there what the scratch columns hold.
  virtual void correct_volume(Sweep<G::dim>& /*in*/, double /*rate*/) {}
  virtual void load_pressure(Sweep<G::dim>& /*in*/) {}
  virtual void propose_exchange(Sweep<G::dim>& /*in*/, double /*rate*/, double /*dt*/) {}
  virtual void exchange_volume(Sweep<G::dim>& /*in*/, bool /*exchanges*/, double /*heat*/) {}
  virtual void exchange_energy(Sweep<G::dim>& /*in*/, bool /*exchanges*/, bool /*conducts*/) {}
  /// Solids only, for core/stress_relaxation: scratch <- the direct stresses and, last, the weight;
  /// and the stresses without the residuals that scratch holds by then.
  virtual void load_stress(Sweep<G::dim>& /*in*/) {}
  virtual void relax_stress(Sweep<G::dim>& /*in*/, double /*dt*/) {}

  /// Sums over the particles begin .. end.
  virtual Totals totals(int begin, int end, double affine_inertia) const = 0;
  /// Pressure and, for fluids, specific internal energy of each particle, for output. [Pa], [J/kg]
  virtual void report(const Array<double>& pressure, const Array<double>& energy) const = 0;

 protected:
  Kokkos::View<std::int64_t, Space> floors_{"floors"};
};

}  // namespace brisance
