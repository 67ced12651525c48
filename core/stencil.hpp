#pragma once
// How particles see the nodes around them: weights, slopes and arms on the width^dim nodes of their
// bins, for eight particles in eight bins at once.
#include "core/particles.hpp"
#include "core/tile.hpp"

namespace brisance {

/// The nodes of a bin, numbered along x first.
template <int D, int W>
struct Around {
  static constexpr int count = power(W, D);
  /// Position of node k along direction d.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int digit(int k, int d) {
    return k / power(W, d) % W;
  }
  KOKKOS_FORCEINLINE_FUNCTION static int offset(const Lattice<D>& lattice, int k) {
    int sum = 0;
    for (int d = 0; d < D; ++d) sum += digit(k, d) * lattice.stride[d];
    return sum;
  }
};

template <class G, class S>
struct Stencil {
  static constexpr int D = G::dim, W = S::width;
  using N = Around<D, W>;

  Wide w[D][W], slope[D][W];  ///< along each direction; slopes per cell
  Wide t[D];                  ///< places of the particles, in cells from their first nodes

  /// Of particles in bins at the integer coordinates `base`.
  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION Stencil(const Lattice<D>& lattice, const Wide (&base)[D],
                                      const Particles<G>& points, const Bundle& b) {
    for (int d = 0; d < D; ++d) {
      t[d] = (points.get(points.position, b, d) - lattice.origin[d]) * lattice.per_h - base[d];
      Wide half;
      if constexpr (S::sized) half = points.half_length(b, d, lattice.h);
      S::at(t[d], half, w[d], slope[d]);
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION Wide weight(int k) const {
    Wide product = w[0][N::digit(k, 0)];
    for (int d = 1; d < D; ++d) product *= w[d][N::digit(k, d)];
    return product;
  }

  /// Component d of the gradient of the weight. [1/cell]
  KOKKOS_FORCEINLINE_FUNCTION Wide gradient(int k, int d) const {
    Wide product = slope[d][N::digit(k, d)];
    for (int e = 0; e < D; ++e)
      if (e != d) product *= w[e][N::digit(k, e)];
    return product;
  }

  /// From the particle to the node. [cells]
  KOKKOS_FORCEINLINE_FUNCTION Wide arm(int k, int d) const { return N::digit(k, d) - t[d]; }
};

/// Values at the nodes of the bins of a tile, loaded or summed once for all its particles.
template <class G, class S, int C>
struct Nodes {
  static constexpr int D = G::dim;
  using N = Around<D, S::width>;
  Wide value[C][N::count];

  Nodes() = default;
  KOKKOS_FORCEINLINE_FUNCTION Nodes(const Table<double>& field, const Lattice<D>& lattice,
                                    const Tile& tile, int column = 0) {
    tile.read_by([&](const auto& read) BRISANCE_INLINE {
      for (int c = 0; c < C; ++c)
        for (int k = 0; k < N::count; ++k)
          value[c][k] = read(field, column + c, N::offset(lattice, k));
    });
  }
};

/// A nodal field at any place in a bin: sum over nodes of N v, and its derivatives.
template <class G, class S, int C, bool linear = S::width == 2>
class Interpolant {
 public:
  using At = Stencil<G, S>;
  using N = typename At::N;
  static constexpr int D = G::dim;

  Interpolant() = default;
  KOKKOS_FORCEINLINE_FUNCTION explicit Interpolant(const Nodes<G, S, C>& nodes) : nodes_(nodes) {}

  KOKKOS_FORCEINLINE_FUNCTION Wide at(const At& at, int c) const { return sum(at, c, D); }
  /// Along direction d. [1/cell]
  KOKKOS_FORCEINLINE_FUNCTION Wide slope(const At& at, int c, int d) const { return sum(at, c, d); }

 private:
  Nodes<G, S, C> nodes_;

  /// With slopes in place of weights along direction d, line by line.
  KOKKOS_FORCEINLINE_FUNCTION Wide sum(const At& at, int c, int d) const {
    constexpr int W = S::width;
    Wide all;
    for (int line = 0; line < power(W, D - 1); ++line) {
      Wide part;
      for (int i = 0; i < W; ++i)
        part += (d == 0 ? at.slope : at.w)[0][i] * nodes_.value[c][line * W + i];
      for (int e = 1; e < D; ++e) part *= (d == e ? at.slope : at.w)[e][line / power(W, e - 1) % W];
      all += part;
    }
    return all;
  }
};

/// Of the linear shape, as the polynomial that it is: c0 + c1 x + y (c2 + c3 x).
template <class G, class S, int C>
class Interpolant<G, S, C, true> {
 public:
  using At = Stencil<G, S>;
  static constexpr int D = G::dim;
  static_assert(D < 3, "three directions need eight coefficients");

  Interpolant() = default;
  KOKKOS_FORCEINLINE_FUNCTION explicit Interpolant(const Nodes<G, S, C>& nodes) {
    for (int c = 0; c < C; ++c) {
      const auto& v = nodes.value[c];
      c_[c][0] = v[0];
      c_[c][1] = v[1] - v[0];
      if constexpr (D == 2) {
        c_[c][2] = v[2] - v[0];
        c_[c][3] = (v[3] - v[2]) - (v[1] - v[0]);
      }
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION Wide at(const At& at, int c) const {
    Wide sum = c_[c][0] + c_[c][1] * at.t[0];
    if constexpr (D == 2) sum += at.t[1] * (c_[c][2] + c_[c][3] * at.t[0]);
    return sum;
  }
  KOKKOS_FORCEINLINE_FUNCTION Wide slope(const At& at, int c, int d) const {
    if constexpr (D == 1)
      return c_[c][1];
    else
      return c_[c][1 + d] + c_[c][3] * at.t[1 - d];
  }
  /// At the centre of the cell.
  KOKKOS_FORCEINLINE_FUNCTION Wide centre_slope(int c, int d) const {
    if constexpr (D == 1)
      return c_[c][1];
    else
      return c_[c][1 + d] + 0.5 * c_[c][3];
  }

 private:
  Wide c_[C][power(2, D)];
};

/// Component d of the gradient of the linear weights at the centre of a cell. [1/cell]
template <class G>
KOKKOS_FORCEINLINE_FUNCTION constexpr double centre_gradient(int k, int d) {
  return (Around<G::dim, 2>::digit(k, d) == 1 ? 1. : -1.) / power(2, G::dim - 1);
}

}  // namespace brisance
