#pragma once
// Eight doubles that the processor works on at once, and the few functions that laws and transfers
// ask of numbers. Written for a type T, a formula serves one particle (double) and eight (Wide).
// Compilers with vector types give machine instructions for each operator; for the others loops of
// fixed length stand in. Written as plain loops over arrays, sums over nodes take 1.5 to 3 times as
// long, since GCC 12 leaves them scalar.
#include <cstring>

#include "core/types.hpp"

namespace brisance {

struct Wide {
  static constexpr int lanes = 8;

#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  typedef double Values __attribute__((vector_size(lanes * sizeof(double))));
  typedef std::int64_t Flags __attribute__((vector_size(lanes * sizeof(double))));
  KOKKOS_FORCEINLINE_FUNCTION static Values each(double a) { return a - Values{}; }
#else
  template <class T>
  struct Loop {
    T a[lanes] = {};
    KOKKOS_FORCEINLINE_FUNCTION T& operator[](int i) { return a[i]; }
    KOKKOS_FORCEINLINE_FUNCTION T operator[](int i) const { return a[i]; }
  };
  struct Values;
  struct Flags : Loop<std::int64_t> {
    KOKKOS_FORCEINLINE_FUNCTION friend Flags operator&(Flags u, const Flags& v) {
      for (int i = 0; i < lanes; ++i) u[i] &= v[i];
      return u;
    }
    KOKKOS_FORCEINLINE_FUNCTION friend Flags operator|(Flags u, const Flags& v) {
      for (int i = 0; i < lanes; ++i) u[i] |= v[i];
      return u;
    }
  };
  struct Values : Loop<double> {
#define BRISANCE_LOOP(op)                                                                   \
  KOKKOS_FORCEINLINE_FUNCTION friend Values operator op(const Values& u, const Values& v) { \
    Values w;                                                                               \
    for (int i = 0; i < lanes; ++i) w[i] = u[i] op v[i];                                    \
    return w;                                                                               \
  }
    BRISANCE_LOOP(+)
    BRISANCE_LOOP(-)
    BRISANCE_LOOP(*)
    BRISANCE_LOOP(/)
#undef BRISANCE_LOOP
#define BRISANCE_LOOP(op)                                                                  \
  KOKKOS_FORCEINLINE_FUNCTION friend Flags operator op(const Values& u, const Values& v) { \
    Flags w;                                                                               \
    for (int i = 0; i < lanes; ++i) w[i] = u[i] op v[i] ? -1 : 0;                          \
    return w;                                                                              \
  }
    BRISANCE_LOOP(<)
    BRISANCE_LOOP(>)
#undef BRISANCE_LOOP
  };
  KOKKOS_FORCEINLINE_FUNCTION static Values each(double a) {
    Values v;
    for (int i = 0; i < lanes; ++i) v[i] = a;
    return v;
  }
#endif

  Values v = {};

  Wide() = default;
  KOKKOS_FORCEINLINE_FUNCTION Wide(const Values& values) : v(values) {}
  KOKKOS_FORCEINLINE_FUNCTION Wide(double all) : v(each(all)) {}
  KOKKOS_FORCEINLINE_FUNCTION double operator[](int lane) const { return v[lane]; }

  /// Eight numbers that lie one behind the other.
  KOKKOS_FORCEINLINE_FUNCTION static Wide read(const double* from) {
    Wide w;
    std::memcpy(&w.v, from, sizeof(w.v));
    return w;
  }
  /// The first of them. As doubles: compilers take copied bytes for something that may have changed
  /// every pointer, too, and read them all again.
  template <int count = lanes>
  KOKKOS_FORCEINLINE_FUNCTION void write(double* to) const {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
    typedef double Part __attribute__((vector_size(count * sizeof(double)), aligned(8)));
    Part part;
    std::memcpy(&part, &v, sizeof(part));
    *reinterpret_cast<Part*>(to) = part;
#else
    for (int lane = 0; lane < count; ++lane) to[lane] = v[lane];
#endif
  }

  /// As whole numbers, cut.
  KOKKOS_FORCEINLINE_FUNCTION void write_whole(int* to) const {
    for (int lane = 0; lane < lanes; ++lane) to[lane] = static_cast<int>(v[lane]);
  }

