#pragma once
// What every particle has, and the only place that knows how it lies in memory: columns sorted by
// tiles of bins (core/tile.hpp), one value after the other. Kernels capture it by value and reach
// particles through its accessors, one by one or in bundles.
#include <string>

#include "core/geometry.hpp"
#include "core/lattice.hpp"
#include "core/passing.hpp"
#include "core/row.hpp"

namespace brisance {

/// Whether a material's stress is a pressure (a fluid without shear) or a tensor.
enum class Stress { pressure, tensor };

/// Which optional columns the scheme needs; what it does not need takes no memory.
struct ColumnNeeds {
  Stress stress = Stress::pressure;
  int history = 0;           ///< state variables of the material
  bool affine = false;       ///< APIC: the affine velocity field of each particle
  bool work = false;         ///< midpoint: specific energy received in a step
  bool half_stress = false;  ///< midpoint, solids: the stress half a step on, beside the state
  bool relaxation = false;   ///< relaxations of fluids: residuals and exchanges
  bool compression = false;  ///< relaxation of heat: the rate of compression of the last step
  bool stress_relaxation = false;  ///< of solids: residuals of the direct stresses and a weight
  bool extent =
      false;  ///< edges of each particle, where the scheme asks for them in more than one direction
  bool passing_lasts = false;  ///< whether what stages pass on has a place for each particle, so
                               ///< that it can be looked at after the sweep
};

/// One column of a table of particles or nodes; where several are meant, the first.
struct Entry {
  Table<double> table;
  int column = 0;
};

/// A value with its weight, whose mean over particles is taken at the nodes.
struct Weighted {
  Entry value, weight;
};

/// value <- keep * value + factor * sum over nodes of N field.
struct Gathering {
  Entry field, value;
  double keep = 0, factor = 1;
};

template <class G>
struct Particles {
  static constexpr int D = G::dim;

  int count = 0;
  Table<double> position, velocity, mass, volume, stress, history, affine, extent, scratch;
  Passing gradient;           ///< of the velocity [1/s]
  Passing work;               ///< specific energy received [J/kg]
  Table<double> compression;  ///< -tr D at the end of the last step [1/s]
  Table<double> acting;  ///< the stress that pulls at the nodes: `stress` itself, or a column apart
  bool acts_apart = false;
  Array<std::int64_t> id;
  Array<int> first;  ///< of each bin: how many particles lie in those before; a row of bins b .. c
                     ///< holds the particles first(b) .. first(c), tile by tile
  Array<TileOrder> order;  ///< of each tile of each row
  Array<int> bin;          ///< where each goes in the next sort

  Particles() = default;
  Particles(int capacity, const ColumnNeeds& needs);

  int capacity() const { return capacity_; }

  /// Room for at least `needed` particles, columns kept.
  void reserve(int needed);
  /// Room for what is passed on, of rows of so many particles at most.
  void make_room_for_row(int particles);
  /// None yet, with the same columns in memory of their own.
  Particles none() const;

  /// Calls f(name, column, carried) for each allocated column of doubles; `carried` columns hold
  /// state, the others nothing that outlives a kernel. Splitting, output, restart and migration are
  /// written over this, so that nobody lists the columns twice.
  template <class F>
  void each_column(F&& f) {
    f("position", position, true);
    f("velocity", velocity, true);
    f("mass", mass, true);
    f("volume", volume, true);
    f("stress", stress, true);
    if (history.extent(1) > 0) f("history", history, true);
    if (affine.extent(1) > 0) f("affine", affine, true);
    if (extent.extent(1) > 0) f("extent", extent, true);
    if (compression.extent(1) > 0) f("compression", compression, true);
    if (acts_apart) f("half stress", acting, false);
    if (scratch.extent(1) > 0) f("scratch", scratch, false);
    if (passing_.extent(1) > 0 && !by_row_) f("passing", passing_, false);
  }

  template <int N>
  KOKKOS_INLINE_FUNCTION static Vec<N> load(const Table<double>& column, int p) {
    Vec<N> value;
    for (int k = 0; k < N; ++k) value[k] = column(p, k);
    return value;
  }

