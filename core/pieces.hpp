#pragma once
// Loops over the nodes or cells of a lattice, eight neighbours at a time, in pieces that threads
// share.
#include "core/lattice.hpp"
#include "core/tile.hpp"

namespace brisance {

/// All nodes, or cells, of a field.
struct AllNodes {
  static constexpr int length = 1024;

  int size;
  int count = (size + length - 1) / length;

  /// Calls f(bundle) for those of piece k.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void of_piece(int k, const F& f) const {
    const int end = (k + 1) * length < size ? (k + 1) * length : size;
    int n = k * length;
    for (; n + Wide::lanes <= end; n += Wide::lanes) f(Bundle<true>{n});
    if (n < end) f(Bundle<false, true>{n, end - n, false});
  }
};

/// The cells inside the domain, line by line.
template <int D>
struct InnerCells {
  static_assert(D < 3, "planes of lines are missing");
  static constexpr int length = 256;

  Lattice<D> lattice;
  int pieces = (lattice.cells[0] + length - 1) / length,
      count = pieces * (D == 1 ? 1 : lattice.cells[D - 1]);

  /// Calls f(bundle) for the cells of piece k, whose neighbours it may read.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void of_piece(int k, const F& f) const {
    int i[D] = {k % pieces * length}, reach = Wide::lanes;
    if constexpr (D == 2) i[1] = k / pieces;
    for (int d = 0; d < D; ++d) reach += lattice.stride[d];
    int c = lattice.index(i);
    const int rest = lattice.cells[0] - i[0], end = c + (rest < length ? rest : length);
    for (; c + Wide::lanes <= end; c += Wide::lanes) f(Bundle<true>{c});
    if (c < end) f(Bundle<false, true>{c, end - c, c + reach <= lattice.size});
  }
};

/// f(bundle) for each. One by one, with a division for each number, nodes take three times as long.
template <class Pieces, class F>
void for_each(const char* name, const Pieces& pieces, const F& f) {
  Kokkos::parallel_for(
      name, Kokkos::RangePolicy<Space, Kokkos::Schedule<Kokkos::Dynamic>>(0, pieces.count),
      KOKKOS_LAMBDA(const int k) { pieces.of_piece(k, f); });
}

/// What keeps the greatest of the answers of f.
template <class F>
struct Greatest {
  F f;
  double& so_far;
  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const Bundle& b) const {
    so_far = most(so_far, greatest(f(b)));
  }
};

/// The greatest f(bundle) of all, or 0.
template <class Pieces, class F>
double greatest_of(const char* name, const Pieces& pieces, const F& f) {
  double all = 0;
  Kokkos::parallel_reduce(
      name, Kokkos::RangePolicy<Space>(0, pieces.count),
      KOKKOS_LAMBDA(const int k, double& so_far) {
        pieces.of_piece(k, Greatest<F>{f, so_far});
      },
      Kokkos::Max<double>(all));
  return all;
}

}  // namespace brisance