  /// The value of lane which[i] in lane i.
  KOKKOS_FORCEINLINE_FUNCTION Wide permuted(const Flags& which) const {
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDA_ARCH__)
    return __builtin_shuffle(v, which);
#else
    return of([&](int lane) { return v[which[lane]]; });
#endif
  }
  /// The last `count` lanes of a, then the first of b.
  KOKKOS_FORCEINLINE_FUNCTION static Wide behind(const Wide& a, const Wide& b, int count) {
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDA_ARCH__)
    return __builtin_shuffle(a.v, b.v, Flags{8, 9, 10, 11, 12, 13, 14, 15} - count);
#else
    return of([&](int lane) { return lane < count ? a[lanes - count + lane] : b[lane - count]; });
#endif
  }
  KOKKOS_FORCEINLINE_FUNCTION static void permute(const std::int64_t (&from)[lanes],
                                                  const Flags& which, std::int64_t (&to)[lanes]) {
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDA_ARCH__)
    Flags all;
    std::memcpy(&all, from, sizeof(all));
    all = __builtin_shuffle(all, which);
    std::memcpy(to, &all, sizeof(all));
#else
    for (int lane = 0; lane < lanes; ++lane) to[lane] = from[which[lane]];
#endif
  }
  /// The eight last digits of a number, base 16, the last in lane 0.
  KOKKOS_FORCEINLINE_FUNCTION static Flags digits(std::uint64_t number) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
    return (Flags{} + static_cast<std::int64_t>(number)) >> Flags{0, 4, 8, 12, 16, 20, 24, 28} & 15;
#else
    Flags all = {};
    for (int lane = 0; lane < lanes; ++lane)
      all[lane] = static_cast<std::int64_t>(number >> 4 * lane & 15);
    return all;
#endif
  }

  /// Eight numbers from wherever they lie.
  KOKKOS_FORCEINLINE_FUNCTION static Wide gather(const double* from, const int (&at)[lanes]) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
    // Not by way of an array: reading it would wait for the eight stores.
    return Values{from[at[0]], from[at[1]], from[at[2]], from[at[3]],
                  from[at[4]], from[at[5]], from[at[6]], from[at[7]]};
#else
    return of([&](int lane) { return from[at[lane]]; });
#endif
  }
  /// 0, 1, ... 7.
  KOKKOS_FORCEINLINE_FUNCTION static Wide count() {
    constexpr double digits[lanes] = {0, 1, 2, 3, 4, 5, 6, 7};
    return read(digits);
  }
  /// f(lane) in each lane.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION static Wide of(const F& f) {
    double a[lanes];
    for (int lane = 0; lane < lanes; ++lane) a[lane] = f(lane);
    return read(a);
  }

  KOKKOS_FORCEINLINE_FUNCTION friend Wide operator+(const Wide& a, const Wide& b) {
    return a.v + b.v;
  }
  KOKKOS_FORCEINLINE_FUNCTION friend Wide operator-(const Wide& a, const Wide& b) {
    return a.v - b.v;
  }
  KOKKOS_FORCEINLINE_FUNCTION friend Wide operator*(const Wide& a, const Wide& b) {
    return a.v * b.v;
  }
  KOKKOS_FORCEINLINE_FUNCTION friend Wide operator/(const Wide& a, const Wide& b) {
    return a.v / b.v;
  }
  KOKKOS_FORCEINLINE_FUNCTION Wide operator-() const { return each(0) - v; }
  KOKKOS_FORCEINLINE_FUNCTION Wide& operator+=(const Wide& a) { return *this = *this + a; }
  KOKKOS_FORCEINLINE_FUNCTION Wide& operator-=(const Wide& a) { return *this = *this - a; }
  KOKKOS_FORCEINLINE_FUNCTION Wide& operator*=(const Wide& a) { return *this = *this * a; }
};

/// Tells the memory that what lies there, or where it would, is soon to be read: it comes to the
/// cache behind the nearest.
KOKKOS_FORCEINLINE_FUNCTION void prefetch([[maybe_unused]] const double* there) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  __builtin_prefetch(there, 0, 2);
#endif
}

