#pragma once
// The shape functions along one direction; a node's weight is the product over the directions.
// Each gives the first node that it touches, `base(xi)`, and the weights and slopes of its `width`
// nodes, and how a point's volume spreads over cells, `overlap`: such that the slope of a node is
// the sum over cells of overlap times the slope of the linear shape, hence a pressure that fills a
// cell together with fluids of the shape "linear" is in balance with them. Lengths are in cells.
// Those whose weights are polynomials of `degree` give the coefficients of (d - centre)^m, too.
// Sources: Sulsky et al. (1994) for linear, Bardenhagen & Kober (2004) for GIMP, Steffen, Kirby &
// Berzins (2008) for the splines.
#include "core/types.hpp"

namespace brisance {

struct Linear {
  static constexpr const char* name = "linear";
  static constexpr bool sized = false;
  static constexpr int width = 2;
  static constexpr double affine_inertia = 0;  // not a spline with constant second moment: no APIC

  static constexpr int degree = 1;
  static constexpr double centre = 0;
  KOKKOS_INLINE_FUNCTION static constexpr double coefficient(int k, int m) {
    constexpr double c[2][2] = {{1, -1}, {0, 1}};
    return c[k][m];
  }

  KOKKOS_INLINE_FUNCTION static int base(double xi) { return static_cast<int>(floor(xi)); }

  KOKKOS_INLINE_FUNCTION static void at(double d, double, double (&w)[2], double (&slope)[2]) {
    w[0] = 1 - d;
    w[1] = d;
    slope[0] = -1;
    slope[1] = 1;
  }

  static constexpr int cells = 1;
  KOKKOS_INLINE_FUNCTION static void overlap(double, double, double (&w)[1]) { w[0] = 1; }
};

/// A hat smeared over the particle's own extent, half of which is `half`, at most half a cell.
struct Gimp {
  static constexpr const char* name = "GIMP";
  static constexpr bool sized = true;  // asks for the particle's extent
  static constexpr int width = 3;
  static constexpr double affine_inertia = 0;
  static constexpr int degree = 0;  // no polynomial
  static constexpr double centre = 0;
  KOKKOS_INLINE_FUNCTION static constexpr double coefficient(int, int) { return 0; }

  KOKKOS_INLINE_FUNCTION static int base(double xi) {
    return static_cast<int>(floor(xi + 0.5)) - 1;
  }

  KOKKOS_INLINE_FUNCTION static void at(double d, double half, double (&w)[3], double (&slope)[3]) {
    for (int k = 0; k < 3; ++k) {
      const double z = d - k, r = fabs(z), sign = z < 0 ? -1 : 1;
      if (r < half) {
        w[k] = 1 - (z * z + half * half) / (2 * half);
        slope[k] = -z / half;
      } else if (r < 1 - half) {
        w[k] = 1 - r;
        slope[k] = -sign;
      } else if (r < 1 + half) {
        w[k] = square(1 + half - r) / (4 * half);
        slope[k] = -sign * (1 + half - r) / (2 * half);
      } else {
        w[k] = 0;
        slope[k] = 0;
      }
    }
  }

  static constexpr int cells = 2;
  KOKKOS_INLINE_FUNCTION static void overlap(double d, double half, double (&w)[2]) {
    w[1] = clamp((d + half - 1) / (2 * half), 0, 1);
    w[0] = 1 - w[1];
  }
};

struct QuadraticSpline {
  static constexpr const char* name = "quadratic";
  static constexpr bool sized = false;
  static constexpr int width = 3;
  static constexpr double affine_inertia = 1. / 4;  // sum over nodes of w r r, in cells^2

  static constexpr int degree = 2;
  static constexpr double centre = 1;
  KOKKOS_INLINE_FUNCTION static constexpr double coefficient(int k, int m) {
    constexpr double c[3][3] = {
        {1. / 8, -1. / 2, 1. / 2}, {3. / 4, 0, -1}, {1. / 8, 1. / 2, 1. / 2}};
    return c[k][m];
  }

  KOKKOS_INLINE_FUNCTION static int base(double xi) {
    return static_cast<int>(floor(xi + 0.5)) - 1;
  }

  KOKKOS_INLINE_FUNCTION static void at(double d, double, double (&w)[3], double (&slope)[3]) {
    w[0] = 0.5 * square(1.5 - d);
    w[1] = 0.75 - square(d - 1);
    w[2] = 0.5 * square(d - 0.5);
    slope[0] = d - 1.5;
    slope[1] = -2 * (d - 1);
    slope[2] = d - 0.5;
  }

  static constexpr int cells = 2;
  KOKKOS_INLINE_FUNCTION static void overlap(double d, double, double (&w)[2]) {
    w[0] = 1.5 - d;
    w[1] = d - 0.5;
  }
};

struct CubicSpline {
  static constexpr const char* name = "cubic";
  static constexpr bool sized = false;
  static constexpr int width = 4;
  static constexpr double affine_inertia = 1. / 3;

  static constexpr int degree = 3;
  static constexpr double centre = 1.5;
  KOKKOS_INLINE_FUNCTION static constexpr double coefficient(int k, int m) {
    constexpr double c[4][4] = {{1. / 48, -1. / 8, 1. / 4, -1. / 6},
                                {23. / 48, -5. / 8, -1. / 4, 1. / 2},
                                {23. / 48, 5. / 8, -1. / 4, -1. / 2},
                                {1. / 48, 1. / 8, 1. / 4, 1. / 6}};
    return c[k][m];
  }

  KOKKOS_INLINE_FUNCTION static int base(double xi) { return static_cast<int>(floor(xi)) - 1; }

  KOKKOS_INLINE_FUNCTION static void at(double d, double, double (&w)[4], double (&slope)[4]) {
    const double f = d - 1, g = 1 - f;
    w[0] = g * g * g / 6;
    w[1] = (3 * f * f * f - 6 * f * f + 4) / 6;
    w[2] = (3 * g * g * g - 6 * g * g + 4) / 6;
    w[3] = f * f * f / 6;
    slope[0] = -g * g / 2;
    slope[1] = (9 * f * f - 12 * f) / 6;
    slope[2] = -(9 * g * g - 12 * g) / 6;
    slope[3] = f * f / 2;
  }

  static constexpr int cells = 3;
  KOKKOS_INLINE_FUNCTION static void overlap(double d, double, double (&w)[3]) {
    w[0] = 0.5 * square(2 - d);
    w[2] = 0.5 * square(d - 1);
    w[1] = 1 - w[0] - w[2];
  }
};

}  // namespace brisance
