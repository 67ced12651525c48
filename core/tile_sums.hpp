#pragma once
// What tiles have summed, on its way to the nodes.
#include <type_traits>

#include "core/stencil.hpp"
#include "core/tile.hpp"

namespace brisance {

/// Adds, for C columns from `column` on, what the bins of tiles have for the W^D nodes, or cells,
/// from `offset` on from each. Of a row, tile after tile; flush() when it is done.
///
/// The bins of a whole tile reach W - 1 places beyond the eight of their own along x. What is meant
/// for those is held until the next tile comes, whose own they are: then each place is read and
/// written once. Eight places after eight others that overlap them would be read only when those
/// are in the cache, which made up a third of the transfer of momentum.
template <int D, int W, int C, class To>
class TileSums {
 public:
  using N = Around<D, W>;
  using Sums = Wide[C][N::count];

  KOKKOS_FORCEINLINE_FUNCTION TileSums(const To& to, const Lattice<D>& lattice, int column = 0,
                                       int offset = 0)
      : to_(to), lattice_(lattice), column_(column), offset_(offset) {}

  /// Lanes without particles must have zeros.
  KOKKOS_FORCEINLINE_FUNCTION void add(const Tile& tile, const Sums& sum) {
    if constexpr (eight_at_once) {
      if (tile.whole) {
        add_whole(tile, sum);
        return;
      }
      flush();
    }
    tile.for_lanes([&](int lane, int bin) {
      for (int k = 0; k < N::count; ++k)
        for (int c = 0; c < C; ++c) to_(place(bin, k), column_ + c) += sum[c][k][lane];
    });
  }

  KOKKOS_FORCEINLINE_FUNCTION void flush() {
    if constexpr (eight_at_once) {
      if (next_ < 0) return;
      for (int line = 0; line < lines; ++line)
        for (int c = 0; c < C; ++c)
          for (int m = 0; m < W - 1; ++m) {
            double rest = 0;
            for (int i = m + 1; i < W; ++i) rest += held_[c][line][i][Wide::lanes + m - i];
            to_(place(next_ + m, line * W), column_ + c) += rest;
          }
      next_ = -1;
    }
  }

 private:
  static constexpr bool eight_at_once = std::is_same<To, Table<double>>::value;
  static constexpr int lines = power(W, D - 1);

  const To& to_;
  const Lattice<D>& lattice_;
  int column_, offset_;
  int next_ = -1;           ///< the bin after the last tile, if anything is held
  Wide held_[C][lines][W];  ///< for the places i further on than the bins of the last tile

  KOKKOS_FORCEINLINE_FUNCTION int place(int bin, int k) const {
    return bin + offset_ + N::offset(lattice_, k);
  }

  KOKKOS_FORCEINLINE_FUNCTION void add_whole(const Tile& tile, const Sums& sum) {
    if (next_ != tile.bin) flush();
    const bool follows = next_ == tile.bin;
    const Wide::Flags lanes = tile.order.lanes();
    for (int line = 0; line < lines; ++line)
      for (int c = 0; c < C; ++c) {
        double* const there = &to_(place(tile.bin, line * W), column_ + c);
        Wide all = Wide::read(there) + sum[c][line * W].permuted(lanes);
        Wide* const held = held_[c][line];
        for (int i = 1; i < W; ++i) {
          const Wide here = sum[c][line * W + i].permuted(lanes);
          all += Wide::behind(follows ? held[i] : Wide(), here, i);
          held[i] = here;
        }
        all.write(there);
      }
    next_ = tile.bin + Wide::lanes;
  }
};

}  // namespace brisance
