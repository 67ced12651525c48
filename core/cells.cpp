#include "core/cells.hpp"

#include "core/geometry.hpp"
#include "core/pieces.hpp"
#include "core/stencil.hpp"

namespace brisance {
namespace {

/// d v_d / d x_d at the centres of cells, v being a nodal field. [1/s]
template <class G, class Bundle>
KOKKOS_FORCEINLINE_FUNCTION Wide rate_along(const Lattice<G::dim>& lattice,
                                            const Table<double>& velocity, const Bundle& c, int d) {
  using N = Around<G::dim, 2>;
  Wide sum;
  for (int k = 0; k < N::count; ++k)
    sum += centre_gradient<G>(k, d) * c.read(&velocity(N::offset(lattice, k), d));
  return lattice.per_h * sum;
}

/// The same, of the field that a spline makes of the nodes: from four of them along each direction.
/// `beside` is the weight of a node at the next one.
template <class G, class Bundle>
KOKKOS_FORCEINLINE_FUNCTION Wide smooth_rate_along(const Lattice<G::dim>& lattice,
                                                   const Table<double>& velocity, const Bundle& c,
                                                   int d, double beside) {
  using N = Around<G::dim, 4>;
  const double slope[] = {-beside, 3 * beside - 1, 1 - 3 * beside, beside},
               mean[] = {0.5 * beside, 0.5 - 0.5 * beside, 0.5 - 0.5 * beside, 0.5 * beside};
  int first = 0;
  for (int e = 0; e < G::dim; ++e) first -= lattice.stride[e];
  Wide sum;
  for (int k = 0; k < N::count; ++k) {
    double weight = 1;
    for (int e = 0; e < G::dim; ++e) weight *= (e == d ? slope : mean)[N::digit(k, e)];
    sum += weight * c.read(&velocity(0, d) + (first + N::offset(lattice, k)));
  }
  return lattice.per_h * sum;
}

template <class G>
struct DescribeCells {
  static constexpr int D = G::dim;
  Lattice<D> lattice;
  Table<double> velocity, sums, cell;
  int classes;
  double beside;

  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const Bundle& c) const {
    const WideBool holds = c.read(&sums(0, D)) > Wide(0);
    for (int d = 0; d < D; ++d) {
      const Wide rate = beside > 0 ? smooth_rate_along<G>(lattice, velocity, c, d, beside)
                                   : rate_along<G>(lattice, velocity, c, d);
      c.write(&cell(0, d), select(holds, rate, 0));
    }
    for (int k = D; k < D + classes; ++k) c.write(&cell(0, k), c.read(&sums(0, k)));
  }
};

template <class G>
struct FastestStrain {
  static constexpr int D = G::dim;
  Lattice<D> lattice;
  Table<double> velocity;  ///< column D: mass

  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION Wide operator()(const Bundle& c) const {
    using N = Around<D, 2>;
    Wide rate, lightest = c.read(&velocity(0, D));
    for (int d = 0; d < D; ++d) rate += rate_along<G>(lattice, velocity, c, d);
    for (int k = 1; k < N::count; ++k)
      lightest = least(lightest, c.read(&velocity(N::offset(lattice, k), D)));
    return select(lightest > Wide(0), fabs(rate), 0);
  }
};

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
void describe_cells(const Grid<G>& grid, const Accumulator& sums, double beside) {
  constexpr int D = G::dim;
  if (grid.mixed()) fold_cells(sums.total, D + 1, grid.lattice, grid.boundaries);
  for_each(
      "describe cells", InnerCells<G::dim>{grid.lattice},
      DescribeCells<G>{grid.lattice, grid.before, sums.total, grid.cell, grid.volumes(), beside});
  fill_cells(grid.cell, D, grid.lattice, grid.boundaries);
}

template <class G>
double fastest_strain(const Grid<G>& grid) {
  return greatest_of("fastest strain", InnerCells<G::dim>{grid.lattice},
                     FastestStrain<G>{grid.lattice, grid.before});
}

template <class G>
void scale_cells(const Grid<G>& grid) {
  const int solids = grid.mixed() ? G::dim + 1 : G::dim;
  for_each(
      "scale cells", InnerCells<G::dim>{grid.lattice},
      ScaleCells<G::dim>{grid.lattice, grid.cell, grid.scale, grid.lattice.cell_volume(), solids});
}

template <class G>
void limit_cells(const Grid<G>& grid) {
  for_each("limit cells", InnerCells<G::dim>{grid.lattice},
           LimitCells<G::dim>{grid.lattice, grid.cell, grid.smoothness});
}

#define BRISANCE_CELLS(G)                                                      \
  template void describe_cells<G>(const Grid<G>&, const Accumulator&, double); \
  template double fastest_strain<G>(const Grid<G>&);                           \
  template void scale_cells<G>(const Grid<G>&);                                \
  template void limit_cells<G>(const Grid<G>&);
BRISANCE_CELLS(Line)
BRISANCE_CELLS(PlaneStrain)
#undef BRISANCE_CELLS

}  // namespace brisance
