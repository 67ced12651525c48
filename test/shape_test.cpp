#include "core/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brisance {
namespace {

/// Weights and slopes at xi, in cells from node 0.
template <class S>
struct Weights {
  int base;
  double d, w[S::width], slope[S::width];
  Weights(double xi, double half) : base(static_cast<int>(S::base(xi))), d(xi - base) {
    S::at(d, half, w, slope);
  }

  /// sum over nodes of w f(node).
  template <class F>
  double sum(const F& f) const {
    double s = 0;
    for (int k = 0; k < S::width; ++k) s += w[k] * f(base + k);
    return s;
  }
  template <class F>
  double slope_sum(const F& f) const {
    double s = 0;
    for (int k = 0; k < S::width; ++k) s += slope[k] * f(base + k);
    return s;
  }
};

template <class S>
class EveryShape : public testing::Test {
 protected:
  /// Calls f(xi, half) all over a cell, ends and middle included.
  template <class F>
  static void everywhere(const F& f) {
    for (const double half : {0.5, 1. / 6, 0.01})
      for (int k = 0; k < 64; ++k) f(7 + k / 64., half);
  }
};
using Shapes = testing::Types<Linear, Gimp, QuadraticSpline, CubicSpline>;
TYPED_TEST_SUITE(EveryShape, Shapes);

// Sums of a few terms of order 1 (positions: of order 10): a few units of round-off.
constexpr double round_off = 1e-15;

TYPED_TEST(EveryShape, IsAPartitionOfUnity) {
  this->everywhere([](double xi, double half) {
    const Weights<TypeParam> at(xi, half);
    EXPECT_NEAR(at.sum([](int) { return 1; }), 1, 4 * round_off) << xi;
    EXPECT_NEAR(at.slope_sum([](int) { return 1; }), 0, 4 * round_off) << xi;
  });
}

TYPED_TEST(EveryShape, ReproducesLinearFieldsAndTheirSlope) {
  this->everywhere([](double xi, double half) {
    const Weights<TypeParam> at(xi, half);
    EXPECT_NEAR(at.sum([](int i) { return i; }), xi, 40 * round_off) << xi;
    EXPECT_NEAR(at.slope_sum([](int i) { return i; }), 1, 100 * round_off) << xi;
  });
}

TYPED_TEST(EveryShape, HasNoNegativeWeight) {
  this->everywhere([](double xi, double half) {
    const Weights<TypeParam> at(xi, half);
    for (const double w : at.w) EXPECT_GE(w, -round_off) << xi;
  });
}

// Central differences over 1e-5; third derivatives are at most 3 (times 1e-10 / 6), the hat's edge
// in GIMP with the smallest extent has kinks, which a step of 1e-5 meets only there.
TYPED_TEST(EveryShape, SlopeIsTheDerivativeOfTheWeight) {
  const double step = 1e-5;
  for (const double half : {0.5, 1. / 6, 0.02})
    for (const double xi : {7.003, 7.127, 7.281, 7.4, 7.498, 7.61, 7.73, 7.91}) {
      const Weights<TypeParam> at(xi, half), below(xi - step, half), above(xi + step, half);
      ASSERT_EQ(below.base, above.base);
      for (int k = 0; k < TypeParam::width; ++k)
        EXPECT_NEAR((above.w[k] - below.w[k]) / (2 * step), at.slope[k], 1e-9) << xi << " " << k;
    }
}

TYPED_TEST(EveryShape, ChangesContinuouslyFromBinToBin) {
  for (const double half : {0.5, 1. / 6})
    for (const double edge : {7., 7.5, 8.}) {
      const Weights<TypeParam> below(edge - 1e-12, half), above(edge + 1e-12, half);
      for (int node = 4; node < 12; ++node) {
        const auto is = [&](int i) { return i == node ? 1. : 0.; };
        EXPECT_NEAR(below.sum(is), above.sum(is), 1e-11);
      }
    }
}

TYPED_TEST(EveryShape, ThatCarriesAffineMotionHasItsSecondMoment) {
  if (TypeParam::affine_inertia == 0) return;
  this->everywhere([](double xi, double half) {
    const Weights<TypeParam> at(xi, half);
    EXPECT_NEAR(at.sum([&](int i) { return (i - xi) * (i - xi); }), TypeParam::affine_inertia,
                40 * round_off);
  });
}

TYPED_TEST(EveryShape, IsTheSameInTheMirror) {
  this->everywhere([](double xi, double half) {
    const Weights<TypeParam> at(xi, half), image(-xi, half);
    for (int node = 3; node < 13; ++node) {
      const double here = at.sum([&](int i) { return i == node ? 1. : 0.; });
      const double there = image.sum([&](int i) { return i == -node ? 1. : 0.; });
      EXPECT_NEAR(here, there, 4 * round_off) << xi << " " << node;
    }
  });
}

}  // namespace
}  // namespace brisance
