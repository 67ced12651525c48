#pragma once
// The nodal and cell fields of one step. Nothing here survives a step.
#include <vector>

#include "core/accumulator.hpp"
#include "core/boundary.hpp"
#include "core/lattice.hpp"

namespace brisance {

/// The velocity classes of fluids and of solids where both share the grid; alone, either has the
/// first.
constexpr int fluid_class = 0, solid_class = 1;

/// Which optional fields a scheme needs.
struct GridNeeds {
  int classes = 1;          ///< velocity fields: one for each class of materials that share nodes
  bool quadrature = false;  ///< cell quadrature: volume scale of each cell
  bool limiter = false;     ///< limited viscosity: smoothness of the flow in each cell
};

template <class G>
struct Grid {
  static constexpr int D = G::dim;

  Lattice<D> lattice;
  Boundaries<D> boundaries;
  double time = 0;  ///< at the start of the step [s]

  Table<double> before;            ///< velocity at the start of the step [m/s]; column D: mass [kg]
  Table<double> after;             ///< velocity at its end [m/s]
  std::vector<Table<double>> own;  ///< like `before`, of one class each; one class: the same table
  std::vector<Table<double>> image_mass;  ///< of each class, beyond walls: see fold() [kg]
  /// Where there are fluids: strain rate along each direction at the centre [1/s]; column D: their
  /// volume [m^D]; column D + 1, where they meet solids: volume of solids.
  Table<double> cell;
  Table<double> scale;       ///< by what the volumes in a cell are scaled to fill it [-]
  Table<double> smoothness;  ///< 1 where the flow is smooth, 0 in a shock [-]

  Grid() = default;
  Grid(const Lattice<D>& lattice_, const Boundaries<D>& boundaries_, const GridNeeds& needs)
      : lattice(lattice_),
        boundaries(boundaries_),
        before("velocity before", lattice.size, D + 1),
        after("velocity after", lattice.size, D) {
    if (needs.classes == 1)
      own.push_back(before);
    else
      for (int c = 0; c < needs.classes; ++c)
        own.emplace_back("class velocity", lattice.size, D + 1);
    image_mass.resize(needs.classes);
    if (boundaries.images_beyond_walls())
      for (auto& mass : image_mass) mass = Table<double>("image mass", lattice.size, D);
    if (needs.quadrature || needs.limiter)
      cell = Table<double>("cell", lattice.size, D + (needs.classes == 1 ? 1 : 2));
    if (needs.quadrature) scale = Table<double>("scale", lattice.size, 1);
    if (needs.limiter) smoothness = Table<double>("smoothness", lattice.size, 1);
  }

  /// Whether cells may hold fluids and solids.
  bool mixed() const { return own.size() > 1; }
  /// Whether anybody asks for `cell`, and of how many classes it tells the volumes.
  bool knows_cells() const { return cell.extent(0) > 0; }
  int volumes() const { return knows_cells() ? static_cast<int>(own.size()) : 0; }

  /// Memory of all fields. [B]
  std::size_t bytes() const {
    std::size_t doubles =
        before.span() + after.span() + cell.span() + scale.span() + smoothness.span();
    for (const auto& mass : image_mass) doubles += mass.span();
    if (own.size() > 1)
      for (const auto& field : own) doubles += field.span();
    return doubles * sizeof(double);
  }
};

}  // namespace brisance
