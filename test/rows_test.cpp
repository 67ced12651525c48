// How threads add to one node: by colours or into copies, the sums are the same to round-off; by
// colours to the last bit for any number of threads, since no row is added before another.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>

#include "core/schedule.hpp"
#include "core/shape.hpp"
#include "core/stencil.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using test::scene;
using test::simulated;

TEST(Summation, ByCopiesGivesTheSameToRoundOff) {
  for (const char* preset : {"paper", "balanced", "accurate"}) {
    const std::vector<std::string> common = {std::string("preset=") + preset,
                                             "bodies/first/pressure=2", "time/end=0.02"};
    auto copies = common;
    copies.push_back("scheme/summation=duplicates");
    const auto a = simulated(scene(2, common))->snapshot().table,
               b = simulated(scene(2, copies))->snapshot().table;
    EXPECT_LT(test::distance(a, b), 1e-11) << preset;
  }
}

/// Each block reaches into the next, but not into the one after.
TEST(RowLayout, BlocksOfOneColourHaveNoNodeInCommon) {
  const Lattice<2> lattice({0., 0.}, {70, 45}, 1);
  const RowLayout<2> layout(lattice);
  const int reach = CubicSpline::width - 1;
  std::vector<int> owner(lattice.size + reach * lattice.stride[1] + reach, -1);
  for (int colour = 0; colour < 2; ++colour) {
    std::fill(owner.begin(), owner.end(), -1);
    for (int block = colour; block < layout.blocks; block += 2)
      for (int k = block * layout.rows_in_block;
           k < std::min(layout.rows, (block + 1) * layout.rows_in_block); ++k) {
        const Row<2> row = layout.row(k);
        for (int bin = row.begin; bin < row.end; ++bin)
          for (int line = 0; line <= reach; ++line) {
            int& of_node = owner[bin + line * lattice.stride[1]];
            ASSERT_TRUE(of_node < 0 || of_node == block) << "bin " << bin;
            of_node = block;
          }
      }
  }
}

TEST(RowLayout, HoldsEachBinOnce) {
  for (const int width : {1, 31, 61, 100}) {
    const Lattice<2> lattice({0., 0.}, {width, 5}, 1);
    const RowLayout<2> layout(lattice);
    int next = 0;
    for (int k = 0; k < layout.rows; ++k) {
      const Row<2> row = layout.row(k);
      EXPECT_EQ(row.begin, next);
      EXPECT_EQ(row.number, k);
      next = row.end;
    }
    EXPECT_EQ(next, lattice.size);
  }
}

/// Columns that a sweep clears in passing hold what it adds, and nothing of what was there; others
/// stay as they are.
template <int D>
void expect_sums_cleared(const Lattice<D>& lattice) {
  const int reach = CubicSpline::width - 1, across = D == 1 ? 0 : reach * lattice.stride[D - 1];
  Accumulator sums(lattice.size, 3);
  Kokkos::deep_copy(sums.total, 7.);
  Sweep<D> sweep(lattice);
  sweep.clear(sums, 2, 1);
  sweep.add("count", sums, [=](const Row<D>& row, const auto& to) {
    for (int bin = row.begin; bin < row.end; ++bin)
      for (const int node : {bin, bin + reach, bin + across + reach})
        if (node < lattice.size) to(node, 1) += 1;
  });
  sweep.run();
  for (int n = 0; n < lattice.size; ++n) {
    ASSERT_EQ(sums.total(n, 0), 7);
    ASSERT_EQ(sums.total(n, 1), 1 + (n >= reach) + (n >= across + reach)) << n;
    ASSERT_EQ(sums.total(n, 2), 7);
  }
}

TEST(SweepOfRows, ClearsSumsBeforeAnyBlockAdds) {
  for (const int cells : {1, 40, 200}) {
    expect_sums_cleared(Lattice<1>({0.}, {cells}, 1));
    for (const int lines : {1, 9, 33}) expect_sums_cleared(Lattice<2>({0., 0.}, {cells, lines}, 1));
  }
}

