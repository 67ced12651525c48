// What cells are told by their nodes.
#include "core/cells.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "as_types.hpp"
#include "core/geometry.hpp"

namespace brisance {
namespace {

template <class G>
class Cells : public testing::Test {
 public:
  static constexpr int D = G::dim;

  /// Nodes of mass 1 with the velocity v_d = a_d x_d + b x_(other), a = 3, -0.5, and cells with one
  /// unit of volume.
  static Grid<G> sheared() {
    double origin[D];
    int cells[D];
    Boundaries<D> free;
    for (int d = 0; d < D; ++d) {
      origin[d] = -0.7;
      cells[d] = 9 + d;
      free.side[d][0] = free.side[d][1] = Side::free;
    }
    GridNeeds needs;
    needs.quadrature = needs.limiter = true;
    Grid<G> grid(Lattice<D>(origin, cells, 0.25), free, needs);
    for (int n = 0; n < grid.lattice.size; ++n) {
      int i[D];
      grid.lattice.coordinates(n, i);
      for (int d = 0; d < D; ++d)
        grid.before(n, d) = 0.25 * (rate(d) * i[d] + (D > 1 ? 7 * i[D - 1 - d] : 0));
      grid.before(n, D) = 1;
    }
    return grid;
  }
  static double rate(int d) { return d == 0 ? 3 : -0.5; }
  static double strain() { return D == 1 ? 3 : 2.5; }
};
using Geometries = testing::Types<Line, PlaneStrain>;
TYPED_TEST_SUITE(Cells, Geometries);

TYPED_TEST(Cells, HaveTheRatesOfALinearFieldWhateverTheShape) {
  constexpr int dim = TypeParam::dim;
  const Grid<TypeParam> grid = this->sheared();
  for (const double beside : {0., 1. / 16, 1. / 8, 1. / 6}) {
    const Accumulator sums(grid.lattice.size, dim + 1);
    Kokkos::deep_copy(sums.total, 1.0);
    const int middle[2] = {4, 5};
    int i[dim], empty = 0;
    for (int d = 0; d < dim; ++d) i[d] = middle[d];
    empty = grid.lattice.index(i);
    sums.total(empty, dim) = 0;
    describe_cells(grid, sums, beside);
    for (int c = 0; c < grid.lattice.size; ++c) {
      bool inside = true;
      grid.lattice.coordinates(c, i);
      for (int d = 0; d < dim; ++d) inside = inside && i[d] >= 0 && i[d] < grid.lattice.cells[d];
      if (!inside) continue;
      for (int d = 0; d < dim; ++d)
        EXPECT_NEAR(grid.cell(c, d), c == empty ? 0 : this->rate(d), 1e-13) << beside;
      EXPECT_EQ(grid.cell(c, dim), c == empty ? 0 : 1);
    }
  }
}

TYPED_TEST(Cells, AreStrainedWhereAllNodesHaveMass) {
  constexpr int dim = TypeParam::dim;
  const Grid<TypeParam> grid = this->sheared();
  EXPECT_NEAR(fastest_strain(grid), this->strain(), 1e-13);
  int i[dim];
  for (int d = 0; d < dim; ++d) i[d] = 3;
  const int node = grid.lattice.index(i);
  grid.before(node, 0) = 100;
  EXPECT_GT(fastest_strain(grid), 100);
  grid.before(node, dim) = 0;  // whatever its velocity
  EXPECT_NEAR(fastest_strain(grid), this->strain(), 1e-13);
}

}  // namespace
}  // namespace brisance
