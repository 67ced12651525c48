#pragma once
// Eight neighbouring bins of a row, one in each lane. The particles of a tile lie in memory as they
// are worked on: the first of each bin, then the second of each, and so on, the bins in the order
// of how many they hold. So the lanes that still have one are always the first, what eight
// particles have of anything is read in one go, and sums over a bin never leave their lane.
// (Padding each bin to the fullest would do without the order, but costs memory and time where a
// few cells are crowded; bins one after the other leave four lanes of eight empty with four
// particles a cell.)
#include "core/wide.hpp"

namespace brisance {

/// One particle. `shift` leads to its place in columns that are passed on (core/passing.hpp).
struct Single {
  int first, shift = 0;
  KOKKOS_FORCEINLINE_FUNCTION operator int() const { return first; }
};

/// Neighbouring particles, one in each lane: eight of them, or as many as there are. Lanes without
/// a particle read zeros, for sums, or repeat the first one, for laws.
template <bool full, bool repeats = false>
struct Bundle;

template <>
struct Bundle<true> {
  int first, shift = 0;

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

struct PartOfBundle {
  int first, count;
  bool room;  ///< whether nobody else works on the eight places from `first` on
  int shift = 0;

  KOKKOS_FORCEINLINE_FUNCTION int size() const { return count; }
  KOKKOS_FORCEINLINE_FUNCTION WideBool present() const { return Wide::count() < Wide(count); }
  KOKKOS_FORCEINLINE_FUNCTION Wide read(const double* column, double else_) const {
    if (room) return select(present(), Wide::read(column + first), else_);
    return Wide::of([&](int lane) { return lane < count ? column[first + lane] : else_; });
  }
  KOKKOS_FORCEINLINE_FUNCTION void write(double* column, const Wide& value) const {
    // In halves: blended with what stands behind them and written in one go, the next bundle, which
    // reads there, would wait for the store, 10 ns each time.
    double* to = column + first;
    Wide rest = value;
    if (count & 4) {
      rest.write<4>(to);
      rest = rest.permuted(Wide::digits(0x76547654));
      to += 4;
    }
    if (count & 2) {
      rest.write<2>(to);
      rest = rest.permuted(Wide::digits(0x32323232));
      to += 2;
    }
    if (count & 1) *to = rest[0];
  }
};

template <>
struct Bundle<false> : PartOfBundle {
  KOKKOS_FORCEINLINE_FUNCTION Wide read(const double* column) const {
    return PartOfBundle::read(column, 0);
  }
  KOKKOS_FORCEINLINE_FUNCTION Wide divisor(const Wide& value) const {
    return select(present(), value, 1);
  }
};

template <>
struct Bundle<false, true> : PartOfBundle {
  KOKKOS_FORCEINLINE_FUNCTION Wide read(const double* column) const {
    return PartOfBundle::read(column, column[first]);
  }
  KOKKOS_FORCEINLINE_FUNCTION Wide divisor(const Wide& value) const { return value; }
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
    int lane_of[Wide::lanes] = {};
    for (int other = 0; other < Wide::lanes; ++other)
      for (int b = 0; b < Wide::lanes; ++b)
        lane_of[b] += counts[other] > counts[b] || (counts[other] == counts[b] && other < b);
    TileOrder order{0};
    for (int b = 0; b < Wide::lanes; ++b) {
      order.digits |= static_cast<std::uint64_t>(b) << 4 * lane_of[b];
      order.digits |= static_cast<std::uint64_t>(lane_of[b]) << (32 + 4 * b);
    }
    return order;
  }
};

struct Tile {
  int bin;        ///< the first
  int first;      ///< particle
  int shift;      ///< of its particles
  int owned_end;  ///< end of the particles that nobody else works on
  TileOrder order;
  bool whole;                        ///< all eight bins are there, and their nodes lie in one line
  std::int64_t counts[Wide::lanes];  ///< of particles, lane by lane

  /// Of the bins bin_ .. end, those before `inside` reach nodes of their own line only; `first_of`
  /// counts the particles that lie in the bins before each.
  KOKKOS_FORCEINLINE_FUNCTION Tile(const Array<int>& first_of, int bin_, int end, int inside,
                                   TileOrder order_, int owned_end_, int shift_ = 0)
      : bin(bin_),
        first(first_of(bin_)),
        shift(shift_),
        owned_end(owned_end_),
        order(order_),
        whole(bin_ + Wide::lanes <= (end < inside ? end : inside)) {
    const int* const before = &first_of(bin);
    std::int64_t in_bin[Wide::lanes] = {};
    if (whole)
      for (int b = 0; b < Wide::lanes; ++b) in_bin[b] = before[b + 1] - before[b];
    else
      for (int b = 0; b < Wide::lanes && bin + b < end; ++b) in_bin[b] = before[b + 1] - before[b];
    Wide::permute(in_bin, order.bins(), counts);
  }

  KOKKOS_FORCEINLINE_FUNCTION bool empty() const { return counts[0] == 0; }

  /// Calls f(bundle) for the particles, those of one bin always in the same lane.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void for_bundles(const F& f) const {
    int p = first, slot = 0;
    for (; slot < counts[Wide::lanes - 1]; ++slot, p += Wide::lanes) f(Bundle<true>{p, shift});
    for (int present = Wide::lanes;; ++slot) {
      while (present > 0 && counts[present - 1] <= slot) --present;
      if (present == 0) return;
      f(Bundle<false>{p, present, p + Wide::lanes <= owned_end, shift});
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

  /// Calls f(read) with read(field, column, offset): what stands in a column of nodes at `offset`
  /// from each lane's bin.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void read_by(const F& f) const {
    if (whole) {
      const Wide::Flags bins = order.bins();
      f([&](const Table<double>& field, int column, int offset)
            BRISANCE_INLINE { return Wide::read(&field(bin + offset, column)).permuted(bins); });
    } else {
      f([&](const Table<double>& field, int column, int offset) {
        return gather([&](int b) { return field(b + offset, column); });
      });
    }
  }
  KOKKOS_FORCEINLINE_FUNCTION Wide read(const Table<double>& field) const {
    Wide value;
    read_by([&](const auto& read) BRISANCE_INLINE { value = read(field, 0, 0); });
    return value;
  }
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION Wide gather(const F& of_bin) const {
    double values[Wide::lanes] = {};
    for_lanes([&](int lane, int b) { values[lane] = of_bin(b); });
    return Wide::read(values);
  }
};

}  // namespace brisance
