#pragma once
// A particle's view of the nodes around it: weights, slopes and arms on the width^dim nodes of its
// bin, several nodes in a pack.
#include "core/pack.hpp"
#include "core/particles.hpp"

namespace brisance {

/// How nodes fall into packs: those of a line along x in the lanes of one, one pack after the other
/// for the lines; the two lines of a linear shape together in one. Lanes beyond the width weigh
/// nothing.
template <int D, int W>
struct Lanes {
  static constexpr bool square = D > 1 && W == 2;
  static constexpr int count = square || W > 2 ? 4 : 2;
  static constexpr int packed = square ? 2 : 1;  ///< directions that lie in a pack
  static constexpr int packs = power(W, D - packed);

  KOKKOS_FORCEINLINE_FUNCTION static constexpr bool used(int lane) { return square || lane < W; }
  /// Position in the stencil along direction d.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int digit(int pack, int lane, int d) {
    if (d < packed) return square ? lane >> d & 1 : lane;
    return pack / power(W, d - packed) % W;
  }
  KOKKOS_FORCEINLINE_FUNCTION static int offset(const Lattice<D>& lattice, int pack, int lane) {
    int sum = 0;
    for (int d = 0; d < D; ++d) sum += digit(pack, lane, d) * lattice.stride[d];
    return sum;
  }
};

template <class G, class S>
struct Stencil {
  static constexpr int D = G::dim, W = S::width;
  using L = Lanes<D, W>;
  static constexpr int packs = L::packs;
  using P = Pack<L::count>;

  /// Along the directions that lie in a pack, and along the others.
  P w_in[L::packed], slope_in[L::packed], arm_in[L::packed];
  double w[D][W], slope[D][W], arm_[D][W];
  double t[D];  ///< place of the particle, in cells from the first node
  P weight[packs];

  /// Of particle p in the bin at integer coordinates `base`.
  KOKKOS_FORCEINLINE_FUNCTION Stencil(const Lattice<D>& lattice, const int (&base)[D],
                                      const Particles<G>& points, int p) {
    const double per_h = lattice.per_h;
    for (int d = 0; d < D; ++d) {
      const double at = lattice.in_cells(points.position(p, d), d) - base[d];
      t[d] = at;
      double half = 0;
      if constexpr (S::sized) half = points.half_length(p, d, lattice.h);
      if (d < L::packed && S::degree > 0) {
        pack(d, at - S::centre, per_h);
      } else {
        S::at(at, half, w[d], slope[d]);
        for (int k = 0; k < W; ++k) slope[d][k] *= per_h;
        if (d < L::packed) pack(d);
      }
      if (d < L::packed)
        arm_in[d] = (digits(d) - P(at)) * P(lattice.h);
      else
        for (int k = 0; k < W; ++k) arm_[d][k] = (k - at) * lattice.h;
    }
    for (int k = 0; k < packs; ++k) {
      weight[k] = w_in[0];
      for (int d = 1; d < D; ++d) weight[k] *= along(w_in, w, k, d);
    }
  }

  /// Component d of the gradient of the weight. [1/m]
  KOKKOS_FORCEINLINE_FUNCTION P gradient(int k, int d) const {
    P product = along(slope_in, slope, k, d);
    for (int e = 0; e < D; ++e)
      if (e != d) product *= along(w_in, w, k, e);
    return product;
  }

  /// From the particle to the node. [m]
  KOKKOS_FORCEINLINE_FUNCTION P arm(int k, int d) const { return along(arm_in, arm_, k, d); }

 private:
  KOKKOS_FORCEINLINE_FUNCTION static P along(const P (&in)[L::packed], const double (&out)[D][W],
                                             int k, int d) {
    return d < L::packed ? in[d] : P(out[d][L::digit(k, 0, d)]);
  }

  KOKKOS_FORCEINLINE_FUNCTION static P digits(int d) {
    double k[L::count];
    for (int lane = 0; lane < L::count; ++lane) k[lane] = L::digit(0, lane, d);
    return P::of(k);
  }

  /// The coefficients of x^m of all lanes.
  KOKKOS_FORCEINLINE_FUNCTION static P coefficients(int m, int d) {
    double c[L::count];
    for (int lane = 0; lane < L::count; ++lane)
      c[lane] = L::used(lane) ? S::coefficient(L::digit(0, lane, d), m) : 0;
    return P::of(c);
  }

  /// Polynomials in x, the place from the shape's centre.
  KOKKOS_FORCEINLINE_FUNCTION void pack(int d, double x, double per_h) {
    P value = coefficients(S::degree, d), rate;
    for (int m = S::degree; m > 0; --m) {
      rate = rate * P(x) + value;
      value = value * P(x) + coefficients(m - 1, d);
    }
    w_in[d] = value;
    slope_in[d] = rate * P(per_h);
  }

