#pragma once
// A few doubles that the processor works on at once. Compilers with vector types give one machine
// instruction for each operator; for the others loops of fixed length stand in. Written as plain
// loops over arrays, sums over nodes take 1.5 to 3 times as long, since GCC 12 leaves them scalar.
#include "core/types.hpp"

namespace brisance {

#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
template <int N>
struct VectorOf;
template <>
struct VectorOf<2> {
  typedef double type __attribute__((vector_size(16)));
};
template <>
struct VectorOf<4> {
  typedef double type __attribute__((vector_size(32)));
};
#else
template <int N>
struct VectorOf {
  struct type {
    double a[N];
    KOKKOS_FORCEINLINE_FUNCTION double& operator[](int i) { return a[i]; }
    KOKKOS_FORCEINLINE_FUNCTION double operator[](int i) const { return a[i]; }
    KOKKOS_FORCEINLINE_FUNCTION friend type operator+(type u, const type& v) {
      for (int i = 0; i < N; ++i) u.a[i] += v.a[i];
      return u;
    }
    KOKKOS_FORCEINLINE_FUNCTION friend type operator-(type u, const type& v) {
      for (int i = 0; i < N; ++i) u.a[i] -= v.a[i];
      return u;
    }
    KOKKOS_FORCEINLINE_FUNCTION friend type operator*(type u, const type& v) {
      for (int i = 0; i < N; ++i) u.a[i] *= v.a[i];
      return u;
    }
  };
};
#endif

template <int N>
struct Pack {
  using Lanes = typename VectorOf<N>::type;
  Lanes lanes = {};

  Pack() = default;
  KOKKOS_FORCEINLINE_FUNCTION Pack(const Lanes& lanes_) : lanes(lanes_) {}
  KOKKOS_FORCEINLINE_FUNCTION Pack(double all) {
    if constexpr (N == 2)
      lanes = Lanes{all, all};
    else
      lanes = Lanes{all, all, all, all};
  }
  KOKKOS_FORCEINLINE_FUNCTION static Pack of(const double (&a)[N]) {
    if constexpr (N == 2)
      return Lanes{a[0], a[1]};
    else
      return Lanes{a[0], a[1], a[2], a[3]};
  }
  KOKKOS_FORCEINLINE_FUNCTION double operator[](int i) const { return lanes[i]; }

  KOKKOS_FORCEINLINE_FUNCTION friend Pack operator+(const Pack& u, const Pack& v) {
    return Pack(u.lanes + v.lanes);
  }
  KOKKOS_FORCEINLINE_FUNCTION friend Pack operator-(const Pack& u, const Pack& v) {
    return Pack(u.lanes - v.lanes);
  }
  KOKKOS_FORCEINLINE_FUNCTION friend Pack operator*(const Pack& u, const Pack& v) {
    return Pack(u.lanes * v.lanes);
  }
  KOKKOS_FORCEINLINE_FUNCTION Pack& operator+=(const Pack& v) { return *this = *this + v; }
  KOKKOS_FORCEINLINE_FUNCTION Pack& operator*=(const Pack& v) { return *this = *this * v; }

  /// The sum of all lanes, in an order that a mirror image does not change.
  KOKKOS_FORCEINLINE_FUNCTION double sum() const {
    if constexpr (N == 2)
      return lanes[0] + lanes[1];
    else
      return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]);
  }
};

}  // namespace brisance
