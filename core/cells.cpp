#include "core/cells.hpp"

#include "core/geometry.hpp"
#include "core/tile.hpp"

namespace brisance {
namespace {

/// Calls f(bundle) for the cells inside the domain, whose neighbours it may read. One by one, with
/// the place of each found from its number, they took four times as long.
template <int D, class F>
void for_inner_cells(const char* name, const Lattice<D>& lattice, const F& f) {
  static_assert(D < 3, "planes of lines are missing");
  constexpr int length = 256;
  const int pieces = (lattice.cells[0] + length - 1) / length,
            lines = D == 1 ? 1 : lattice.cells[1];
  Kokkos::parallel_for(
      name, Kokkos::RangePolicy<Space>(0, pieces * lines), KOKKOS_LAMBDA(const int k) {
        int i[D] = {k % pieces * length}, reach = Wide::lanes;
        if constexpr (D == 2) i[1] = k / pieces;
        for (int d = 0; d < D; ++d) reach += lattice.stride[d];
        int c = lattice.index(i);
        const int rest = lattice.cells[0] - i[0], end = c + (rest < length ? rest : length);
        for (; c + Wide::lanes <= end; c += Wide::lanes) f(Bundle<true>{c});
        if (c < end) f(Bundle<false, true>{c, end - c, c + reach <= lattice.size});
      });
}

template <int D>
struct ScaleCells {
  Lattice<D> lattice;
  Table<double> cell, scale;
  double full_volume;
  int solids;  ///< the column of their volume; where there are none, that of fluids

  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const Bundle& c) const {
    const double *fluid_volume = &cell(0, D), *solid_volume = &cell(0, solids);
    Wide emptiest = full_volume;
    for (int k = 0; k < power(3, D); ++k) {
      int there = 0;
      for (int d = 0; d < D; ++d) there += (k / power(3, d) % 3 - 1) * lattice.stride[d];
      emptiest = least(emptiest, c.read(fluid_volume + there) + c.read(solid_volume + there));
    }
    const Wide fluid = c.read(fluid_volume), solid = solids > D ? c.read(solid_volume) : Wide(0);
    const WideBool holds = fluid > Wide(0);
    const Wide filled = clamp((full_volume - solid) / select(holds, fluid, 1),
                              select(solid > Wide(0), Wide(0), 0.5), 2);
    c.write(&scale(0, 0), select(holds && emptiest > Wide(0), filled, 1));
  }
};

template <int D>
struct LimitCells {
  Lattice<D> lattice;
  Table<double> cell, smoothness;

  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const Bundle& c) const {
    Wide sum, weights;
    for (int d = 0; d < D; ++d) {
      const double* rate = &cell(0, d);
      const Wide here = c.read(rate), sign = select(here < Wide(0), Wide(-1), 1),
                 below = sign * c.read(rate - lattice.stride[d]),
                 above = sign * c.read(rate + lattice.stride[d]), size = sign * here;
      sum += most(least(least(0.5 * (below + above), 2 * below), least(2 * above, size)), 0);
      weights += size;
    }
    const WideBool moves = weights > Wide(0);
    c.write(&smoothness(0, 0), select(moves, sum / select(moves, weights, 1), 0));
  }
};

}  // namespace

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
  const int solids = grid.mixed() ? G::dim + 1 : G::dim;
  for_inner_cells(
      "scale cells", grid.lattice,
      ScaleCells<G::dim>{grid.lattice, grid.cell, grid.scale, grid.lattice.cell_volume(), solids});
}

template <class G>
void limit_cells(const Grid<G>& grid) {
  for_inner_cells("limit cells", grid.lattice,
                  LimitCells<G::dim>{grid.lattice, grid.cell, grid.smoothness});
}

#define BRISANCE_CELLS(G)                                             \
  template void average_cells<G>(const Grid<G>&, const Accumulator&); \
  template void scale_cells<G>(const Grid<G>&);                       \
  template void limit_cells<G>(const Grid<G>&);
BRISANCE_CELLS(Line)
BRISANCE_CELLS(PlaneStrain)
#undef BRISANCE_CELLS

}  // namespace brisance
