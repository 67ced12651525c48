#pragma once
// The numbers every kernel speaks in. The only header that knows which Kokkos it is compiled with.
#include <Kokkos_Core.hpp>
#include <Kokkos_ScatterView.hpp>
#include <cstdint>

/// For the bodies of loops that are given as lambdas: what they sum stays in registers only then.
#if defined(__GNUC__)
#define BRISANCE_INLINE __attribute__((always_inline))
#else
#define BRISANCE_INLINE
#endif

namespace brisance {

#if defined(KOKKOS_VERSION) && KOKKOS_VERSION >= 30700
namespace math = Kokkos;
#else
namespace math = Kokkos::Experimental;
#endif
/// Starts the parallel runtime; -1 threads: all there are.
inline void initialize_kokkos(int threads) {
#if defined(KOKKOS_VERSION) && KOKKOS_VERSION >= 30700
  Kokkos::InitializationSettings settings;
  if (threads > 0) settings.set_num_threads(threads);
#else
  Kokkos::InitArguments settings;
  settings.num_threads = threads;
#endif
  Kokkos::initialize(settings);
}

using math::ceil;
using math::exp;
using math::fabs;
using math::floor;
using math::log;
using math::pow;
using math::sqrt;

using Space = Kokkos::DefaultExecutionSpace;

/// Whether kernels run as the program's own threads, which can call one function after another.
constexpr bool kernels_on_host = std::is_same<Space, Kokkos::DefaultHostExecutionSpace>::value;

/// One value per row; rows of several components are stored component by component, so that a
/// kernel that walks along a row of cells reads contiguous memory.
template <class T>
using Array = Kokkos::View<T*, Space>;
template <class T>
using Table = Kokkos::View<T**, Kokkos::LayoutLeft, Space>;

/// The type T in the list of a function's parameters, but not where T is deduced from.
template <class T>
using Same = std::common_type_t<T>;

KOKKOS_INLINE_FUNCTION double square(double a) { return a * a; }
KOKKOS_INLINE_FUNCTION double least(double a, double b) { return a < b ? a : b; }
KOKKOS_INLINE_FUNCTION double most(double a, double b) { return a > b ? a : b; }
KOKKOS_INLINE_FUNCTION double clamp(double a, double low, double high) {
  return least(most(a, low), high);
}

KOKKOS_INLINE_FUNCTION constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// A vector of D components. T is here and below one number or several (core/wide.hpp).
template <class T, int D>
struct VecOf {
  T a[D] = {};
  KOKKOS_FORCEINLINE_FUNCTION T& operator[](int i) { return a[i]; }
  KOKKOS_FORCEINLINE_FUNCTION T operator[](int i) const { return a[i]; }
};
template <int D>
using Vec = VecOf<double, D>;

template <int D>
KOKKOS_INLINE_FUNCTION double dot(const Vec<D>& u, const Vec<D>& v) {
  double sum = 0;
  for (int d = 0; d < D; ++d) sum += u[d] * v[d];
  return sum;
}

/// A D x D matrix, row by row; as a velocity gradient L, L(i, j) = d v_i / d x_j.
template <class T, int D>
struct MatOf {
  T a[D * D] = {};
  KOKKOS_FORCEINLINE_FUNCTION T& operator()(int i, int j) { return a[i * D + j]; }
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int i, int j) const { return a[i * D + j]; }
};
template <int D>
using Mat = MatOf<double, D>;

template <class T, int D>
KOKKOS_FORCEINLINE_FUNCTION T trace(const MatOf<T, D>& m) {
  T sum = m(0, 0);
  for (int d = 1; d < D; ++d) sum += m(d, d);
  return sum;
}

/// A symmetric tensor of three dimensions: xx, yy, zz, xy, yz, zx. Tension positive where it is a
/// stress.
template <class T>
struct SymOf {
  T a[6] = {};
  KOKKOS_FORCEINLINE_FUNCTION T& operator[](int i) { return a[i]; }
  KOKKOS_FORCEINLINE_FUNCTION T operator[](int i) const { return a[i]; }

  /// Where the component (i, j) stands.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int at(int i, int j) {
    return i == j ? i : (i + j == 1 ? 3 : (i + j == 3 ? 4 : 5));
  }
};
using Sym3 = SymOf<double>;

/// Where the work done on solids has gone: [J/kg] at a point, [J] in all.
struct Energies {
  double elastic = 0;                              ///< would come back on unloading
  double plastic = 0, damage = 0, decohesion = 0;  ///< dissipated, never less than before
  KOKKOS_INLINE_FUNCTION void add(const Energies& e, double factor) {
    elastic += factor * e.elastic;
    plastic += factor * e.plastic;
    damage += factor * e.damage;
    decohesion += factor * e.decohesion;
  }
};

template <class T>
KOKKOS_FORCEINLINE_FUNCTION T trace(const SymOf<T>& s) {
  return s[0] + s[1] + s[2];
}

/// a : b, the double contraction.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T contract(const SymOf<T>& a, const SymOf<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

}  // namespace brisance
