#include "core/sort.hpp"

#include <algorithm>

#include "core/geometry.hpp"
#include "core/lay_tiles.hpp"

namespace brisance {
namespace {

int count_of(const Kokkos::View<int, Space>& number) {
  int on_host = 0;
  Kokkos::deep_copy(on_host, number);
  return on_host;
}

/// Counts chunks of particles by bins. A chunk touches but those from its lowest to its highest
/// bin, few once particles have been sorted: no others are cleared, nor looked at after. (A scan
/// over the bins of all chunks took two threads as long as one, and on a grid with as many nodes as
/// particles a twentieth of a step.)
struct CountBins {
  int count, per_chunk;
  Array<int> bin;
  Table<int> counts;
  Array<BinRange> touched;

  KOKKOS_INLINE_FUNCTION int begin(int chunk) const { return chunk * per_chunk; }
  KOKKOS_INLINE_FUNCTION int end(int chunk) const {
    return (chunk + 1) * per_chunk < count ? (chunk + 1) * per_chunk : count;
  }
  KOKKOS_INLINE_FUNCTION void operator()(const int c) const {
    if (begin(c) >= end(c)) {
      touched(c) = {0, 0};
      return;
    }
    BinRange range{bin(begin(c)), 0};
    for (int p = begin(c); p < end(c); ++p) {
      range.begin = bin(p) < range.begin ? bin(p) : range.begin;
      range.end = bin(p) < range.end ? range.end : bin(p) + 1;
    }
    touched(c) = range;
    for (int b = range.begin; b < range.end; ++b) counts(b, c) = 0;
    for (int p = begin(c); p < end(c); ++p) ++counts(bin(p), c);
  }
};

/// first(bin) <- where the particles of a bin begin, counts <- where those of each chunk do: a scan
/// over blocks of bins.
struct PlaceBins {
  static constexpr int size = 256;

  int bins, chunks;
  Table<int> counts;
  Array<BinRange> touched;
  Array<int> first;

  int blocks() const { return (bins + size - 1) / size; }

  KOKKOS_INLINE_FUNCTION void operator()(const int k, int& place, bool last) const {
    const BinRange block{k * size, (k + 1) * size < bins ? (k + 1) * size : bins};
    int from = place, all = 0;
    for_touched(block, [&](int c, int b) { all += counts(b, c); });
    place += all;
    if (!last) return;
    int next[size] = {};
    for_touched(block, [&](int c, int b) { next[b - block.begin] += counts(b, c); });
    for (int b = block.begin; b < block.end; ++b) {
      const int n = next[b - block.begin];
      first(b) = next[b - block.begin] = from;
      from += n;
    }
    if (block.end == bins) first(bins) = from;
    for_touched(block, [&](int c, int b) {
      const int n = counts(b, c);
      counts(b, c) = next[b - block.begin];
      next[b - block.begin] += n;
    });
  }

 private:
  /// Calls f(chunk, bin).
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_touched(const BinRange& block, const F& f) const {
    for (int c = 0; c < chunks; ++c) {
      const int begin = touched(c).begin > block.begin ? touched(c).begin : block.begin,
                end = touched(c).end < block.end ? touched(c).end : block.end;
      for (int b = begin; b < end; ++b) f(c, b);
    }
  }
};

/// to(i) <- from(source(i)) for begin <= i < end.
void permute(const Array<double>& from, const Array<int>& source, const Array<double>& to,
             int begin, int end) {
  Kokkos::parallel_for(
      "permute", Kokkos::RangePolicy<Space>(begin, end),
      KOKKOS_LAMBDA(const int i) { to(i) = from(source(i)); });
}

/// tiled <- sorted, a list of particles bin by bin, in the order of tiles. Says between which rows
/// particles are out of place, and how many the fullest row holds.
template <int D>
struct LayTiles {
  RowLayout<D> layout;
  Array<int> first, sorted, tiled;
  Array<TileOrder> order;

