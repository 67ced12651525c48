#pragma once
// The geometry policies: how many directions the grid resolves, and what a point's velocity
// gradient means in the three dimensions in which every material law works.
#include "core/types.hpp"

namespace brisance {

/// One direction, truly: a slab of unit area, nothing moves across.
struct Line {
  static constexpr const char* name = "line";
  static constexpr int dim = 1;
  static constexpr int stress_components = 3;  ///< xx, yy, zz
};

/// Two directions, unit thickness, no motion and no strain along the third.
struct PlaneStrain {
  static constexpr const char* name = "plane strain";
  static constexpr int dim = 2;
  static constexpr int stress_components = 4;  ///< xx, yy, zz, xy; the others are zero
};

/// The rate of deformation sym(L) in three dimensions; directions that the grid does not resolve do
/// not strain. [1/s]
template <class G, class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> strain_rate(const MatOf<T, G::dim>& gradient) {
  SymOf<T> rate;
  for (int i = 0; i < G::dim; ++i)
    for (int j = i; j < G::dim; ++j) rate[Sym3::at(i, j)] = 0.5 * (gradient(i, j) + gradient(j, i));
  return rate;
}

/// The rotation of a step, R = (1 - W dt/2)^-1 (1 + W dt/2) with the spin W = skew(L): orthogonal
/// for any step (Hughes & Winget 1980).
template <class G, class T>
KOKKOS_FORCEINLINE_FUNCTION MatOf<T, 3> rotation([[maybe_unused]] const MatOf<T, G::dim>& gradient,
                                                 [[maybe_unused]] double dt) {
  static_assert(G::dim < 3, "three directions need the inverse of a 3 x 3 matrix");
  MatOf<T, 3> r;
  for (int i = 0; i < 3; ++i) r(i, i) = 1;
  if constexpr (G::dim == 2) {
    const T a = 0.25 * dt * (gradient(1, 0) - gradient(0, 1)), norm = 1 / (1 + a * a);
    r(0, 0) = r(1, 1) = (1 - a * a) * norm;
    r(1, 0) = 2 * a * norm;
    r(0, 1) = -r(1, 0);
  }
  return r;
}

/// R s R^T.
template <class G, class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> turned(const SymOf<T>& s,
                                            [[maybe_unused]] const MatOf<T, 3>& r) {
  if constexpr (G::dim == 1) return s;
  SymOf<T> out = s;
  const T c = r(0, 0), d = r(1, 0);
  const T shift = d * d * (s[1] - s[0]) - 2 * c * d * s[3];
  out[0] = s[0] + shift;
  out[1] = s[1] - shift;
  out[3] = (c * c - d * d) * s[3] + c * d * (s[0] - s[1]);
  return out;
}

}  // namespace brisance
