// Whole steps of random gas: what must be conserved is, to round-off, for every transfer, geometry,
// kind of wall, with damping and with two velocity classes. Three steps of a few hundred particles:
// sums of order 1e3 roundings of both signs, 1e-13 of the whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "test/state.hpp"

namespace brisance {
namespace {

using test::random_gas;
using test::RandomGas;

/// Takes three steps and compares the books.
template <class G>
void expect_conserved(const RandomGas& of, bool energy) {
  SCOPED_TRACE(std::string(G::name) + ", " + test::name_of(of.transfer) + ", side " +
               std::to_string(static_cast<int>(of.side)) + ", damping " +
               std::to_string(of.damping) + ", classes " + std::to_string(of.classes) + ", shock " +
               of.shock);
  State<G> state = random_gas<G>(of);
  const Totals before = test::totals(state);
  for (int k = 0; k < 3; ++k) test::step(state);
  const Totals after = test::totals(state);
  EXPECT_NEAR(after.mass / before.mass, 1, 1e-13);
  const double size = std::sqrt(2 * before.mass * before.total());
  for (int d = 0; d < G::dim; ++d)
    EXPECT_NEAR((after.momentum[d] - before.momentum[d]) / size, 0, 1e-13) << "direction " << d;
  if (energy) {
    EXPECT_NEAR(after.total() / before.total(), 1, 1e-13);
  }
  for (const auto& g : state.groups) EXPECT_EQ(g->floors(), 0);
}

template <class G>
class Conservation : public testing::Test {
 public:
  template <class F>
  static void for_each_transfer(const F& f) {
    for (const auto& choice : test::every_transfer())
      for (const double damping : {0., 0.05}) {
        RandomGas of;
        of.transfer = choice;
        of.damping = damping;
        f(of);
      }
  }
};
using Geometries = testing::Types<Line, PlaneStrain>;
TYPED_TEST_SUITE(Conservation, Geometries);

TYPED_TEST(Conservation, HoldsInAPeriodicBox) {
  this->for_each_transfer([](RandomGas of) { expect_conserved<TypeParam>(of, true); });
}

TYPED_TEST(Conservation, HoldsBetweenWallsThatBookTheirImpulse) {
  this->for_each_transfer([](RandomGas of) {
    of.side = Side::wall;
    expect_conserved<TypeParam>(of, true);
  });
}

TYPED_TEST(Conservation, HoldsBetweenFixedWallsThatBookTheirImpulse) {
  this->for_each_transfer([](RandomGas of) {
    of.side = Side::fixed;
    expect_conserved<TypeParam>(of, true);
  });
}

TYPED_TEST(Conservation, HoldsWithViscosities) {
  this->for_each_transfer([](RandomGas of) {
    of.newtonian = true;
    of.shock = "Kurapatenko";
    expect_conserved<TypeParam>(of, true);
  });
}

TYPED_TEST(Conservation, HoldsAmongSeveralMaterials) {
  this->for_each_transfer([](RandomGas of) {
    of.groups = 3;
    expect_conserved<TypeParam>(of, true);
  });
}

TYPED_TEST(Conservation, HoldsWithTwoVelocityClasses) {
  this->for_each_transfer([](RandomGas of) {
    of.groups = of.classes = 2;
    for (const Side side : {Side::periodic, Side::wall}) {
      of.side = side;
      expect_conserved<TypeParam>(of, true);
    }
  });
}

// MUSL conserves mass and momentum; energy only as far as the step is short.
TYPED_TEST(Conservation, OfMassAndMomentumHoldsWithMUSL) {
  for (const char* shape : {"linear", "GIMP", "quadratic", "cubic"})
    for (const Side side : {Side::periodic, Side::wall}) {
      RandomGas of;
      of.transfer = {shape, "FLIP", "particle"};
      of.side = side;
      of.midpoint = false;
      expect_conserved<TypeParam>(of, false);
    }
}

TYPED_TEST(Conservation, HoldsThroughRelaxationAndSplitting) {
  this->for_each_transfer([](RandomGas of) {
    SCOPED_TRACE(test::name_of(of.transfer));
    State<TypeParam> state = random_gas<TypeParam>(of);
    state.scheme.rates = {0.15, 1, 1};
    state.spare = Accumulator(state.grid.lattice.size, relaxation_columns);
    state.sums = Accumulator(state.grid.lattice.size, relaxation_columns);
    state.scheme.split_length = 0.25;
    state.longest = Array<double>("longest", RowLayout<TypeParam::dim>(state.grid.lattice).rows);
    const Totals before = test::totals(state);
    const long particles = state.particles();
    for (int k = 0; k < 3; ++k) test::step(state);
    const Totals after = test::totals(state);
    EXPECT_GT(state.particles(), particles);
    EXPECT_NEAR(after.mass / before.mass, 1, 1e-13);
    EXPECT_NEAR(after.total() / before.total(), 1, 1e-13);
    for (int d = 0; d < TypeParam::dim; ++d)
      EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-13 * before.mass);
  });
}

// Without damping FLIP takes only changes of velocity from the grid, and those are common to all
// classes.
TYPED_TEST(Conservation, TwoClassesOfUndampedFLIPAreOne) {
  for (const char* shape : {"linear", "GIMP", "quadratic", "cubic"}) {
    RandomGas of;
    of.transfer = {shape, "FLIP", "particle"};
    of.groups = 2;
    State<TypeParam> one = random_gas<TypeParam>(of);
    of.classes = 2;
    State<TypeParam> two = random_gas<TypeParam>(of);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(test::step(one) / test::step(two), 1, 1e-13);
    for (std::size_t g = 0; g < 2; ++g) {
      const auto &a = one.groups[g]->particles, &b = two.groups[g]->particles;
      ASSERT_EQ(a.count, b.count);
      for (int p = 0; p < a.count; ++p) {
        ASSERT_EQ(a.id(p), b.id(p));
        for (int d = 0; d < TypeParam::dim; ++d) {
          ASSERT_NEAR(a.velocity(p, d), b.velocity(p, d), 1e-13);
          ASSERT_NEAR(a.position(p, d), b.position(p, d), 1e-13);
        }
        ASSERT_NEAR(a.stress(p, 0), b.stress(p, 0), 1e-13);
      }
    }
  }
}

// With linear shapes the velocity is linear in a cell of a line: the distance of two points in it
// changes by the factor by which their volumes do, exactly, if points move as they are strained. A
// distance of 1e-3 at a place of 3 has 12 digits.
TEST(Motion, TellsPlacesAndVolumesTheSame) {
  for (const char* quadrature : {"particle", "cell"}) {
    RandomGas of;
    of.transfer.quadrature = quadrature;
    State<Line> state = random_gas<Line>(of);
    const auto& points = state.groups[0]->particles;
    struct Pair {
      double distance, volume;
    };
    std::map<std::pair<std::int64_t, std::int64_t>, Pair> pairs;
    const auto for_pairs = [&](const auto& f) {
      for (int p = 0; p < points.count; ++p)
        for (int q = 0; q < points.count; ++q)
          if (points.id(p) < points.id(q))
            f(std::pair(points.id(p), points.id(q)),
              Pair{points.position(q, 0) - points.position(p, 0), points.volume(p, 0)},
              state.grid.lattice.cell_of(points.x(p)) == state.grid.lattice.cell_of(points.x(q)));
    };
    for_pairs([&](const auto& ids, const Pair& pair, bool same_cell) {
      if (same_cell && std::fabs(pair.distance) > 1e-3) pairs[ids] = pair;
    });
    test::step(state);
    int compared = 0;
    double most = 0;
    for_pairs([&](const auto& ids, const Pair& now, bool) {
      const auto old = pairs.find(ids);
      if (old == pairs.end() || std::fabs(now.distance) > 0.5) return;  // round the periodic box
      const double growth = now.volume / old->second.volume;
      EXPECT_NEAR(now.distance / old->second.distance, growth, 1e-11);
      most = std::max(most, std::fabs(growth - 1));
      ++compared;
    });
    EXPECT_GT(compared, 20);
    EXPECT_GT(most, 0.01);
  }
}

}  // namespace
}  // namespace brisance
