#pragma once
// What is known of whole cells: how much of them is filled, and how smooth the flow is around them.
#include "core/grid.hpp"

namespace brisance {

/// grid.cell <- mean strain rates of cells that hold fluid, from grid.before, and filled volumes,
/// out of columns D (fluids) and D + 1 (solids) of the sums. `beside`: see Transfer.
template <class G>
void describe_cells(const Grid<G>& grid, const Accumulator& sums, double beside);

/// The greatest rate at which the volume of a cell, as its centre has it, changes at the start of
/// the step, of cells whose nodes all have mass. [1/s]
template <class G>
double fastest_strain(const Grid<G>& grid);

/// grid.scale <- what fills a cell whose neighbours all hold particles: (h^D - V of solids) / V of
/// fluids, at most doubled or, without solids, halved; elsewhere 1.
template <class G>
void scale_cells(const Grid<G>& grid);

/// grid.smoothness <- 1 where the strain rates of a cell vary linearly to its neighbours, 0 in a
/// shock. Along each direction psi = max(0, min((r- + r+)/2, 2 r-, 2 r+, 1)), r the neighbours'
/// rates over the cell's; the directions count by the size of their rates. (Christensen 1990)
template <class G>
void limit_cells(const Grid<G>& grid);

}  // namespace brisance
