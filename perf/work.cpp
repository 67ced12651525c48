// Operations and bytes of a particle-step, counted by hand from the formulas of the method and not
// from the program, so that they stay when the program gets faster.
//
// An addition, product, division, root, comparison each count as one, a fused multiply-add as two.
// Each loop over the nodes of a particle finds its weights anew. What is done at a node or in a
// cell falls on the particles of a cell. Only what a step does to every particle counts: sorting,
// splitting, ends of the domain do not. Of the instructions of a scalar build, counted one by one
// (callgrind), the program executes 1.5 to 2.5 times as many: 2.2 paper, 2.0 fast, 2.5
// balanced, 1.7 accurate, 1.9 paper with quadratic shapes, 1.5 and 1.6 steel.
//
// Bytes are what no program can do without: each value of a particle that outlives a step is read
// and written once (mass: read), 8 bytes each. Nodes, and what one loop leaves to the next, may
// stay in caches.
#include "perf/work.hpp"

namespace brisance::perf {
namespace {

constexpr double per_cell = 4;

/// A shape in two directions.
struct Shape {
  double nodes;
  double weights;    ///< place in the cell 6; along x and y; their products
  double gradients;  ///< slopes along x and y; their products with weights
  double arms;       ///< from the particle to nodes along x and y
};
constexpr Shape linear{4, 6 + 2 + 4, 8, 0}, quadratic{9, 6 + 18 + 9, 8 + 18, 12};

// ---- Loops over nodes ----
/// N m, its sum; N m v and its sum along x and y.
constexpr double momentum(const Shape& s) { return s.weights + 6 * s.nodes; }
/// The same of v + C r.
constexpr double affine_momentum(const Shape& s) { return s.weights + s.arms + 14 * s.nodes; }
/// Four components of sum v grad N.
constexpr double gradient(const Shape& s) { return s.weights + s.gradients + 8 * s.nodes; }
/// With N r / inertia in place of grad N.
constexpr double mls_gradient(const Shape& s) { return s.weights + s.arms + 12 * s.nodes; }
/// Some components of sum N v.
constexpr double gather(const Shape& s, int components) {
  return s.weights + 2 * components * s.nodes;
}
/// V p; its product with grad N and the sum along x and y.
constexpr double pressure_force(const Shape& s) {
  return 1 + s.weights + s.gradients + 4 * s.nodes;
}
constexpr double mls_pressure_force(const Shape& s) { return 1 + s.weights + s.arms + 8 * s.nodes; }
/// V sigma; two products for each direction.
constexpr double tensor_force(const Shape& s) { return 4 + s.weights + s.gradients + 8 * s.nodes; }
constexpr double mls_tensor_force(const Shape& s) { return 4 + s.weights + s.arms + 12 * s.nodes; }
/// w a, N w, N w a and their sums, then the mean at nodes, of `count` means.
constexpr double scatter_means(const Shape& s, int count) {
  return s.weights + count * (1 + 4 * s.nodes + 1 / per_cell);
}

// ---- Once a particle ----
constexpr double strain = 10;         // D, trace, growth of the volume, densities
constexpr double signals = 22;        // rho, c, b + (b^2 + c^2)^1/2, |v|, greatest
constexpr double solid_signals = 8;   // rho, c, |v|, greatest
constexpr double move = 4;            // x + u dt
constexpr double stretch = 8;         // edges of a particle with the strain
constexpr double neumann = 13;        // q of von Neumann and Richtmyer; 4 more for c
constexpr double kurapatenko = 19;    // its q
constexpr double gas_energy = 16;     // trapezoid rule in closed form, p, p + q
constexpr double turn = 27;           // R and R sigma R^T
constexpr double von_mises = 84;      // trial 17, J2 and limit 19, return 18, plastic work 30
constexpr double work_of_stress = 9;  // sigma : D V dt / m
constexpr double receive = 23;        // volume, energy with its floor shared in the cell, p

// ---- Once a node or cell ----
constexpr double velocity_of_nodes = 2, kick = 6, difference = 2;
constexpr double nodes_of_midpoint = (velocity_of_nodes + kick) / per_cell;
constexpr double cell_volume = 1;                                                // summed
constexpr double cell_rates = 16 / per_cell, smooth_cell_rates = 64 / per_cell;  // along x and y
constexpr double fill_of_cells = 12 / per_cell;  // is it full, with its neighbours?
constexpr double smoothness = 22 / per_cell;     // limiter along x and y
constexpr double gradient_in_cell = 16 / per_cell;
constexpr double force_in_cell = 2 + 16 / per_cell;

/// FLIP with the heat that it leaves: changes, velocities, and the squares of both, with weights
/// that are known.
constexpr double flip_with_heat(const Shape& s) {
  return 12 * s.nodes + 16 * s.nodes / per_cell + 2 * 15 + 9 + 5;
}
/// APIC: v and C, then the squares of what v + C r misses, before and after.
constexpr double apic_with_heat(const Shape& s) {
  return 12 * s.nodes + 6 + 30 * s.nodes + 5 + 8 * s.nodes / per_cell;
}

/// Relaxations of a gas.
constexpr double volume_relaxation(const Shape& s) {
  return scatter_means(s, 1) + gather(s, 1) + 8;
}
/// All three: volume with the first mean of the pressure, the second and that of the exchange,
/// energies with the heat.
constexpr double relaxations(const Shape& s) {
  return scatter_means(s, 1) + gather(s, 2) + 8 + 2 * (scatter_means(s, 1) + gather(s, 1) + 1) +
         scatter_means(s, 2) + gather(s, 2) + 60;
}

/// Values that outlive a step, read and written: place, velocity, volume; mass read.
constexpr double common_values = 2 * (2 + 2 + 1) + 1;
constexpr double edges = 2 * 2, affine = 2 * 4, energy = 2, pressure = 2;
constexpr double steel_state = 2 * (4 + 3);  // stress; plastic strain, plastic work, energy

constexpr Work work(double flops, double values) { return {flops, 8 * values}; }

Work paper(const Shape& s) {
  const double nodes = (2 * velocity_of_nodes + kick + difference) / per_cell,
               accelerate = gather(s, 2) + 2,
               move_and_strain = gradient(s) + 2 * 2 * s.nodes + move;  // weights of one place
  return work(2 * momentum(s) + pressure_force(s) + accelerate + move_and_strain + signals +
                  strain + neumann + 4 + gas_energy + nodes,
              common_values + energy + pressure);
}

/// Stress at cells, compatible energy; `q` and relaxations per step are those of the preset.
Work by_cells(double q, double relaxation) {
  const double half_step = strain + q + 4 + gas_energy,
               finish = linear.weights + flip_with_heat(linear) + gradient_in_cell +
                        work_of_stress + 2 * 2 * linear.nodes + move + stretch + receive;
  return work(momentum(linear) + gradient_in_cell + signals + cell_volume + fill_of_cells +
                  half_step + force_in_cell + nodes_of_midpoint + finish + relaxation,
              common_values + energy + edges);
}

Work accurate() {
  const Shape& s = quadratic;
  const double half_step = strain + kurapatenko + 4 + gas_energy,
               finish = mls_gradient(s) + apic_with_heat(s) + work_of_stress + 2 * 2 * s.nodes +
                        move + stretch + receive,
               relaxation = relaxations(s);
  return work(affine_momentum(s) + mls_gradient(s) + signals + cell_volume + smooth_cell_rates +
                  smoothness + half_step + mls_pressure_force(s) + nodes_of_midpoint + finish +
                  relaxation,
              common_values + energy + edges + affine);
}

}  // namespace

Work gas_work(const std::string& preset, bool quadratic_) {
  if (preset == "paper") return paper(quadratic_ ? quadratic : linear);
  if (preset == "fast") return by_cells(neumann, volume_relaxation(linear) / 4);
  if (preset == "balanced")
    return by_cells(kurapatenko, cell_rates + smoothness + relaxations(linear) / 2);
  return accurate();
}

Work steel_work(bool quadratic_) {
  const double laws = 2 * (strain + turn + von_mises) + 2;
  const double rest = solid_signals + nodes_of_midpoint + work_of_stress + move + laws;
  const double values = common_values + steel_state;
  if (quadratic_) {
    const Shape& s = quadratic;
    return work(affine_momentum(s) + 2 * mls_gradient(s) + mls_tensor_force(s) + apic_with_heat(s) +
                    2 * 2 * s.nodes + rest,
                values + affine);
  }
  const Shape& s = linear;
  return work(
      momentum(s) + 2 * gradient(s) + tensor_force(s) + flip_with_heat(s) + 2 * 2 * s.nodes + rest,
      values);
}

}  // namespace brisance::perf