  /// Component k of a column, of one particle or of a bundle.
  KOKKOS_FORCEINLINE_FUNCTION static double get(const Table<double>& column, int p, int k = 0) {
    return column(p, k);
  }
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION static Wide get(const Table<double>& column,
                                              const Bundle<full, repeats>& b, int k = 0) {
    return b.read(&column(0, k));
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION static auto get(const Passing& column, const I& p, int k = 0) {
    return column.get(p, k);
  }
  // Stages that are the first of a sweep to read some columns wait for the memory, since those are
  // more than the processor foresees. Told some way ahead, to the cache behind the nearest, a sweep
  // takes a tenth to a fifth less time, a sixth to a quarter where two threads share the memory.
  // (Into the nearest cache: nothing, as the particles of a row fill it.)

  /// Asks the memory for the first columns of a table, some way ahead.
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION static void ask_for(const Table<double>& table, int columns,
                                                  const Bundle<full, repeats>& b) {
    if constexpr (full)
      for (int k = 0; k < columns; ++k) prefetch(&table(b.first, k) + far_ahead);
  }
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION static void ask_for(const Entry& column,
                                                  const Bundle<full, repeats>& b) {
    if constexpr (full) prefetch(&column.table(b.first, column.column) + far_ahead);
  }
  /// The same for all that is carried.
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION void ask_for_all(const Bundle<full, repeats>& b) const {
    if constexpr (full)
      for (int k = 0; k < carried_; ++k)
        prefetch(&store_(offset_ + b.first, k + shifted_) + far_ahead);
  }
  KOKKOS_FORCEINLINE_FUNCTION static void put(const Table<double>& column, int p, int k,
                                              double value) {
    column(p, k) = value;
  }
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION static void put(const Table<double>& column,
                                              const Bundle<full, repeats>& b, int k,
                                              const Wide& value) {
    b.write(&column(0, k), value);
  }

  template <class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION static void put(const Passing& column, const I& p, int k,
                                              const T& value) {
    column.put(p, k, value);
  }

  KOKKOS_FORCEINLINE_FUNCTION void set_bin(int p, double value) const {
    bin(p) = static_cast<int>(value);
  }
  KOKKOS_FORCEINLINE_FUNCTION void set_bin(const Bundle<true>& b, const Wide& value) const {
    value.write_whole(&bin(b.first));
  }
  KOKKOS_FORCEINLINE_FUNCTION void set_bin(const PartOfBundle& b, const Wide& value) const {
    for (int lane = 0; lane < b.count; ++lane) set_bin(b.first + lane, value[lane]);
  }

  /// Of the particles of a row, to their places in what is passed on.
  KOKKOS_FORCEINLINE_FUNCTION int shift(const Row<D>& row) const {
    return by_row_ ? row.thread * row_room_ - first(row.begin) : 0;
  }

  /// Calls f(tile) for the tiles of a row that hold particles; their shapes touch `width` nodes
  /// along x.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void for_tiles(const Row<D>& row, int width, const F& f) const {
    if (first(row.begin) == first(row.end)) return;
    const int owned_end = first(row.owned_end), shift = this->shift(row);
    int number = row.number * Row<D>::tiles;
    for (int begin = row.begin; begin < row.end; begin += Wide::lanes, ++number) {
      const Tile tile(first, begin, row.end, row.line_end - width + 1, order(number), owned_end,
                      shift);
      if (!tile.empty()) f(tile);
    }
  }
  /// Calls f(bundle) for the particles of a row, whatever their bins. The last of them, of which
  /// there may be fewer than eight, are a bundle, too: so laws for eight are all that is needed.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void for_all(const Row<D>& row, const F& f) const {
    const int end = first(row.end), shift = this->shift(row);
    int p = first(row.begin);
    for (; p + Wide::lanes <= end; p += Wide::lanes) f(Bundle<true>{p, shift});
    const int rest = end - p;
    if (rest > 0) f(Bundle<false, true>{p, rest, p + Wide::lanes <= first(row.owned_end), shift});
  }

  KOKKOS_INLINE_FUNCTION Vec<D> x(int p) const { return load<D>(position, p); }
  KOKKOS_INLINE_FUNCTION Vec<D> v(int p) const { return load<D>(velocity, p); }
  KOKKOS_INLINE_FUNCTION double& m(int p) const { return mass(p, 0); }
  KOKKOS_INLINE_FUNCTION double& vol(int p) const { return volume(p, 0); }

  template <class Column, class I>
  KOKKOS_FORCEINLINE_FUNCTION auto matrix(const Column& column, const I& p) const {
    MatOf<decltype(get(column, p)), D> value;
    for (int k = 0; k < D * D; ++k) value.a[k] = get(column, p, k);
    return value;
  }
  template <class Column, class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION void set_matrix(const Column& column, const I& p,
                                              const MatOf<T, D>& value) const {
    for (int k = 0; k < D * D; ++k) put(column, p, k, value.a[k]);
  }

