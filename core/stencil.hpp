#pragma once
// A particle's view of the nodes around it: weights, slopes and arms on the width^dim nodes of its
// bin.
#include "core/particles.hpp"

namespace brisance {

template <class G, class S>
struct Stencil {
  static constexpr int D = G::dim, W = S::width, nodes = power(W, D);

  double w[D][W], slope[D][W], arm_[D][W];

  /// Of particle p in the bin at integer coordinates `base`.
  KOKKOS_INLINE_FUNCTION Stencil(const Lattice<D>& lattice, const int (&base)[D],
                                 const Particles<G>& points, int p) {
    const double per_h = 1 / lattice.h;
    for (int d = 0; d < D; ++d) {
      const double at = lattice.in_cells(points.position(p, d), d) - base[d];
      double half = 0;
      if constexpr (S::sized) half = points.half_length(p, d, lattice.h);
      S::at(at, half, w[d], slope[d]);
      for (int k = 0; k < W; ++k) {
        slope[d][k] *= per_h;
        arm_[d][k] = (k - at) * lattice.h;
      }
    }
  }

  /// Position of node n of the stencil along direction d.
  KOKKOS_INLINE_FUNCTION static constexpr int digit(int n, int d) { return n / power(W, d) % W; }

  KOKKOS_INLINE_FUNCTION static int offset(const Lattice<D>& lattice, int n) {
    int sum = 0;
    for (int d = 0; d < D; ++d) sum += digit(n, d) * lattice.stride[d];
    return sum;
  }

  KOKKOS_INLINE_FUNCTION double weight(int n) const {
    double product = 1;
    for (int d = 0; d < D; ++d) product *= w[d][digit(n, d)];
    return product;
  }

  /// Gradient of the weight. [1/m]
  KOKKOS_INLINE_FUNCTION Vec<D> gradient(int n) const {
    Vec<D> g;
    for (int d = 0; d < D; ++d) {
      double product = slope[d][digit(n, d)];
      for (int k = 0; k < D; ++k)
        if (k != d) product *= w[k][digit(n, k)];
      g[d] = product;
    }
    return g;
  }

  /// From the particle to the node. [m]
  KOKKOS_INLINE_FUNCTION Vec<D> arm(int n) const {
    Vec<D> r;
    for (int d = 0; d < D; ++d) r[d] = arm_[d][digit(n, d)];
    return r;
  }
};

/// The gradient of the (linear) weights at the centre of a cell. [1/m]
template <class G>
KOKKOS_INLINE_FUNCTION Vec<G::dim> centre_gradient(int n, double h) {
  Vec<G::dim> g;
  for (int d = 0; d < G::dim; ++d) g[d] = ((n >> d & 1) ? 1 : -1) / (h * power(2, G::dim - 1));
  return g;
}

/// The nodes of a bin, their values loaded once for all its particles.
template <class G, class S, int C>
struct Nodes {
  static constexpr int count = power(S::width, G::dim);
  double value[count][C];
  KOKKOS_INLINE_FUNCTION Nodes(const Table<double>& field, const Lattice<G::dim>& lattice,
                               int bin) {
    for (int n = 0; n < count; ++n) {
      const int node = bin + Stencil<G, S>::offset(lattice, n);
      for (int c = 0; c < C; ++c) value[n][c] = field(node, c);
    }
  }
  KOKKOS_INLINE_FUNCTION Vec<C> operator[](int n) const {
    Vec<C> v;
    for (int c = 0; c < C; ++c) v[c] = value[n][c];
    return v;
  }
};

}  // namespace brisance
