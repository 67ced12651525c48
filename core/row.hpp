#pragma once
// How the bins of a lattice fall into rows, tiles and blocks.
#include "core/lattice.hpp"
#include "core/wide.hpp"

namespace brisance {

/// A run of neighbouring bins along x: bins begin .. end, the first of them at integer coordinates
/// `base`.
template <int D>
struct Row {
  /// Bins in one row: long enough to amortise its start, short enough for the cache.
  static constexpr int length = 32;
  static constexpr int tiles = length / Wide::lanes;

  int begin, end;
  int base[D];
  int line_end;   ///< end of the bins of the whole line
  int owned_end;  ///< end of the bins that the same thread works on
  int number;     ///< from 0 on, for results of its own
  int thread;     ///< that works on it, where threads keep something of their own
};

/// How the bins of a lattice fall into rows and these into blocks, whatever the number of threads.
/// A block's particles reach the nodes of the block after next in no shape.
template <int D>
struct RowLayout {
  static constexpr int length = Row<D>::length;
  /// Of two directions, four lines of bins: as wide as the widest shape.
  static constexpr int lines_in_block = D == 1 ? 1 : 4;

  Lattice<D> lattice;
  int line, pieces, rows, rows_in_block, blocks;

  explicit RowLayout(const Lattice<D>& lattice_)
      : lattice(lattice_),
        line(lattice.extent(0)),
        pieces((line + length - 1) / length),
        rows(pieces * (lattice.size / line)),
        rows_in_block(D == 1 ? 1 : lines_in_block * pieces),
        blocks((rows + rows_in_block - 1) / rows_in_block) {}

  /// Of a block, whose bins are the nodes that no block before reaches but its neighbour.
  int first_bin(int block) const {
    const int bins = D == 1 ? length : lines_in_block * line;
    return block < blocks ? block * bins : lattice.size;
  }

  KOKKOS_INLINE_FUNCTION Row<D> row(int number) const {
    const int piece = number % pieces, start = number / pieces * line;
    Row<D> r;
    r.number = number;
    r.thread = 0;
    r.begin = start + piece * length;
    r.line_end = start + line;
    r.end = piece + 1 < pieces ? r.begin + length : r.line_end;
    const int block_end = (number / rows_in_block + 1) * (rows_in_block / pieces) * line;
    r.owned_end = D == 1 || !kernels_on_host ? r.end
                  : block_end < lattice.size ? block_end
                                             : lattice.size;
    lattice.coordinates(r.begin, r.base);
    return r;
  }
};

}  // namespace brisance
