#pragma once
// Eight neighbouring bins of a row, one in each lane. The particles of a tile lie in memory as they
// are worked on: the first of each bin, then the second of each, and so on, the bins in the order of
// how many they hold. So the lanes that still have one are always the first, what eight particles
// have of anything is read in one go, and sums over a bin never leave their lane. (Padding each bin
// to the fullest would do without the order, but costs memory and time where a few cells are
// crowded; bins one after the other leave four lanes of eight empty with four particles a cell.)
#include "core/wide.hpp"

namespace brisance {

/// Neighbouring particles, one in each lane: eight of them, or as many as there are. Lanes without
/// a particle read zeros.
template <bool full>
struct Bundle;

template <>
struct Bundle<true> {
  int first;

  KOKKOS_FORCEINLINE_FUNCTION int size() const { return Wide::lanes; }
  KOKKOS_FORCEINLINE_FUNCTION Wide read(const double* column) const {
    return Wide::read(column + first);
  }
  KOKKOS_FORCEINLINE_FUNCTION void write(double* column, const Wide& value) const {
    value.write(column + first);
  }
  /// What may be divided by.
  KOKKOS_FORCEINLINE_FUNCTION Wide divisor(const Wide& value) const { return value; }
};

template <>
struct Bundle<false> {
  int first, count;
  bool room;  ///< whether nobody else works on the eight places from `first` on

  KOKKOS_FORCEINLINE_FUNCTION int size() const { return count; }
  KOKKOS_FORCEINLINE_FUNCTION WideBool present() const { return Wide::count() < Wide(count); }
  KOKKOS_FORCEINLINE_FUNCTION Wide read(const double* column) const {
    if (room) return select(present(), Wide::read(column + first), 0);
    return Wide::of([&](int lane) { return lane < count ? column[first + lane] : 0; });
  }
  KOKKOS_FORCEINLINE_FUNCTION void write(double* column, const Wide& value) const {
    if (room)
      select(present(), value, Wide::read(column + first)).write(column + first);
    else
      for (int lane = 0; lane < count; ++lane) column[first + lane] = value[lane];
  }
  KOKKOS_FORCEINLINE_FUNCTION Wide divisor(const Wide& value) const {
    return select(present(), value, 1);
  }
};

/// In which order the bins of a tile stand: lane r stands for the bin digit(r), base 16, and bin b
/// is in lane digit(8 + b).
struct TileOrder {
  std::uint64_t digits = 0x7654321076543210;

  KOKKOS_FORCEINLINE_FUNCTION int operator[](int lane) const { return digits >> 4 * lane & 15; }
  KOKKOS_FORCEINLINE_FUNCTION Wide::Flags bins() const { return Wide::digits(digits); }
  KOKKOS_FORCEINLINE_FUNCTION Wide::Flags lanes() const { return Wide::digits(digits >> 32); }

  /// The fullest bin first, of equal ones the first.
  KOKKOS_INLINE_FUNCTION static TileOrder by(const int (&counts)[Wide::lanes]) {
    int place[Wide::lanes];
    for (int i = 0; i < Wide::lanes; ++i) {
      int k = i;
      for (; k > 0 && counts[place[k - 1]] < counts[i]; --k) place[k] = place[k - 1];
      place[k] = i;
    }
    TileOrder order{0};
    for (int k = 0; k < Wide::lanes; ++k) {
      order.digits |= static_cast<std::uint64_t>(place[k]) << 4 * k;
      order.digits |= static_cast<std::uint64_t>(k) << (32 + 4 * place[k]);
    }
    return order;
  }
};

struct Tile {
  int bin;        ///< the first
  int first;      ///< particle
  int owned_end;  ///< end of the particles that nobody else works on
  TileOrder order;
  bool whole;  ///< all eight bins are there, and their nodes lie in one line
  std::int64_t counts[Wide::lanes];  ///< of particles, lane by lane

  /// Of the bins bin_ .. end, those before `inside` reach nodes of their own line only; `first_of`
  /// counts the particles that lie in the bins before each.
  KOKKOS_FORCEINLINE_FUNCTION Tile(const Array<int>& first_of, int bin_, int end, int inside,
                                   TileOrder order_, int owned_end_)
      : bin(bin_),
        first(first_of(bin_)),
        owned_end(owned_end_),
        order(order_),
        whole(bin_ + Wide::lanes <= (end < inside ? end : inside)) {
    std::int64_t in_bin[Wide::lanes];
    for (int b = 0; b < Wide::lanes; ++b)
      in_bin[b] = whole || bin + b < end ? first_of(bin + b + 1) - first_of(bin + b) : 0;
    for (int lane = 0; lane < Wide::lanes; ++lane) counts[lane] = in_bin[order[lane]];
  }

  KOKKOS_FORCEINLINE_FUNCTION bool empty() const { return counts[0] == 0; }

  /// Calls f(bundle) for the particles, those of one bin always in the same lane.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void for_bundles(const F& f) const {
    int p = first, slot = 0;
    for (; slot < counts[Wide::lanes - 1]; ++slot, p += Wide::lanes) f(Bundle<true>{p});
    for (int present = Wide::lanes;; ++slot) {
      while (present > 0 && counts[present - 1] <= slot) --present;
      if (present == 0) return;
      f(Bundle<false>{p, present, p + Wide::lanes <= owned_end});
      p += present;
    }
  }

  /// Calls f(lane, bin) for the lanes that have particles.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void for_lanes(const F& f) const {
    for (int lane = 0; lane < Wide::lanes && counts[lane] > 0; ++lane) f(lane, bin + order[lane]);
  }

  /// The number of each lane's bin, counted from the first.
  KOKKOS_FORCEINLINE_FUNCTION Wide digits() const { return Wide::count().permuted(order.bins()); }

  /// What stands in a column of nodes at `offset` from each lane's bin.
  KOKKOS_FORCEINLINE_FUNCTION Wide read(const Table<double>& field, int column, int offset) const {
    if (whole) return Wide::read(&field(bin + offset, column)).permuted(order.bins());
    return gather([&](int b) { return field(b + offset, column); });
  }
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION Wide gather(const F& of_bin) const {
    double values[Wide::lanes] = {};
    for_lanes([&](int lane, int b) { values[lane] = of_bin(b); });
    return Wide::read(values);
  }

  /// Adds there; `to` is a table or what stands for one. Lanes without particles must have zeros.
  template <class To>
  KOKKOS_FORCEINLINE_FUNCTION void add(const To& to, int column, int offset,
                                       const Wide& value) const {
    if constexpr (std::is_same<To, Table<double>>::value) {
      if (whole) {
        double* there = &to(bin + offset, column);
        (Wide::read(there) + value.permuted(order.lanes())).write(there);
        return;
      }
    }
    for_lanes([&](int lane, int b) { to(b + offset, column) += value[lane]; });
  }
};

}  // namespace brisance
