#pragma once
// Isotropic linear elasticity, and the invariants of symmetric tensors that the laws of solids
// share.
#include "core/wide.hpp"

namespace brisance {

/// a + factor b.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> added(const SymOf<T>& a, const Same<T>& factor,
                                           const SymOf<T>& b) {
  SymOf<T> sum;
  for (int k = 0; k < 6; ++k) sum[k] = a[k] + factor * b[k];
  return sum;
}

template <class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> middle(const SymOf<T>& a, const SymOf<T>& b) {
  SymOf<T> mean;
  for (int k = 0; k < 6; ++k) mean[k] = 0.5 * (a[k] + b[k]);
  return mean;
}

template <class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> select(const Truth<T>& first, const SymOf<T>& a,
                                            const SymOf<T>& b) {
  SymOf<T> chosen;
  for (int k = 0; k < 6; ++k) chosen[k] = select(first, a[k], b[k]);
  return chosen;
}

/// The same mean, the deviator times `factor`.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> with_deviator_scaled(const SymOf<T>& a, const T& factor) {
  SymOf<T> scaled;
  const T mean = (1 - factor) * trace(a) * (1. / 3);
  for (int k = 0; k < 6; ++k) scaled[k] = factor * a[k] + (k < 3 ? mean : T(0));
  return scaled;
}

/// J2 = dev(a) : dev(a) / 2.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T second_invariant(const SymOf<T>& a) {
  return (square(a[0] - a[1]) + square(a[1] - a[2]) + square(a[2] - a[0])) * (1. / 6) +
         square(a[3]) + square(a[4]) + square(a[5]);
}

/// Half the difference of the principal values in the xy plane.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T shear_in_plane(const SymOf<T>& a) {
  return sqrt(square(0.5 * (a[0] - a[1])) + square(a[3]));
}

/// The unit vector in the xy plane along which a tensor is largest. Where all directions are alike,
/// to nine digits, it is x, so that round-off does not choose.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION VecOf<T, 2> major_direction(const SymOf<T>& a) {
  const T half = 0.5 * (a[0] - a[1]), radius = shear_in_plane(a);
  const auto differ = radius > 1e-9 * (fabs(a[0]) + fabs(a[1])), falls = half < T(0);
  const T r = select(differ, radius, T(1)), larger = sqrt(0.5 * (1 + fabs(half) / r)),
          smaller = 0.5 * a[3] / (r * larger);
  return {select(differ, select(falls, smaller, larger), T(1)),
          select(differ, select(falls, larger, smaller), T(0))};
}

/// n . a . n for a direction in the xy plane.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T along(const SymOf<T>& a, const VecOf<T, 2>& n) {
  return square(n[0]) * a[0] + square(n[1]) * a[1] + 2 * n[0] * n[1] * a[3];
}

/// n . a . t for a direction in the xy plane and the one across, t = (-n_y, n_x).
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T across(const SymOf<T>& a, const VecOf<T, 2>& n) {
  return n[0] * n[1] * (a[1] - a[0]) + (square(n[0]) - square(n[1])) * a[3];
}

/// Bulk and shear modulus, of one kind of matter or of each point [Pa], and their inverses, which
/// all that follows from stresses asks for more than once: divisions take most of a law's time.
/// [1/Pa]
template <class M>
struct IsotropicOf {
  M K = 0, G = 0;
  M per_K = 0, per_G = 0;

  KOKKOS_INLINE_FUNCTION static IsotropicOf from_young(double E, double nu) {
    const double K = E / (3 * (1 - 2 * nu)), G = E / (2 * (1 + nu));
    return {K, G, 1 / K, 1 / G};
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION SymOf<T> stress(const SymOf<T>& strain) const {
    SymOf<T> s;
    const T mean = (K - (2. / 3) * G) * trace(strain);
    for (int k = 0; k < 6; ++k) s[k] = 2 * G * strain[k] + (k < 3 ? mean : T(0));
    return s;
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION SymOf<T> strain(const SymOf<T>& stress) const {
    SymOf<T> e;
    const M shear = 0.5 * per_G;
    const T mean = trace(stress) * ((1. / 9) * per_K - (1. / 3) * shear);
    for (int k = 0; k < 6; ++k) e[k] = shear * stress[k] + (k < 3 ? mean : T(0));
    return e;
  }
  /// Stiffness against strain in one direction only. [Pa]
  KOKKOS_FORCEINLINE_FUNCTION M constrained() const { return K + (4. / 3) * G; }

  /// a : C^-1 : b, the work of the stress a on the elastic strain of b. [J/m^3]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T work(const SymOf<T>& a, const SymOf<T>& b) const {
    const T traces = trace(a) * trace(b);
    return (contract(a, b) - traces * (1. / 3)) * (0.5 * per_G) + traces * ((1. / 9) * per_K);
  }
  /// What comes back on unloading. [J/m^3]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T energy(const SymOf<T>& stress) const {
    return 0.5 * work(stress, stress);
  }
};
using Isotropic = IsotropicOf<double>;

template <class T>
KOKKOS_FORCEINLINE_FUNCTION IsotropicOf<T> select(const Truth<T>& first, const IsotropicOf<T>& a,
                                                  const IsotropicOf<T>& b) {
  return {select(first, a.K, b.K), select(first, a.G, b.G), select(first, a.per_K, b.per_K),
          select(first, a.per_G, b.per_G)};
}

}  // namespace brisance
