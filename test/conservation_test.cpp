// Whole steps of random gas: what must be conserved is, to round-off, for every transfer, geometry,
// kind of wall, with damping and with two velocity classes. Three steps of a few hundred particles:
// sums of order 1e3 roundings of both signs, 1e-13 of the whole.
#include <gtest/gtest.h>

#include <cmath>

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
  for (const auto& g : state.groups) EXPECT_EQ(g->floors, 0);
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
    state.scheme.split_length = 0.25;
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

}  // namespace
}  // namespace brisance
