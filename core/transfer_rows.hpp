#pragma once
// The transfers as functions of a row of bins; a whole bin is summed before it is scattered.
// Equation numbers are those of Appendix A of Hu & Chen (2006).
#include "core/geometry.hpp"
#include "core/grid.hpp"
#include "core/particles.hpp"
#include "core/schedule.hpp"
#include "core/shape.hpp"
#include "core/stencil.hpp"

namespace brisance {

/// A transfer as a type: shape function, APIC's affine field, MLS gradients, quadrature over cells.
template <class Shape_, bool affine_ = false, bool mls_ = false, bool cells_ = false>
struct Method {
  using Shape = Shape_;
  static constexpr bool affine = affine_, mls = mls_, cells = cells_;
};

template <class G, class M>
struct Rows {
  static constexpr int D = G::dim;
  using S = typename M::Shape;
  using At = Stencil<G, S>;
  using P = typename At::P;
  static constexpr int packs = At::packs;
  template <int C>
  using Field = Nodes<G, S, C>;
  template <int C>
  using Smooth = Interpolant<G, S, C>;

  /// The velocities of the nodes of a bin.
  struct Around {
    Field<D> nodes;
    Smooth<D> smooth;
    KOKKOS_FORCEINLINE_FUNCTION explicit Around(const Field<D>& v) : nodes(v), smooth(v) {}
  };

  Particles<G> points;
  Lattice<D> lattice;

  /// Calls f(bin, first particle, end, integer coordinates) for the bins of a row that hold
  /// particles.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_bins(const Row<D>& row, const F& f) const {
    if (points.first(row.begin) == points.first(row.end)) return;
    int base[D];
    for (int d = 0; d < D; ++d) base[d] = row.base[d];
    for (int bin = row.begin; bin < row.end; ++bin, ++base[0]) {
      const int begin = points.first(bin), end = points.first(bin + 1);
      if (begin < end) f(bin, begin, end, base);
    }
  }

  /// Calls f(p) for the particles of a row.
  template <class F>
  KOKKOS_INLINE_FUNCTION void for_points(const Row<D>& row, const F& f) const {
    const int end = points.first(row.end);
    for (int p = points.first(row.begin); p < end; ++p) f(p);
  }

  KOKKOS_INLINE_FUNCTION int bin_of(int p) const {
    int base[D];
    bool inside = true;
    for (int d = 0; d < D; ++d) {
      const double at = lattice.in_cells(points.position(p, d), d);
      inside = inside && at >= 0 && at < lattice.cells[d];
      base[d] = inside ? S::base(at) : 0;
    }
    return inside ? lattice.index(base) : lattice.size;
  }

  KOKKOS_INLINE_FUNCTION void find_bins(const Row<D>& row) const {
    for_points(row, [&](int p) { points.bin(p) = bin_of(p); });
  }

  KOKKOS_FORCEINLINE_FUNCTION At stencil(const int (&base)[D], int p) const {
    return At(lattice, base, points, p);
  }

  /// Component d of the gradient used for forces and strain rates: of the weights, or by moving
  /// least squares (N r / inertia).
  KOKKOS_FORCEINLINE_FUNCTION P gradient(const At& at, int k, int d) const {
    if constexpr (M::mls)
      return at.weight[k] * at.arm(k, d) * P(square(lattice.per_h) / S::affine_inertia);
    else
      return at.gradient(k, d);
  }

  template <int C>
  KOKKOS_FORCEINLINE_FUNCTION Smooth<C> smooth(const Table<double>& field, int bin,
                                               int column = 0) const {
    return Smooth<C>(Field<C>(field, lattice, bin, column));
  }

  /// sum over nodes of N v.
  template <int C>
  KOKKOS_FORCEINLINE_FUNCTION static Vec<C> mean(const Smooth<C>& v, const At& at) {
    Vec<C> sum;
    for (int c = 0; c < C; ++c) sum[c] = v.at(at, c);
    return sum;
  }

