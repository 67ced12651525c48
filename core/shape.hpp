#pragma once
// The shape functions along one direction; a node's weight is the product over the directions.
// Each gives the first node that it touches, `base(xi)`, and the weights and slopes of its `width`
// nodes, and how a point's volume spreads over cells, `overlap`: such that the slope of a node is
// the sum over cells of overlap times the slope of the linear shape, hence a pressure that fills a
// cell together with fluids of the shape "linear" is in balance with them. Lengths are in cells.
// A point is in one of the `holding` cells from `first_holding` on, counted from its base. A node
// has the weight `beside` at the next one.
// Sources: Sulsky et al. (1994) for linear, Bardenhagen & Kober (2004) for GIMP, Steffen, Kirby &
// Berzins (2008) for the splines.
#include "core/wide.hpp"

namespace brisance {

struct Linear {
  static constexpr const char* name = "linear";
  static constexpr bool sized = false;
  static constexpr int width = 2;
  static constexpr double affine_inertia = 0;  // not a spline with constant second moment: no APIC
  static constexpr double beside = 0;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T base(T xi) {
    return floor(xi);
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void at(T d, T, T (&w)[2], T (&slope)[2]) {
    w[0] = 1 - d;
    w[1] = d;
    slope[0] = -1;
    slope[1] = 1;
  }

  static constexpr int first_holding = 0, holding = 1;
  static constexpr int cells = 1;
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void overlap(T, T, T (&w)[1]) {
    w[0] = 1;
  }
};

/// A hat smeared over the particle's own extent, half of which is `half`, at most half a cell.
struct Gimp {
  static constexpr const char* name = "GIMP";
  static constexpr bool sized = true;  // asks for the particle's extent
  static constexpr int width = 3;
  static constexpr double affine_inertia = 0;
  static constexpr double beside = 1. / 16;  // of a particle half a cell long

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T base(T xi) {
    return floor(xi + 0.5) - 1;
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void at(T d, T half, T (&w)[3], T (&slope)[3]) {
    for (int k = 0; k < 3; ++k) {
      const T z = d - k, r = fabs(z), sign = select(z < T(0), T(-1), T(1));
      const auto at_top = r < half, on_flank = r < 1 - half, at_foot = r < 1 + half;
      w[k] =
          select(at_top, 1 - (z * z + half * half) / (2 * half),
                 select(on_flank, 1 - r, select(at_foot, square(1 + half - r) / (4 * half), T(0))));
      slope[k] = select(
          at_top, -z / half,
          select(on_flank, -sign, select(at_foot, -sign * (1 + half - r) / (2 * half), T(0))));
    }
  }

  static constexpr int first_holding = 0, holding = 2;
  static constexpr int cells = 2;
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void overlap(T d, T half, T (&w)[2]) {
    w[1] = clamp((d + half - 1) / (2 * half), T(0), T(1));
    w[0] = 1 - w[1];
  }
};

struct QuadraticSpline {
  static constexpr const char* name = "quadratic";
  static constexpr bool sized = false;
  static constexpr int width = 3;
  static constexpr double affine_inertia = 1. / 4;  // sum over nodes of w r r, in cells^2
  static constexpr double beside = 1. / 8;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T base(T xi) {
    return floor(xi + 0.5) - 1;
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void at(T d, T, T (&w)[3], T (&slope)[3]) {
    w[0] = 0.5 * square(1.5 - d);
    w[1] = 0.75 - square(d - 1);
    w[2] = 0.5 * square(d - 0.5);
    slope[0] = d - 1.5;
    slope[1] = -2 * (d - 1);
    slope[2] = d - 0.5;
  }

  static constexpr int first_holding = 0, holding = 2;
  static constexpr int cells = 2;
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void overlap(T d, T, T (&w)[2]) {
    w[0] = 1.5 - d;
    w[1] = d - 0.5;
  }
};

struct CubicSpline {
  static constexpr const char* name = "cubic";
  static constexpr bool sized = false;
  static constexpr int width = 4;
  static constexpr double affine_inertia = 1. / 3;
  static constexpr double beside = 1. / 6;

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T base(T xi) {
    return floor(xi) - 1;
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void at(T d, T, T (&w)[4], T (&slope)[4]) {
    const T f = d - 1, g = 1 - f;
    w[0] = g * g * g * (1. / 6);
    w[1] = f * f * (0.5 * f - 1) + 2. / 3;
    w[2] = g * g * (0.5 * g - 1) + 2. / 3;
    w[3] = f * f * f * (1. / 6);
    slope[0] = -0.5 * g * g;
    slope[1] = f * (1.5 * f - 2);
    slope[2] = -g * (1.5 * g - 2);
    slope[3] = 0.5 * f * f;
  }

  static constexpr int first_holding = 1, holding = 1;
  static constexpr int cells = 3;
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void overlap(T d, T, T (&w)[3]) {
    w[0] = 0.5 * square(2 - d);
    w[2] = 0.5 * square(d - 1);
    w[1] = 1 - w[0] - w[2];
  }
};

}  // namespace brisance