  /// The stress tensor, tension positive; a pressure column gives -p I. [Pa]
  template <Stress kind, class I>
  KOKKOS_FORCEINLINE_FUNCTION static auto sigma(const Table<double>& column, const I& p) {
    SymOf<decltype(get(column, p))> s;
    if constexpr (kind == Stress::pressure)
      s[0] = s[1] = s[2] = -get(column, p);
    else
      for (int k = 0; k < G::stress_components; ++k) s[k] = get(column, p, k);
    return s;
  }
  template <Stress kind, class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION static void set_sigma(const Table<double>& column, const I& p,
                                                    const SymOf<T>& s) {
    if constexpr (kind == Stress::pressure)
      put(column, p, 0, -s[0]);
    else
      for (int k = 0; k < G::stress_components; ++k) put(column, p, k, s[k]);
  }
  template <Stress kind, class I>
  KOKKOS_FORCEINLINE_FUNCTION auto sigma(const I& p) const {
    return sigma<kind>(stress, p);
  }
  template <Stress kind, class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION void set_sigma(const I& p, const SymOf<T>& s) const {
    set_sigma<kind>(stress, p, s);
  }

  /// Half the edge along d of the box that the particle fills: its extents, brought to its volume.
  /// [m]
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto half_size(const I& p, int d) const {
    const auto v = get(volume, p);
    if constexpr (D == 1) return 0.5 * v;
    if (extent.extent(1) == 0) return 0.5 * root(v);
    auto box = get(extent, p, 0);
    for (int k = 1; k < D; ++k) box *= get(extent, p, k);
    return 0.5 * get(extent, p, d) * root(v / divisor(p, box));
  }

  /// The same in cells, as sized shapes take it.
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto half_length(const I& p, int d, double h) const {
    using T = decltype(get(volume, p));
    return clamp(half_size(p, d) * T(1 / h), T(1e-6), T(0.5));
  }

  /// Stretches the extents with a step's strain, if they are kept; none gets longer than four times
  /// another.
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION void stretch(const I& p, double dt) const {
    if (extent.extent(1) == 0) return;
    using T = decltype(get(volume, p));
    T longest = 0, length[D];
    for (int d = 0; d < D; ++d) {
      length[d] = get(extent, p, d) * most(1 + get(gradient, p, d * D + d) * T(dt), T(0.1));
      longest = most(longest, length[d]);
    }
    for (int d = 0; d < D; ++d) put(extent, p, d, most(length[d], 0.25 * longest));
  }

  /// The edge of a square or cube of volume v. [m]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T root(const T& v) {
    static_assert(D < 3, "three directions need a cubic root");
    return D == 2 ? sqrt(v) : v;
  }
  KOKKOS_FORCEINLINE_FUNCTION static double divisor(int, double value) { return value; }
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION static Wide divisor(const Bundle<full, repeats>& b,
                                                  const Wide& value) {
    return b.divisor(value);
  }

  /// Sorting writes each column into its neighbour's place, so that one spare column is all it
  /// needs: calls f(from, to) for the columns that are carried, ids included, in an order in which
  /// none is overwritten before it is read. They are known under their names again afterwards.
  /// All lie at the beginning of their margins then.
  template <class F>
  void rotate(const F& f) {
    for (int k = 0; k < carried_; ++k) {
      const int from = shifted_ ? k + 1 : carried_ - 1 - k, to = shifted_ ? k : carried_ - k;
      f(slot(from, offset_), slot(to, 0));
    }
    shifted_ = !shifted_;
    offset_ = 0;
    lay_out();
  }
  /// Calls f(column, spare) for the same columns, which stay in their places.
  template <class F>
  void each_slot(const F& f) const {
    for (int k = 0; k < carried_; ++k)
      f(slot(k + shifted_, offset_), slot(shifted_ ? 0 : carried_, offset_));
  }

  // Each column has a margin, before or behind it, so that it can be rewritten from one end on a
  // little further down, or from the other a little further up (core/wavefront.hpp).

  /// How far down the columns can be shifted, and how far up.
  int room_below() const { return offset_; }
  int room_above() const { return margin_ - offset_; }
  /// Makes room to shift by so many places from the beginning.
  void make_margin(int needed);
  /// What has been rewritten so many places further up is there now.
  void slide(int places);

 private:
  Table<double> store_;    ///< the carried columns, ids, and the spare one, side by side
  Table<double> passing_;  ///< what is not carried of gradient and work
  bool by_row_ = false;    ///< whether that has room for a row of each thread; else for all
  int row_room_ = 0;
  static constexpr int far_ahead = 128;  ///< particles: a kilobyte of each column
  int capacity_ = 0, carried_ = 0;
  int margin_ = 0, offset_ = 0;  ///< places beyond the capacity; those of them before the first
  bool shifted_ = false;         ///< whether the spare column is the first, else the last

  Array<double> slot(int k, int offset) const {
    return Kokkos::subview(store_, Kokkos::make_pair(offset, offset + capacity_), k);
  }
  void lay_out();
};

}  // namespace brisance