  KOKKOS_INLINE_FUNCTION void operator()(const int k, int& first_moved, int& last_moved,
                                         int& fullest) const {
    const Row<D> row = layout.row(k);
    if (first(row.begin) == first(row.end)) return;
    int differs = 0;
    lay_tiles(
        row, first, order, [&](int place) { return sorted(place); },
        [&](int place, int source) {
          tiled(place) = source;
          differs |= source ^ place;
        });
    const int begin = first(row.begin), end = first(row.end);
    fullest = end - begin > fullest ? end - begin : fullest;
    if (differs == 0) return;
    first_moved = begin < first_moved ? begin : first_moved;
    last_moved = end - 1 > last_moved ? end - 1 : last_moved;
  }
};

}  // namespace

template <class G>
int Sorter<G>::sort(Particles<G>& particles, const Transfer<G>& transfer,
                    const Lattice<G::dim>& lattice) {
  transfer.find_bins(lattice, particles);
  return sort(particles, lattice);
}

template <class G>
int Sorter<G>::sort(Particles<G>& particles, const Lattice<G::dim>& lattice) {
  const int count = particles.count,
            bins = lattice.size + 1;  // the last bin: particles that have left
  const int chunks = std::max(1, std::min<int>(Space().concurrency(), count / 1024));
  const int per_chunk = (count + chunks - 1) / chunks;
  if (static_cast<int>(source_.extent(0)) < count) {
    source_ = Array<int>("order of particles", particles.capacity());
  }
  if (static_cast<int>(counts_.extent(0)) != bins || static_cast<int>(counts_.extent(1)) < chunks)
    counts_ = Table<int>("bin counts", bins, chunks);
  if (static_cast<int>(touched_.extent(0)) < chunks)
    touched_ = Array<BinRange>("bins touched", chunks);
  if (static_cast<int>(particles.first.extent(0)) != bins + 1)
    particles.first = Array<int>("first of bin", bins + 1);

  const auto bin = particles.bin, source = source_;
  const auto counts = counts_;
  const auto first = particles.first;
  const CountBins count_bins{count, per_chunk, bin, counts, touched_};
  const PlaceBins place_bins{bins, chunks, counts, touched_, first};
  const Kokkos::RangePolicy<Space> over_chunks(0, chunks);
  Kokkos::parallel_for("count bins", over_chunks, count_bins);
  Kokkos::parallel_scan("places of bins", Kokkos::RangePolicy<Space>(0, place_bins.blocks()),
                        place_bins);
  Kokkos::parallel_for(
      "order of particles", over_chunks, KOKKOS_LAMBDA(const int c) {
        for (int p = count_bins.begin(c); p < count_bins.end(c); ++p)
          source(counts(bin(p), c)++) = p;
      });

  const int inside = count_of(Kokkos::subview(first, lattice.size));
  const RowLayout<G::dim> layout(lattice);
  const int tiles = layout.rows * Row<G::dim>::tiles;
  if (static_cast<int>(particles.order.extent(0)) != tiles)
    particles.order = Array<TileOrder>("order of tiles", tiles);
  const auto tiled = bin;  // the bins are not asked for any more
  int first_moved = 0, last_moved = 0, fullest = 0;
  Kokkos::parallel_reduce("lay tiles", Kokkos::RangePolicy<Space>(0, layout.rows),
                          LayTiles<G::dim>{layout, first, source, tiled, particles.order},
                          Kokkos::Min<int>(first_moved), Kokkos::Max<int>(last_moved),
                          Kokkos::Max<int>(fullest));
  if (inside < count) {
    const auto left = Kokkos::make_pair(inside, count);
    Kokkos::deep_copy(Kokkos::subview(tiled, left), Kokkos::subview(source, left));
    first_moved = std::min(first_moved, inside);
    last_moved = count - 1;
  }

  // Of a few that are out of place only the stretch between the first and the last is rewritten:
  // ahead of a blast nothing moves.
  using Column = Array<double>;
  const bool any = first_moved <= last_moved;
  const int begin = any ? first_moved : 0, end = any ? last_moved + 1 : 0;
  most_moved_ = end - begin > count / 2;
  if (most_moved_)
    particles.rotate(
        [&](const Column& from, const Column& to) { permute(from, tiled, to, 0, count); });
  else if (any)
    particles.each_slot([&](const Column& column, const Column& spare) {
      permute(column, tiled, spare, begin, end);
      const auto stretch = Kokkos::make_pair(begin, end);
      Kokkos::deep_copy(Kokkos::subview(column, stretch), Kokkos::subview(spare, stretch));
    });

  particles.make_room_for_row(fullest);
  particles.count = inside;
  return count - inside;
}

template class Sorter<Line>;
template class Sorter<PlaneStrain>;

}  // namespace brisance
