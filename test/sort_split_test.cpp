#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/geometry.hpp"
#include "core/sort.hpp"
#include "core/split.hpp"

namespace brisance {
namespace {

template <class G>
Lattice<G::dim> lattice() {
  double origin[G::dim];
  int cells[G::dim];
  for (int d = 0; d < G::dim; ++d) {
    origin[d] = -1;
    cells[d] = 8;
  }
  return Lattice<G::dim>(origin, cells, 0.25);
}

std::uniform_real_distribution<double> within(-1.1, 1.1);

/// Particles in and around the lattice, with numbers as their ids and as a column.
template <class G>
Particles<G> scattered(int count, std::uint32_t seed) {
  ColumnNeeds needs;
  needs.history = 2;
  Particles<G> p(count, needs);
  p.count = count;
  std::mt19937 random(seed);
  for (int q = 0; q < count; ++q) {
    for (int d = 0; d < G::dim; ++d) p.position(q, d) = within(random);
    p.id(q) = q;
    p.history(q, 1) = 3. * q;
    p.m(q) = p.vol(q) = 1;
  }
  return p;
}

template <class G>
class Sorting : public testing::Test {};
using Geometries = testing::Types<Line, PlaneStrain>;
TYPED_TEST_SUITE(Sorting, Geometries);

template <class G>
bool inside(const Particles<G>& p, int q) {
  for (int d = 0; d < G::dim; ++d)
    if (p.position(q, d) < -1 || p.position(q, d) >= 1) return false;
  return true;
}

template <class G>
void expect_sorted(Particles<G> p, const TransferChoice& choice) {
  SCOPED_TRACE(choice.shape);
  const auto transfer = make_transfer<G>(choice);
  const auto grid = lattice<G>();
  const int count = p.count;
  int expected_inside = 0;
  for (int q = 0; q < count; ++q) expected_inside += inside(p, q);

  transfer->find_bins(grid, p);
  std::map<int, std::vector<std::int64_t>> expected;  // bin -> ids in the order they had
  for (int q = 0; q < count; ++q) expected[p.bin(q)].push_back(p.id(q));

  Sorter<G> sorter;
  EXPECT_EQ(sorter.sort(p, *transfer, grid), count - expected_inside);
  EXPECT_EQ(p.count, expected_inside);
  EXPECT_EQ(p.first(0), 0);
  EXPECT_EQ(p.first(grid.size), expected_inside);
  EXPECT_EQ(p.first(grid.size + 1), count);
  for (int bin = 0; bin <= grid.size; ++bin)
    ASSERT_EQ(p.first(bin + 1) - p.first(bin),
              expected.count(bin) > 0 ? static_cast<int>(expected[bin].size()) : 0)
        << "bin " << bin;
  for (int q = 0; q < count; ++q) {
    ASSERT_EQ(p.history(q, 1), 3 * static_cast<double>(p.id(q))) << "columns torn apart";
    ASSERT_EQ(inside(p, q), q < expected_inside);
  }

  std::map<int, std::vector<std::int64_t>> found;  // the same, tile by tile
  const RowLayout<G::dim> layout(grid);
  for (int k = 0; k < layout.rows; ++k)
    p.for_tiles(layout.row(k), 1, [&](const Tile& tile) {
      for (int lane = 1; lane < Wide::lanes; ++lane)
        ASSERT_GE(tile.counts[lane - 1], tile.counts[lane]);
      int end = tile.first;
      tile.for_bundles([&](const auto& b) {
        ASSERT_EQ(b.first, end) << "a gap";
        end += b.size();
        for (int lane = 0; lane < b.size(); ++lane)
          found[tile.bin + tile.order[lane]].push_back(p.id(b.first + lane));
      });
    });
  for (int q = expected_inside; q < count; ++q) found[grid.size].push_back(p.id(q));
  EXPECT_EQ(found, expected) << "not stable, or in the wrong bin";
}

TYPED_TEST(Sorting, IsStableCountsBinsAndPutsLeaversLast) {
  // 5000: more than one chunk for each thread.
  for (const int count : {1, 17, 5000})
    for (const char* shape : {"linear", "GIMP", "quadratic", "cubic"})
      expect_sorted(scattered<TypeParam>(count, 3), {shape, "FLIP", "particle"});
}

TYPED_TEST(Sorting, OfNothingIsNothing) {
  Particles<TypeParam> p = scattered<TypeParam>(1, 1);
  p.count = 0;
  Sorter<TypeParam> sorter;
  EXPECT_EQ(sorter.sort(p, *make_transfer<TypeParam>({}), lattice<TypeParam>()), 0);
  EXPECT_EQ(p.count, 0);
}

TYPED_TEST(Sorting, AgainChangesNothing) {
  Particles<TypeParam> p = scattered<TypeParam>(3000, 9);
  const auto transfer = make_transfer<TypeParam>({});
  Sorter<TypeParam> sorter;
  sorter.sort(p, *transfer, lattice<TypeParam>());
  std::vector<std::int64_t> ids;
  for (int q = 0; q < p.count; ++q) ids.push_back(p.id(q));
  EXPECT_EQ(sorter.sort(p, *transfer, lattice<TypeParam>()), 0);
  for (int q = 0; q < p.count; ++q) ASSERT_EQ(p.id(q), ids[q]);
}

TYPED_TEST(Sorting, OfOneMaterialAfterAnotherNeedsNoSorterOfItsOwn) {
  Sorter<TypeParam> sorter;
  const auto transfer = make_transfer<TypeParam>({});
  for (const int count : {10, 4000, 300}) {
    Particles<TypeParam> p = scattered<TypeParam>(count, 5);
    sorter.sort(p, *transfer, lattice<TypeParam>());
    for (int bin = 0; bin < lattice<TypeParam>().size; ++bin)
      ASSERT_LE(p.first(bin), p.first(bin + 1));
  }
}

/// One particle of a gas at the middle of the plane, of the given edges. [m]
Particles<PlaneStrain> block(double a, double b) {
  ColumnNeeds needs;
  needs.extent = true;
  needs.history = 1;
  needs.affine = true;
  needs.passing_lasts = true;
  Particles<PlaneStrain> p(1, needs);
  p.count = 1;
  p.extent(0, 0) = a;
  p.extent(0, 1) = b;
  p.vol(0) = a * b;
  p.m(0) = 3;
  p.velocity(0, 0) = 2;
  p.velocity(0, 1) = -1;
  p.history(0, 0) = 5;
  p.affine(0, 3) = 0.7;
  p.id(0) = 0;
  return p;
}

Boundaries<2> walls() { return {}; }

TEST(Splitting, CutsOnlyAlongTheStretchedDirection) {
  for (const int along : {0, 1}) {
    auto p = along == 0 ? block(0.3, 0.1) : block(0.1, 0.3);
    std::int64_t next_id = 100;
    EXPECT_EQ(split(p, lattice<PlaneStrain>(), walls(), 1, next_id), 1);
    ASSERT_EQ(p.count, 2);
    EXPECT_EQ(next_id, 101);
    for (int q = 0; q < 2; ++q) {
      EXPECT_NEAR(std::fabs(p.position(q, along)), 0.075, 1e-16);
      EXPECT_EQ(p.position(q, 1 - along), 0);
      EXPECT_DOUBLE_EQ(p.extent(q, along), 0.15);
      EXPECT_DOUBLE_EQ(p.extent(q, 1 - along), 0.1);
    }
    EXPECT_EQ(p.position(0, along) + p.position(1, along), 0);
  }
}

TEST(Splitting, KeepsMassMomentumEnergyAndAllThatIsIntensive) {
  auto p = block(0.3, 0.4);
  std::int64_t next_id = 1;
  EXPECT_EQ(split(p, lattice<PlaneStrain>(), walls(), 1, next_id), 3);
  double mass = 0, volume = 0, momentum = 0, energy = 0;
  std::set<std::int64_t> ids;
  std::set<std::pair<double, double>> places;
  for (int q = 0; q < p.count; ++q) {
    mass += p.m(q);
    volume += p.vol(q);
    momentum += p.m(q) * p.velocity(q, 1);
    energy += p.m(q) * p.history(q, 0);
    EXPECT_EQ(p.velocity(q, 0), 2);
    EXPECT_EQ(p.affine(q, 3), 0.7);
    ids.insert(p.id(q));
    places.insert({p.position(q, 0), p.position(q, 1)});
  }
  // Quarters are exact in binary.
  EXPECT_EQ(mass, 3);
  EXPECT_EQ(volume, 0.3 * 0.4);
  EXPECT_EQ(momentum, -3);
  EXPECT_EQ(energy, 15);
  EXPECT_EQ(ids, (std::set<std::int64_t>{0, 1, 2, 3}));
  EXPECT_EQ(places.size(), 4u);
}

TEST(Splitting, LeavesShortParticlesAlone) {
  auto p = block(0.25, 0.1);
  std::int64_t next_id = 7;
  EXPECT_EQ(split(p, lattice<PlaneStrain>(), walls(), 1, next_id), 0);
  EXPECT_EQ(p.count, 1);
  EXPECT_EQ(next_id, 7);
}

TEST(Splitting, OnALineGoesByVolume) {
  Particles<Line> p = scattered<Line>(40, 11);
  for (int q = 0; q < p.count; ++q) p.vol(q) = q % 3 == 0 ? 0.2 : 0.1;  // half a cell is 0.125
  std::int64_t next_id = 40;
  EXPECT_EQ(split(p, lattice<Line>(), Boundaries<1>{}, 0.5, next_id), 14);
  double mass = 0;
  std::set<std::int64_t> ids;
  for (int q = 0; q < p.count; ++q) {
    mass += p.m(q);
    ids.insert(p.id(q));
    EXPECT_DOUBLE_EQ(p.vol(q), 0.1);
    EXPECT_EQ(p.history(q, 1), p.history(q < 40 ? q : 3 * (q - 40), 1));
  }
  EXPECT_EQ(mass, 40);
  EXPECT_EQ(ids.size(), 54u);
}

TEST(Splitting, KeepsPartsInsideWallsAndAroundPeriodicEnds) {
  for (const Side side : {Side::wall, Side::periodic}) {
    Particles<Line> p = scattered<Line>(1, 1);
    p.position(0, 0) = -0.99;
    p.vol(0) = 0.2;
    Boundaries<1> ends;
    ends.side[0][0] = ends.side[0][1] = side;
    std::int64_t next_id = 1;
    ASSERT_EQ(split(p, lattice<Line>(), ends, 0.5, next_id), 1);
    for (int q = 0; q < 2; ++q) {
      EXPECT_GE(p.position(q, 0), -1);
      EXPECT_LT(p.position(q, 0), 1);
    }
    EXPECT_DOUBLE_EQ(p.position(0, 0), side == Side::periodic ? 0.96 : -1 + 0.25e-9);
  }
}

TEST(Extents, FollowTheStrainButNeverGetThin) {
  auto p = block(0.1, 0.1);
  Mat<2> gradient;
  gradient(0, 0) = 1;
  p.set_matrix(p.gradient, 0, gradient);
  for (int k = 0; k < 20; ++k) p.stretch(0, 0.1);
  EXPECT_NEAR(p.extent(0, 0), 0.1 * std::pow(1.1, 20), 1e-15);
  EXPECT_DOUBLE_EQ(p.extent(0, 1), p.extent(0, 0) / 4);
  // The box of the extents has the particle's volume.
  EXPECT_DOUBLE_EQ(4 * p.half_size(0, 0) * p.half_size(0, 1), p.vol(0));
}

}  // namespace
}  // namespace brisance
