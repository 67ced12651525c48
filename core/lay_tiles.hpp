#pragma once
// From particles in the order of their bins to the order of tiles.
#include "core/row.hpp"
#include "core/tile.hpp"

namespace brisance {

/// How many particles each bin of a tile holds, and the order in which its bins stand.
struct TileCounts {
  int of_bin[Wide::lanes];
  TileOrder order;

  /// Of the bins from `bin` to `end`, eight at most.
  KOKKOS_INLINE_FUNCTION TileCounts(const Array<int>& first, int bin, int end) {
    bool falling = true;
    for (int b = 0; b < Wide::lanes; ++b) {
      of_bin[b] = bin + b < end ? first(bin + b + 1) - first(bin + b) : 0;
      falling = falling && (b == 0 || of_bin[b] <= of_bin[b - 1]);
    }
    if (!falling) order = TileOrder::by(of_bin);
  }
};

/// Of the particles of a row: sorted(place) tells them bin by bin, first(bin) where the bins begin.
/// Calls tiled(place, particle) in the order of tiles, and sets the TileOrders.
template <int D, class Sorted, class Tiled>
KOKKOS_INLINE_FUNCTION void lay_tiles(const Row<D>& row, const Array<int>& first,
                                      const Array<TileOrder>& order, const Sorted& sorted,
                                      const Tiled& tiled) {
  int number = row.number * Row<D>::tiles;
  for (int bin = row.begin; bin < row.end; bin += Wide::lanes, ++number) {
    order(number) = TileCounts(first, bin, row.end).order;
    const Tile tile(first, bin, row.end, row.line_end, order(number), first(row.end));
    int next[Wide::lanes] = {};
    tile.for_lanes([&](int lane, int b) { next[lane] = first(b); });
    tile.for_bundles([&](const auto& bundle) {
      for (int lane = 0; lane < bundle.size(); ++lane)
        tiled(bundle.first + lane, sorted(next[lane]++));
    });
  }
}

}  // namespace brisance