TEST(SweepOfRows, ClearsSumsThatNobodyAddsTo) {
  const Lattice<2> lattice({0., 0.}, {20, 20}, 1);
  Accumulator sums(lattice.size, 1);
  Kokkos::deep_copy(sums.total, 7.);
  Sweep<2> sweep(lattice);
  sweep.clear(sums, 1);
  sweep.run();
  for (int n = 0; n < lattice.size; ++n) ASSERT_EQ(sums.total(n, 0), 0);
}

/// Weights and slopes of bundles, full and not, are those of the shape, particle by particle.
template <class S, bool full>
void expect_bundle_as_shape(const Bundle<full>& bundle) {
  using N = Around<2, S::width>;
  const Lattice<2> lattice({0., 0.}, {12, 12}, 0.5);
  Particles<PlaneStrain> points(2 * Wide::lanes, {});
  Wide base[2];
  for (int d = 0; d < 2; ++d)
    base[d] = Wide::of([&](int lane) {
      const int q = bundle.first + lane;
      points.vol(q) = 0.02 * (1 + q);
      points.position(q, d) = 1.01 + 0.43 * q + 0.3 * d;
      return S::base(lattice.in_cells(points.position(q, d), d));
    });
  const Stencil<PlaneStrain, S> stencil(lattice, base, points, bundle);
  for (int lane = 0; lane < bundle.size(); ++lane) {
    const int q = bundle.first + lane;
    double w[2][S::width], slope[2][S::width];
    for (int d = 0; d < 2; ++d)
      S::at(lattice.in_cells(points.position(q, d), d) - base[d][lane],
            points.half_length(q, d, lattice.h), w[d], slope[d]);
    for (int k = 0; k < N::count; ++k) {
      const int i = N::digit(k, 0), j = N::digit(k, 1);
      EXPECT_NEAR(stencil.weight(k)[lane], w[0][i] * w[1][j], 1e-14);
      EXPECT_NEAR(stencil.gradient(k, 0)[lane], slope[0][i] * w[1][j], 1e-14);
      EXPECT_NEAR(stencil.gradient(k, 1)[lane], w[0][i] * slope[1][j], 1e-14);
      EXPECT_NEAR(stencil.arm(k, 0)[lane], i + base[0][lane] - points.position(q, 0) / lattice.h,
                  1e-14);
    }
  }
}

template <class S>
void expect_bundles_as_shape() {
  expect_bundle_as_shape<S>(Bundle<true>{0});
  expect_bundle_as_shape<S>(Bundle<false>{0, 5, true});
  expect_bundle_as_shape<S>(Bundle<false>{2, 3, false});
}

// A stage that takes particles as they lie, and one that takes them tile by tile.
TEST(Passing, HandsEachParticleItsOwnFromStageToStage) {
  const auto state = test::random_gas<PlaneStrain>({});
  const Particles<PlaneStrain> points = state.groups[0]->particles;
  const Array<int> kept("kept", RowLayout<2>(state.grid.lattice).rows);
  test::sweep(state.grid.lattice, [&](auto& in) {
    in.add("give", [=](const Row<2>& row) {
      points.for_all(row, [&](const auto& b) {
        points.put(points.gradient, b, 3, points.get(points.position, b, 1));
        points.put(points.work, b, 0, points.get(points.position, b, 0));
      });
    });
    in.add("take", [=](const Row<2>& row) {
      points.for_tiles(row, 2, [&](const Tile& tile) {
        tile.for_bundles([&](const auto& b) {
          const Wide y = points.get(points.gradient, b, 3), x = points.get(points.work, b);
          for (int lane = 0; lane < b.size(); ++lane)
            kept(row.number) += x[lane] == points.position(b.first + lane, 0) &&
                                y[lane] == points.position(b.first + lane, 1);
        });
      });
    });
  });
  int all = 0;
  for (std::size_t k = 0; k < kept.extent(0); ++k) all += kept(k);
  EXPECT_EQ(all, points.count);
}

TEST(Bundles, SeeTheNodesAsTheShapesSay) {
  expect_bundles_as_shape<Linear>();
  expect_bundles_as_shape<Gimp>();
  expect_bundles_as_shape<QuadraticSpline>();
  expect_bundles_as_shape<CubicSpline>();
}

}  // namespace
}  // namespace brisance