  /// Of a shape that is no polynomial, from what stands in w and slope.
  KOKKOS_FORCEINLINE_FUNCTION void pack(int d) {
    double value[L::count] = {}, rate[L::count] = {};
    for (int lane = 0; lane < L::count; ++lane) {
      if (!L::used(lane)) continue;
      value[lane] = w[d][L::digit(0, lane, d)];
      rate[lane] = slope[d][L::digit(0, lane, d)];
    }
    w_in[d] = P::of(value);
    slope_in[d] = P::of(rate);
  }
};

/// The nodes of a bin, their values loaded once for all its particles.
template <class G, class S, int C>
struct Nodes {
  using L = Lanes<G::dim, S::width>;
  using P = Pack<L::count>;
  P value[C][L::packs];

  Nodes() = default;
  KOKKOS_FORCEINLINE_FUNCTION Nodes(const Table<double>& field, const Lattice<G::dim>& lattice,
                                    int bin, int column = 0) {
    for (int c = 0; c < C; ++c)
      for (int k = 0; k < L::packs; ++k) {
        double here[L::count] = {};
        for (int lane = 0; lane < L::count; ++lane)
          if (L::used(lane)) here[lane] = field(bin + L::offset(lattice, k, lane), column + c);
        value[c][k] = P::of(here);
      }
  }

  template <class To>
  KOKKOS_FORCEINLINE_FUNCTION void add_to(const To& to, const Lattice<G::dim>& lattice, int bin,
                                          int column = 0) const {
    for (int c = 0; c < C; ++c)
      for (int k = 0; k < L::packs; ++k)
        for (int lane = 0; lane < L::count; ++lane)
          if (L::used(lane)) to(bin + L::offset(lattice, k, lane), column + c) += value[c][k][lane];
  }
};

/// A nodal field at any place in a bin: sum over nodes of N v, and its derivatives.
template <class G, class S, int C, bool linear = S::width == 2>
class Interpolant {
 public:
  static constexpr int packs = Nodes<G, S, C>::L::packs;
  using P = typename Nodes<G, S, C>::P;

  Interpolant() = default;
  KOKKOS_FORCEINLINE_FUNCTION explicit Interpolant(const Nodes<G, S, C>& nodes) : nodes_(nodes) {}

  KOKKOS_FORCEINLINE_FUNCTION double at(const Stencil<G, S>& at, int c) const {
    P sum;
    for (int k = 0; k < packs; ++k) sum += at.weight[k] * nodes_.value[c][k];
    return sum.sum();
  }
  /// Along direction d. [1/m]
  KOKKOS_FORCEINLINE_FUNCTION double slope(const Stencil<G, S>& at, int c, int d, double) const {
    P sum;
    for (int k = 0; k < packs; ++k) sum += at.gradient(k, d) * nodes_.value[c][k];
    return sum.sum();
  }

 private:
  Nodes<G, S, C> nodes_;
};

/// Of the linear shape, as the polynomial that it is: c0 + c1 x + y (c2 + c3 x), which takes a
/// third of the instructions of a sum over the nodes.
template <class G, class S, int C>
class Interpolant<G, S, C, true> {
 public:
  static constexpr int D = G::dim;
  static_assert(D < 3, "three directions need eight coefficients");

  Interpolant() = default;
  KOKKOS_FORCEINLINE_FUNCTION explicit Interpolant(const Nodes<G, S, C>& nodes) {
    for (int c = 0; c < C; ++c) {
      const auto& v = nodes.value[c][0];
      c_[c][0] = v[0];
      c_[c][1] = v[1] - v[0];
      if constexpr (D == 2) {
        c_[c][2] = v[2] - v[0];
        c_[c][3] = (v[3] - v[2]) - (v[1] - v[0]);
      }
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION double at(const Stencil<G, S>& at, int c) const {
    double sum = c_[c][0] + c_[c][1] * at.t[0];
    if constexpr (D == 2) sum += at.t[1] * (c_[c][2] + c_[c][3] * at.t[0]);
    return sum;
  }
  KOKKOS_FORCEINLINE_FUNCTION double slope(const Stencil<G, S>& at, int c, int d,
                                           double per_h) const {
    if constexpr (D == 1)
      return c_[c][1] * per_h;
    else
      return (c_[c][1 + d] + c_[c][3] * at.t[1 - d]) * per_h;
  }
  /// At the centre of the cell.
  KOKKOS_FORCEINLINE_FUNCTION double centre_slope(int c, int d, double per_h) const {
    if constexpr (D == 1)
      return c_[c][1] * per_h;
    else
      return (c_[c][1 + d] + 0.5 * c_[c][3]) * per_h;
  }

 private:
  double c_[C][power(2, D)] = {};
};

/// Component d of the gradient of the linear weights at the centre of a cell. [1/m]
template <class G>
KOKKOS_FORCEINLINE_FUNCTION auto centre_gradient(int pack, int d, double per_h) {
  using L = Lanes<G::dim, 2>;
  double sign[L::count];
  for (int lane = 0; lane < L::count; ++lane) sign[lane] = L::digit(pack, lane, d) == 1 ? 1 : -1;
  return Pack<L::count>::of(sign) * Pack<L::count>(per_h / power(2, G::dim - 1));
}

}  // namespace brisance
