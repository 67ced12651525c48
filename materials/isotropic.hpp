#pragma once
// Isotropic linear elasticity, and the invariants of symmetric tensors that the laws of solids
// share.
#include "core/types.hpp"

namespace brisance {

/// a + factor b.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> added(const SymOf<T>& a, double factor, const SymOf<T>& b) {
  SymOf<T> sum;
  for (int k = 0; k < 6; ++k) sum[k] = a[k] + T(factor) * b[k];
  return sum;
}

template <class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> middle(const SymOf<T>& a, const SymOf<T>& b) {
  SymOf<T> mean;
  for (int k = 0; k < 6; ++k) mean[k] = 0.5 * (a[k] + b[k]);
  return mean;
}

KOKKOS_INLINE_FUNCTION Sym3 deviator(const Sym3& a) {
  Sym3 dev = a;
  const double mean = trace(a) / 3;
  for (int k = 0; k < 3; ++k) dev[k] -= mean;
  return dev;
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

/// The unit vector in the xy plane along which a tensor is largest. Where all directions are alike,
/// to nine digits, it is x, so that round-off does not choose.
KOKKOS_INLINE_FUNCTION Vec<2> major_direction(const Sym3& a) {
  const double half = 0.5 * (a[0] - a[1]), radius = sqrt(square(half) + square(a[3]));
  Vec<2> n;
  if (!(radius > 1e-9 * (fabs(a[0]) + fabs(a[1])))) {
    n[0] = 1;
    return n;
  }
  const int larger = half < 0 ? 1 : 0;
  n[larger] = sqrt(0.5 * (1 + fabs(half) / radius));
  n[1 - larger] = 0.5 * a[3] / (radius * n[larger]);
  return n;
}

/// n . a . n for a direction in the xy plane.
KOKKOS_INLINE_FUNCTION double along(const Sym3& a, const Vec<2>& n) {
  return square(n[0]) * a[0] + square(n[1]) * a[1] + 2 * n[0] * n[1] * a[3];
}

/// n . a . t for a direction in the xy plane and the one across, t = (-n_y, n_x).
KOKKOS_INLINE_FUNCTION double across(const Sym3& a, const Vec<2>& n) {
  return n[0] * n[1] * (a[1] - a[0]) + (square(n[0]) - square(n[1])) * a[3];
}

/// Bulk and shear modulus. [Pa]
struct Isotropic {
  double K = 0, G = 0;

  KOKKOS_INLINE_FUNCTION static Isotropic from_young(double E, double nu) {
    return {E / (3 * (1 - 2 * nu)), E / (2 * (1 + nu))};
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION SymOf<T> stress(const SymOf<T>& strain) const {
    SymOf<T> s;
    const T mean = (K - 2 * G / 3) * trace(strain);
    for (int k = 0; k < 6; ++k) s[k] = 2 * G * strain[k] + (k < 3 ? mean : T(0));
    return s;
  }
  KOKKOS_INLINE_FUNCTION Sym3 strain(const Sym3& stress) const {
    Sym3 e;
    const double shear = 0.5 / G, mean = trace(stress) * (1 / (9 * K) - shear / 3);
    for (int k = 0; k < 6; ++k) e[k] = shear * stress[k] + (k < 3 ? mean : 0);
    return e;
  }
  /// Stiffness against strain in one direction only. [Pa]
  KOKKOS_INLINE_FUNCTION double constrained() const { return K + 4 * G / 3; }

  /// a : C^-1 : b, the work of the stress a on the elastic strain of b. [J/m^3]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T work(const SymOf<T>& a, const SymOf<T>& b) const {
    const T traces = trace(a) * trace(b);
    return (contract(a, b) - traces * (1. / 3)) * (1 / (2 * G)) + traces * (1 / (9 * K));
  }
  /// What comes back on unloading. [J/m^3]
  KOKKOS_INLINE_FUNCTION double energy(const Sym3& stress) const {
    return 0.5 * work(stress, stress);
  }
};

}  // namespace brisance