  /// (A.1), (A.2); with an affine field m (v + C r) as in APIC (Jiang et al. 2015).
  template <class To>
  KOKKOS_INLINE_FUNCTION void momentum(const Row<D>& row, const To& to) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      Field<D + 1> sum;
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        const P m(points.m(p));
        const Vec<D> v = points.v(p);
        [[maybe_unused]] Mat<D> affine;
        if constexpr (M::affine) affine = points.matrix(points.affine, p);
        for (int k = 0; k < packs; ++k) {
          const P nm = at.weight[k] * m;
          sum.value[D][k] += nm;
          for (int i = 0; i < D; ++i) {
            P u(v[i]);
            if constexpr (M::affine)
              for (int j = 0; j < D; ++j) u += P(affine(i, j)) * at.arm(k, j);
            sum.value[i][k] += nm * u;
          }
        }
      }
      sum.add_to(to, lattice, bin);
    });
  }

  /// (A.3): -V sigma . grad N. With cell quadrature the mean stress of the cell acts through the
  /// gradient at its centre, so that a uniform pressure in full cells gives exactly no force.
  template <Stress kind, class To>
  KOKKOS_INLINE_FUNCTION void force(const Row<D>& row, const Table<double>& scale,
                                    const To& to) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      Field<D> sum;
      if constexpr (M::cells) {
        Sym3 total;
        for (int p = begin; p < end; ++p) add_stress<kind>(total, p);
        pull<kind>(sum, total, scale(bin, 0),
                   [&](int k, int d) { return centre_gradient<G>(k, d, lattice.per_h); });
      } else {
        for (int p = begin; p < end; ++p) {
          const At at = stencil(base, p);
          Sym3 total;
          add_stress<kind>(total, p);
          pull<kind>(sum, total, 1, [&](int k, int d) { return gradient(at, k, d); });
        }
      }
      sum.add_to(to, lattice, bin);
    });
  }

  template <Stress kind>
  KOKKOS_INLINE_FUNCTION void add_stress(Sym3& total, int p) const {
    const double v = points.vol(p);
    if constexpr (kind == Stress::pressure) {
      total[0] -= v * points.acting(p, 0);
    } else {
      const Sym3 s = points.template sigma<kind>(points.acting, p);
      for (int k = 0; k < 6; ++k) total[k] += v * s[k];
    }
  }

  template <Stress kind, class Gradient>
  KOKKOS_INLINE_FUNCTION static void pull(Field<D>& force, const Sym3& s, double factor,
                                          const Gradient& g) {
    for (int k = 0; k < packs; ++k)
      for (int i = 0; i < D; ++i) {
        if constexpr (kind == Stress::pressure)
          force.value[i][k] += P(-factor * s[0]) * g(k, i);
        else
          for (int j = 0; j < D; ++j) force.value[i][k] += P(-factor * s[Sym3::at(i, j)]) * g(k, j);
      }
  }

  /// (A.13): sum over nodes of v grad N.
  KOKKOS_FORCEINLINE_FUNCTION Mat<D> velocity_gradient(const Around& v, const At& at) const {
    Mat<D> sum;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        if constexpr (M::cells) {
          sum(i, j) = v.smooth.centre_slope(i, j, lattice.per_h);
        } else if constexpr (M::mls) {
          P here;
          for (int k = 0; k < packs; ++k) here += gradient(at, k, j) * v.nodes.value[i][k];
          sum(i, j) = here.sum();
        } else {
          sum(i, j) = v.smooth.slope(at, i, j, lattice.per_h);
        }
      }
    return sum;
  }

  KOKKOS_INLINE_FUNCTION void gradients(const Row<D>& row, const Table<double>& velocity) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Around v(Field<D>(velocity, lattice, bin));
      for (int p = begin; p < end; ++p)
        points.set_matrix(points.gradient, p, velocity_gradient(v, stencil(base, p)));
    });
  }

  /// A step along the grid velocity (A.9), then what the ends of the domain demand.
  KOKKOS_FORCEINLINE_FUNCTION void move(int p, const Vec<D>& u, double dt,
                                        const Ends<D>& ends) const {
    for (int d = 0; d < D; ++d)
      points.position(p, d) = ends.settle(d, points.position(p, d) + dt * u[d]);
  }

  /// (A.6), (A.8), and a blend of `1 - flip` toward the grid velocity.
  KOKKOS_INLINE_FUNCTION void accelerate(const Row<D>& row, const Table<double>& before,
                                         const Table<double>& after, const Table<double>& own,
                                         double flip) const {
    const double drawn = 1 - flip;
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Field<D> v0(before, lattice, bin);
      Field<D> gain(after, lattice, bin);
      for (int d = 0; d < D; ++d)
        for (int k = 0; k < packs; ++k) gain.value[d][k] = gain.value[d][k] - v0.value[d][k];
      const Smooth<D> change(gain), mine = smooth<D>(own, bin);
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        for (int i = 0; i < D; ++i) {
          const double v = points.velocity(p, i);
          double drift = 0;
          if (drawn != 0) drift = v - mine.at(at, i);
          points.velocity(p, i) = v + change.at(at, i) - drawn * drift;
        }
      }
    });
  }

  KOKKOS_INLINE_FUNCTION void gradient_and_move(const Row<D>& row, const Table<double>& velocity,
                                                const Table<double>& after, const Ends<D>& ends,
                                                double dt) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Smooth<D> v1 = smooth<D>(after, bin);
      const Around v(Field<D>(velocity, lattice, bin));
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        const Mat<D> gradient_ = velocity_gradient(v, at);
        points.set_matrix(points.gradient, p, gradient_);
        points.stretch(p, gradient_, dt);
        move(p, mean(v1, at), dt, ends);
      }
    });
  }

  /// sums <- V times the diagonal of L, and V, of the cell that holds each particle.
  template <class To>
  KOKKOS_INLINE_FUNCTION void cells(const Row<D>& row, const To& to) const {
    const auto add = [&](int cell, const Vec<D + 1>& sum) {
      for (int c = 0; c <= D; ++c) to(cell, c) += sum.a[c];
    };
    const auto add_point = [&](Vec<D + 1>& sum, int p) {
      const double v = points.vol(p);
      for (int d = 0; d < D; ++d) sum[d] += v * points.gradient(p, d * D + d);
      sum[D] += v;
    };
    if constexpr (S::width == 2)  // a bin is a cell
      for_bins(row, [&](int bin, int begin, int end, const int(&)[D]) {
        Vec<D + 1> sum;
        for (int p = begin; p < end; ++p) add_point(sum, p);
        add(bin, sum);
      });
    else
      for_points(row, [&](int p) {
        Vec<D + 1> sum;
        add_point(sum, p);
        add(lattice.cell_of(points.x(p)), sum);
      });
  }

  /// sums(column) <- V of each particle, spread over the cells that its shape overlaps.
  template <class To>
  KOKKOS_INLINE_FUNCTION void overlap(const Row<D>& row, int column, const To& to) const {
    constexpr int W = S::cells;
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      for (int p = begin; p < end; ++p) {
        double w[D][W];
        for (int d = 0; d < D; ++d) {
          double half = 0;
          if constexpr (S::sized) half = points.half_length(p, d, lattice.h);
          S::overlap(lattice.in_cells(points.position(p, d), d) - base[d], half, w[d]);
        }
        for (int k = 0; k < power(W, D); ++k) {
          int cell = bin;
          double share = points.vol(p);
          for (int d = 0; d < D; ++d) {
            const int digit = k / power(W, d) % W;
            cell += digit * lattice.stride[d];
            share *= w[d][digit];
          }
          to(cell, column) += share;
        }
      }
    });
  }

  template <class To>
  KOKKOS_INLINE_FUNCTION void mean(const Row<D>& row, const Table<double>& value, int vc,
                                   const Table<double>& weight, int wc, const To& to) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      Field<2> sum;
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        const P w(weight(p, wc)), v(value(p, vc));
        for (int k = 0; k < packs; ++k) {
          const P share = at.weight[k] * w;
          sum.value[0][k] += share * v;
          sum.value[1][k] += share;
        }
      }
      sum.add_to(to, lattice, bin);
    });
  }

  template <class To>
  KOKKOS_INLINE_FUNCTION void means(const Row<D>& row, const Table<double>& values,
                                    const To& to) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      Field<4> sum;
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        for (int k = 0; k < packs; ++k) {
          const P share = at.weight[k] * P(values(p, 3));
          for (int c = 0; c < 3; ++c) sum.value[c][k] += share * P(values(p, c));
          sum.value[3][k] += share;
        }
      }
      sum.add_to(to, lattice, bin);
    });
  }

  KOKKOS_INLINE_FUNCTION void subtract_means(const Row<D>& row, const Table<double>& field,
                                             const Table<double>& values) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Smooth<3> f = smooth<3>(field, bin);
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        for (int k = 0; k < 3; ++k) values(p, k) -= f.at(at, k);
      }
    });
  }

  KOKKOS_INLINE_FUNCTION void gather(const Row<D>& row, const Table<double>& field, int column,
                                     const Table<double>& value, int vc, double keep,
                                     double factor) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Smooth<1> f = smooth<1>(field, bin, column);
      for (int p = begin; p < end; ++p)
        value(p, vc) = keep * value(p, vc) + factor * f.at(stencil(base, p), 0);
    });
  }
};

}  // namespace brisance
