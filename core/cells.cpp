#include "core/cells.hpp"

#include "core/geometry.hpp"

namespace brisance {

template <class G>
void average_cells(const Grid<G>& grid, const Accumulator& sums) {
  constexpr int D = G::dim;
  const auto cell = grid.cell, total = sums.total;
  const bool mixed = grid.mixed();
  if (mixed) fold_cells(total, D + 1, grid.lattice, grid.boundaries);
  Kokkos::parallel_for(
      "average cells", Kokkos::RangePolicy<Space>(0, grid.lattice.size),
      KOKKOS_LAMBDA(const int c) {
        const double volume = total(c, D);
        for (int d = 0; d < D; ++d) cell(c, d) = volume > 0 ? total(c, d) / volume : 0;
        cell(c, D) = volume;
        if (mixed) cell(c, D + 1) = total(c, D + 1);
      });
  fill_cells(cell, D, grid.lattice, grid.boundaries);
}

template <class G>
void scale_cells(const Grid<G>& grid) {
  constexpr int D = G::dim, around = power(3, D);
  const auto cell = grid.cell, scale = grid.scale;
  const Lattice<D> lattice = grid.lattice;
  const double full_volume = lattice.cell_volume();
  const bool mixed = grid.mixed();
  Kokkos::parallel_for(
      "scale cells", Kokkos::RangePolicy<Space>(0, lattice.size), KOKKOS_LAMBDA(const int c) {
        scale(c, 0) = 1;
        if (!(cell(c, D) > 0)) return;
        int i[D];
        lattice.coordinates(c, i);
        for (int d = 0; d < D; ++d)
          if (i[d] < 0 || i[d] >= lattice.cells[d]) return;
        for (int k = 0; k < around; ++k) {
          int neighbour = c;
          for (int d = 0; d < D; ++d) neighbour += (k / power(3, d) % 3 - 1) * lattice.stride[d];
          if (!(cell(neighbour, D) > 0 || (mixed && cell(neighbour, D + 1) > 0))) return;
        }
        const double solid = mixed ? cell(c, D + 1) : 0;
        scale(c, 0) = clamp((full_volume - solid) / cell(c, D), solid > 0 ? 0 : 0.5, 2);
      });
}

template <class G>
void limit_cells(const Grid<G>& grid) {
  constexpr int D = G::dim;
  const auto cell = grid.cell, smoothness = grid.smoothness;
  const Lattice<D> lattice = grid.lattice;
  Kokkos::parallel_for(
      "limit cells", Kokkos::RangePolicy<Space>(0, lattice.size), KOKKOS_LAMBDA(const int c) {
        smoothness(c, 0) = 0;
        int i[D];
        lattice.coordinates(c, i);
        for (int d = 0; d < D; ++d)
          if (i[d] < 0 || i[d] >= lattice.cells[d]) return;
        double sum = 0, weights = 0;
        for (int d = 0; d < D; ++d) {
          const double here = cell(c, d);
          if (here == 0) continue;
          const double below = cell(c - lattice.stride[d], d) / here;
          const double above = cell(c + lattice.stride[d], d) / here;
          const double psi = least(least(0.5 * (below + above), 2 * below), least(2 * above, 1));
          sum += fabs(here) * most(psi, 0);
          weights += fabs(here);
        }
        smoothness(c, 0) = weights > 0 ? sum / weights : 0;
      });
}

#define BRISANCE_CELLS(G)                                             \
  template void average_cells<G>(const Grid<G>&, const Accumulator&); \
  template void scale_cells<G>(const Grid<G>&);                       \
  template void limit_cells<G>(const Grid<G>&);
BRISANCE_CELLS(Line)
BRISANCE_CELLS(PlaneStrain)
#undef BRISANCE_CELLS

}  // namespace brisance
