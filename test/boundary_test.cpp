#include "core/boundary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brisance {
namespace {

Lattice<1> line(int cells) { return Lattice<1>({2.}, {cells}, 0.5); }
Lattice<2> plane(int nx, int ny) { return Lattice<2>({0., 0.}, {nx, ny}, 1.); }

template <int D>
Boundaries<D> ends(Side side) {
  Boundaries<D> b;
  for (int d = 0; d < D; ++d) b.side[d][0] = b.side[d][1] = side;
  return b;
}

/// A field of one line; column 0 a vector, column 1 a scalar. Node i has 1 + i, and ten times that.
Table<double> numbered(const Lattice<1>& lattice) {
  const Table<double> field("field", lattice.size, 2);
  for (int n = 0; n < lattice.size; ++n) {
    field(n, 0) = n;  // n = i + 1
    field(n, 1) = 10 * n;
  }
  return field;
}

double at(const Table<double>& field, int i, int column) { return field(i + 1, column); }

TEST(Boundary, WallFoldsAMirrorImage) {
  const Lattice<1> lattice = line(4);
  const auto sums = numbered(lattice);
  const Vec<1> swallowed = fold<1>(sums, 1, 2, lattice, ends<1>(Side::wall));
  // Halo nodes -1 (0 and 0) and 5 (6 and 60) onto nodes 1 and 3.
  EXPECT_EQ(at(sums, 1, 0), 2 - 0);
  EXPECT_EQ(at(sums, 3, 0), 4 - 6);
  EXPECT_EQ(at(sums, 1, 1), 20 + 0);
  EXPECT_EQ(at(sums, 3, 1), 40 + 60);
  for (const int halo : {-1, 5})
    for (const int column : {0, 1}) EXPECT_EQ(at(sums, halo, column), 0);
  EXPECT_EQ(swallowed[0], 2 * 6);
}

// Particles that gather velocities meet -v beyond the wall, where folding has counted their mass
// with v: the difference is twice the mass there times -v.
TEST(Boundary, KnowsTheMomentumOfImages) {
  const Lattice<1> lattice = line(4);
  const auto sums = numbered(lattice);
  const Table<double> mass("image mass", lattice.size, 1);
  fold<1>(sums, 1, 2, lattice, ends<1>(Side::wall), mass);
  EXPECT_EQ(at(mass, -1, 0), 0);
  EXPECT_EQ(at(mass, 5, 0), 60);
  EXPECT_EQ(at(mass, 3, 0), 0);
  const Table<double> velocity("velocity", lattice.size, 1);
  velocity(4, 0) = 0.5;  // node 3, whose image is node 5
  fill<1>(velocity, 1, 1, lattice, ends<1>(Side::wall));
  EXPECT_EQ((image_momentum<1>(velocity, mass, lattice, ends<1>(Side::wall))[0]), 2 * 60 * -0.5);
  EXPECT_EQ((image_momentum<1>(velocity, {}, lattice, ends<1>(Side::wall))[0]), 0);
}

TEST(Boundary, PeriodicEndsFoldOntoEachOther) {
  const Lattice<1> lattice = line(4);
  const auto sums = numbered(lattice);
  const Vec<1> swallowed = fold<1>(sums, 1, 2, lattice, ends<1>(Side::periodic));
  EXPECT_EQ(swallowed[0], 0);
  // -1 onto 3, 4 onto 0, 5 onto 1: nothing is lost.
  EXPECT_EQ(at(sums, 0, 0), 1 + 5);
  EXPECT_EQ(at(sums, 1, 0), 2 + 6);
  EXPECT_EQ(at(sums, 3, 0), 4 + 0);
  fill<1>(sums, 1, 2, lattice, ends<1>(Side::periodic));
  EXPECT_EQ(at(sums, -1, 1), at(sums, 3, 1));
  EXPECT_EQ(at(sums, 4, 1), at(sums, 0, 1));
  EXPECT_EQ(at(sums, 5, 0), at(sums, 1, 0));
}

TEST(Boundary, OnePeriodicCellIsItsOwnNeighbour) {
  const Lattice<1> lattice = line(1);
  const auto sums = numbered(lattice);  // nodes -1, 0, 1, 2 hold 0, 1, 2, 3
  fold<1>(sums, 1, 2, lattice, ends<1>(Side::periodic));
  EXPECT_EQ(at(sums, 0, 0), 0 + 1 + 2 + 3);
  fill<1>(sums, 1, 2, lattice, ends<1>(Side::periodic));
  for (int i = -1; i <= 2; ++i) EXPECT_EQ(at(sums, i, 1), 60);
}

TEST(Boundary, FreeEndsKeepWhatTheyHave) {
  const Lattice<1> lattice = line(4);
  const auto sums = numbered(lattice);
  EXPECT_EQ((fold<1>(sums, 1, 2, lattice, ends<1>(Side::free))[0]), 0);
  EXPECT_EQ((constrain<1>(sums, lattice, ends<1>(Side::free))[0]), 0);
  fill<1>(sums, 1, 2, lattice, ends<1>(Side::free));
  for (int n = 0; n < lattice.size; ++n) {
    EXPECT_EQ(sums(n, 0), n);
    EXPECT_EQ(sums(n, 1), 10 * n);
  }
}

TEST(Boundary, WallStopsMotionAcrossAndFixedEndAllMotion) {
  const Lattice<2> lattice = plane(3, 2);
  for (const Side side : {Side::wall, Side::fixed}) {
    const Table<double> sums("sums", lattice.size, 3);
    Kokkos::deep_copy(sums, 1.0);
    Boundaries<2> b = ends<2>(Side::free);
    b.side[0][1] = side;  // x high
    const Vec<2> stopped = constrain<2>(sums, lattice, b);
    EXPECT_EQ(stopped[0], lattice.extent(1));
    EXPECT_EQ(stopped[1], side == Side::fixed ? lattice.extent(1) : 0);
    for (int n = 0; n < lattice.size; ++n) {
      int i[2];
      lattice.coordinates(n, i);
      EXPECT_EQ(sums(n, 0), i[0] == 3 ? 0 : 1);
      EXPECT_EQ(sums(n, 1), i[0] == 3 && side == Side::fixed ? 0 : 1);
      EXPECT_EQ(sums(n, 2), 1);
    }
  }
}

TEST(Boundary, MirrorImageOfAVelocityTurnsWhatRunsIntoTheWall) {
  const Lattice<2> lattice = plane(3, 2);
  for (const Side side : {Side::wall, Side::fixed}) {
    const Table<double> field("field", lattice.size, 3);
    for (int n = 0; n < lattice.size; ++n)
      for (int c = 0; c < 3; ++c) field(n, c) = 1 + n + 100 * c;
    Boundaries<2> b = ends<2>(Side::free);
    b.side[1][0] = side;  // y low
    fill<2>(field, 2, 3, lattice, b);
    for (int x = -1; x <= 4; ++x) {
      const int ghost = lattice.index({x, -1}), real = lattice.index({x, 1});
      EXPECT_EQ(field(ghost, 0), side == Side::fixed ? -field(real, 0) : field(real, 0));
      EXPECT_EQ(field(ghost, 1), -field(real, 1));
      EXPECT_EQ(field(ghost, 2), field(real, 2));
    }
  }
}

// What the halo receives twice over, in a corner, arrives once.
TEST(Boundary, CornersFoldThroughBothDirections) {
  for (const Side side : {Side::wall, Side::periodic}) {
    const Lattice<2> lattice = plane(4, 4);
    const Table<double> sums("sums", lattice.size, 3);
    sums(lattice.index({-1, -1}), 2) = 1;
    sums(lattice.index({-1, -1}), 0) = 1;
    fold<2>(sums, 2, 3, lattice, ends<2>(side));
    const int k = side == Side::wall ? 1 : 3;
    EXPECT_EQ(sums(lattice.index({k, k}), 2), 1);
    EXPECT_EQ(sums(lattice.index({k, k}), 0), side == Side::wall ? -1 : 1);
    double all = 0;
    for (int n = 0; n < lattice.size; ++n) all += sums(n, 2);
    EXPECT_EQ(all, 1);
  }
}

TEST(Boundary, CellsBeyondAFreeEndAreEmptyAndOthersCopies) {
  const Lattice<1> lattice = line(4);  // cells 0 .. 3, halo -1 and 4
  const auto after = [&](Side side) {
    const auto field = numbered(lattice);
    fill_cells<1>(field, 1, lattice, ends<1>(side));
    return field;
  };
  const auto wall = after(Side::wall), open = after(Side::free), periodic = after(Side::periodic);
  EXPECT_EQ(at(wall, -1, 1), at(wall, 0, 1));
  EXPECT_EQ(at(wall, 4, 0), at(wall, 3, 0));
  EXPECT_EQ(at(open, -1, 1), 0);
  EXPECT_EQ(at(open, 4, 1), 0);
  EXPECT_EQ(at(open, 4, 0), at(open, 3, 0));
  EXPECT_EQ(at(periodic, -1, 1), at(periodic, 3, 1));
  EXPECT_EQ(at(periodic, 4, 0), at(periodic, 0, 0));
}

TEST(Boundary, HalosOfCellsFoldBackOntoTheirImages) {
  const Lattice<1> lattice = line(4);
  const auto after = [&](Side side) {
    const auto field = numbered(lattice);
    fold_cells<1>(field, 1, lattice, ends<1>(side));
    return field;
  };
  const auto was = numbered(lattice);
  const auto wall = after(Side::wall), open = after(Side::free), periodic = after(Side::periodic);
  EXPECT_EQ(at(wall, 0, 1), at(was, 0, 1) + at(was, -1, 1));
  EXPECT_EQ(at(wall, 3, 1), at(was, 3, 1) + at(was, 4, 1));
  EXPECT_EQ(at(periodic, 0, 1), at(was, 0, 1) + at(was, 4, 1));
  EXPECT_EQ(at(periodic, 3, 1), at(was, 3, 1) + at(was, -1, 1));
  EXPECT_EQ(at(open, 0, 1), at(was, 0, 1));
  for (const auto& field : {wall, open, periodic}) {
    EXPECT_EQ(at(field, -1, 1), 0);
    EXPECT_EQ(at(field, 4, 1), 0);
    EXPECT_EQ(at(field, 2, 0), at(was, 2, 0));
  }
}

TEST(Boundary, ParticlesStayInsideWallsWrapAroundOrLeave) {
  const Lattice<1> lattice = line(4);  // from 2 to 4
  const auto settle = [&](Side side, double x) { return Ends<1>(lattice, ends<1>(side)).settle(0, x); };
  EXPECT_NEAR(settle(Side::wall, 1.9), 2, 1e-9);
  EXPECT_GT(settle(Side::wall, 1.9), 2);
  EXPECT_NEAR(settle(Side::fixed, 4.3), 4, 1e-9);
  EXPECT_LT(settle(Side::fixed, 4.3), 4);
  EXPECT_DOUBLE_EQ(settle(Side::periodic, 1.9), 3.9);
  EXPECT_DOUBLE_EQ(settle(Side::periodic, 4.1), 2.1);
  EXPECT_LT(settle(Side::periodic, 2 - 1e-17), 4);  // 2 - 1e-17 is 2
  EXPECT_LT(settle(Side::periodic, std::nextafter(2., 0.)), 4);
  EXPECT_GE(settle(Side::periodic, std::nextafter(2., 0.)), 2);
  EXPECT_EQ(settle(Side::free, 1.9), 1.9);
  for (const Side side : {Side::wall, Side::fixed, Side::free, Side::periodic})
    EXPECT_EQ(settle(side, 2.7), 2.7);
}

TEST(Boundary, NodesOnWallsStandForHalfACell) {
  const Lattice<2> lattice = plane(3, 3);
  const auto wall = ends<2>(Side::wall), periodic = ends<2>(Side::periodic);
  EXPECT_EQ(wall.nodal_volume(lattice, lattice.index({1, 1})), 1);
  EXPECT_EQ(wall.nodal_volume(lattice, lattice.index({0, 1})), 0.5);
  EXPECT_EQ(wall.nodal_volume(lattice, lattice.index({3, 0})), 0.25);
  EXPECT_EQ(periodic.nodal_volume(lattice, lattice.index({0, 0})), 1);
}

}  // namespace
}  // namespace brisance