/// A truth in each lane.
struct WideBool {
  Wide::Flags flags = {};
  WideBool() = default;
  KOKKOS_FORCEINLINE_FUNCTION WideBool(const Wide::Flags& flags_) : flags(flags_) {}
  KOKKOS_FORCEINLINE_FUNCTION friend WideBool operator&&(const WideBool& a, const WideBool& b) {
    return {a.flags & b.flags};
  }
  KOKKOS_FORCEINLINE_FUNCTION friend WideBool operator||(const WideBool& a, const WideBool& b) {
    return {a.flags | b.flags};
  }
};
KOKKOS_FORCEINLINE_FUNCTION WideBool operator<(const Wide& a, const Wide& b) { return {a.v < b.v}; }
KOKKOS_FORCEINLINE_FUNCTION WideBool operator>(const Wide& a, const Wide& b) { return {a.v > b.v}; }

/// What a comparison of two T gives.
template <class T>
using Truth = decltype(T() < T());

KOKKOS_FORCEINLINE_FUNCTION double select(bool first, double a, double b) { return first ? a : b; }
KOKKOS_FORCEINLINE_FUNCTION Wide select(bool first, const Wide& a, const Wide& b) {
  return first ? a : b;
}
KOKKOS_FORCEINLINE_FUNCTION Wide select(const WideBool& first, const Wide& a, const Wide& b) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  return Wide(first.flags ? a.v : b.v);
#else
  return Wide::of([&](int lane) { return first.flags[lane] ? a[lane] : b[lane]; });
#endif
}

KOKKOS_FORCEINLINE_FUNCTION bool any(bool truth) { return truth; }
KOKKOS_FORCEINLINE_FUNCTION bool any(const WideBool& truths) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  // As bytes, which one register holds: folded lane by lane they took three times as many steps.
  typedef std::int8_t Bytes __attribute__((vector_size(Wide::lanes)));
  const Bytes bytes = __builtin_convertvector(truths.flags, Bytes);
  std::uint64_t all;
  static_assert(sizeof(all) == sizeof(bytes));
  std::memcpy(&all, &bytes, sizeof(all));
  return all != 0;
#else
  std::int64_t all = 0;
  for (int lane = 0; lane < Wide::lanes; ++lane) all |= truths.flags[lane];
  return all != 0;
#endif
}

KOKKOS_FORCEINLINE_FUNCTION WideBool operator!(const WideBool& a) { return {a.flags ^ -1}; }
KOKKOS_FORCEINLINE_FUNCTION Wide square(const Wide& a) { return a * a; }
KOKKOS_FORCEINLINE_FUNCTION Wide least(const Wide& a, const Wide& b) { return select(a < b, a, b); }
KOKKOS_FORCEINLINE_FUNCTION Wide most(const Wide& a, const Wide& b) { return select(a > b, a, b); }
KOKKOS_FORCEINLINE_FUNCTION Wide clamp(const Wide& a, const Wide& low, const Wide& high) {
  return least(most(a, low), high);
}
KOKKOS_FORCEINLINE_FUNCTION Wide fabs(const Wide& a) { return most(a, -a); }
KOKKOS_FORCEINLINE_FUNCTION Wide sqrt(const Wide& a) {
  return Wide::of([&](int lane) { return sqrt(a[lane]); });
}
KOKKOS_FORCEINLINE_FUNCTION Wide pow(const Wide& base, double exponent) {
  return Wide::of([&](int lane) { return pow(base[lane], exponent); });
}
/// Of numbers that a 64-bit integer can hold.
KOKKOS_FORCEINLINE_FUNCTION Wide floor(const Wide& a) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  const Wide cut(__builtin_convertvector(__builtin_convertvector(a.v, Wide::Flags), Wide::Values));
  return select(cut > a, cut - Wide(1), cut);
#else
  return Wide::of([&](int lane) { return floor(a[lane]); });
#endif
}

KOKKOS_FORCEINLINE_FUNCTION double greatest(double a) { return a; }
/// Over all lanes.
KOKKOS_FORCEINLINE_FUNCTION double greatest(const Wide& a) {
  double high = a[0];
  for (int lane = 1; lane < Wide::lanes; ++lane) high = most(high, a[lane]);
  return high;
}

/// base^exponent of base >= 0. Small whole exponents, the usual ones, take multiplications, a tenth
/// of the time.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T raised(const T& base, double exponent) {
  const int whole = exponent >= 0 && exponent <= 16 ? static_cast<int>(exponent) : -1;
  if (whole != exponent) return pow(base, exponent);
  T product = 1;
  for (int k = 0; k < whole; ++k) product *= base;
  return product;
}

}  // namespace brisance
