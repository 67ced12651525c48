#pragma once
// The background lattice of square cells and its only index function. Nodes, cells (named by their
// lowest node) and bins of particles (named by the first node their shape touches) share one
// numbering, with one layer of halo.
#include "core/types.hpp"

namespace brisance {

template <int D>
struct Lattice {
  static constexpr int halo = 1;

  double origin[D] = {};  ///< position of node 0 [m]
  double h = 1;           ///< cell size [m]
  double per_h = 1;       ///< [1/m]
  int cells[D] = {};      ///< cells inside the domain
  int stride[D] = {};
  int size = 0;  ///< nodes including the halo

  Lattice() = default;
  Lattice(const double (&origin_)[D], const int (&cells_)[D], double h_) : h(h_), per_h(1 / h_) {
    size = 1;
    for (int d = 0; d < D; ++d) {
      origin[d] = origin_[d];
      cells[d] = cells_[d];
      stride[d] = size;
      size *= extent(d);
    }
  }

  /// Nodes along a direction, halo included.
  KOKKOS_INLINE_FUNCTION int extent(int d) const { return cells[d] + 1 + 2 * halo; }

  /// The number of the node at integer coordinates i, each from -halo to cells + halo.
  KOKKOS_INLINE_FUNCTION int index(const int (&i)[D]) const {
    int n = 0;
    for (int d = 0; d < D; ++d) n += (i[d] + halo) * stride[d];
    return n;
  }

  KOKKOS_INLINE_FUNCTION void coordinates(int index, int (&i)[D]) const {
    for (int d = D - 1; d > 0; --d) {
      const int n = index / stride[d];
      i[d] = n - halo;
      index -= n * stride[d];
    }
    i[0] = index - halo;
  }

  /// A position in cells from node 0.
  KOKKOS_FORCEINLINE_FUNCTION double in_cells(double x, int d) const {
    return (x - origin[d]) * per_h;
  }

  /// The cell that holds a position inside the domain.
  KOKKOS_FORCEINLINE_FUNCTION int cell_of(const Vec<D>& x) const {
    int i[D];
    for (int d = 0; d < D; ++d) {
      const int k = static_cast<int>(floor(in_cells(x[d], d)));
      i[d] = k < 0 ? 0 : (k < cells[d] ? k : cells[d] - 1);
    }
    return index(i);
  }

  KOKKOS_INLINE_FUNCTION double cell_volume() const {
    double v = 1;
    for (int d = 0; d < D; ++d) v *= h;
    return v;
  }
};

}  // namespace brisance
