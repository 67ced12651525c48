#pragma once
// States and scenes for tests: small, made in one line, with nothing special about them.
#include <memory>
#include <string>
#include <vector>

#include "core/geometry.hpp"
#include "core/step.hpp"
#include "drivers/simulation.hpp"

namespace brisance::test {

/// A perfect gas (gamma 1.4) in a box of square cells of size 0.5, at random: places within the
/// cells (as many particles in each, so that all are full), volumes, densities, pressures,
/// velocities of half the sound speed at most.
struct RandomGas {
  TransferChoice transfer;
  Side side = Side::periodic;  ///< all ends of the box
  bool midpoint = true;
  double damping = 0;
  int cells = 6, per_cell = 4;
  int groups = 1;   ///< materials; particles go to them in turn
  int classes = 1;  ///< group k has the velocity class k % classes
  bool newtonian = false;
  bool solids = false;  ///< odd groups are elastic: give two classes
  TransferChoice solid_transfer = {"quadratic", "MLS", "particle"};
  std::string shock = "none";   ///< form of the artificial viscosity
  double pressure_range = 0.5;  ///< pressures lie within 1 +- this [Pa]
  double velocity_range = 0.5;  ///< [m/s]
  bool passing_lasts = false;   ///< so that gradients and work can be set and looked at
  bool regular = false;         ///< places and volumes of a lattice, density 1, in place of random
  std::uint32_t seed = 1;
};

template <class G>
State<G> random_gas(const RandomGas& of);

/// One step as the drivers do it, a third of what is stable by CFL = 1. Returns dt [s].
template <class G>
double step(State<G>& state);

/// Adds stages to a sweep, f(sweep), and runs it.
template <int D, class F>
void sweep(const Lattice<D>& lattice, const F& f) {
  Sweep<D> stages(lattice);
  f(stages);
  stages.run();
}

/// Sums over all groups; momentum with what walls have received.
template <class G>
Totals totals(const State<G>& state);

/// Every choice that make_transfer() has, and its name for messages.
std::vector<TransferChoice> every_transfer();
std::string name_of(const TransferChoice& choice);

/// The volume of all particles. [m^D]
template <class G>
double volume(const State<G>& state);

/// A checked scene of `dim` directions: a perfect gas (gamma 1.4) of density and pressure 1 at rest
/// in cells of size 0.1, 20 along x and 1 along y, for a time of 0.1. There are two bodies of it,
/// "first" in the box x < 1 and "rest". Assignments are those of the option --set.
List scene(int dim, const std::vector<std::string>& assignments = {});

/// Of a scene: stiffness and density about those of the gas.
List elastic_material();

/// The scene at its end.
std::unique_ptr<Simulation> simulated(const List& scene, const ExactSolution* exact = nullptr);

/// How far the columns of two tables, or of one and its mirror image about x = middle, are apart,
/// each over the largest value in it; particles are matched by place along x, then y.
double distance(const ParticleTable& a, const ParticleTable& b);
ParticleTable mirrored(ParticleTable table, int direction, double middle);
ParticleTable transposed(ParticleTable table);

}  // namespace brisance::test
