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
  static constexpr int nodes = At::nodes;

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

  KOKKOS_INLINE_FUNCTION At stencil(const int (&base)[D], int p) const {
    return At(lattice, base, points, p);
  }

  /// The gradient used for forces and strain rates: of the weights, or by moving least squares (N r
  /// / inertia).
  KOKKOS_INLINE_FUNCTION Vec<D> gradient(const At& at, int n) const {
    if constexpr (!M::mls) return at.gradient(n);
    Vec<D> g = at.arm(n);
    const double f = at.weight(n) / (S::affine_inertia * lattice.h * lattice.h);
    for (int d = 0; d < D; ++d) g[d] *= f;
    return g;
  }

  template <int C, class Access>
  KOKKOS_INLINE_FUNCTION void add(const Access& to, int bin, const double (&sum)[nodes][C]) const {
    for (int n = 0; n < nodes; ++n) {
      const int node = bin + At::offset(lattice, n);
      for (int c = 0; c < C; ++c) to(node, c) += sum[n][c];
    }
  }

  /// (A.1), (A.2); with an affine field m (v + C r) as in APIC (Jiang et al. 2015).
  template <class Access>
  KOKKOS_INLINE_FUNCTION void momentum(const Row<D>& row, const Access& to) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      double sum[nodes][D + 1] = {};
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        const double m = points.m(p);
        const Vec<D> v = points.v(p);
        [[maybe_unused]] Mat<D> affine;
        if constexpr (M::affine) affine = points.matrix(points.affine, p);
        for (int n = 0; n < nodes; ++n) {
          const double nm = at.weight(n) * m;
          sum[n][D] += nm;
          for (int i = 0; i < D; ++i) {
            double u = v[i];
            if constexpr (M::affine) {
              const Vec<D> r = at.arm(n);
              for (int j = 0; j < D; ++j) u += affine(i, j) * r[j];
            }
            sum[n][i] += nm * u;
          }
        }
      }
      add(to, bin, sum);
    });
  }

  /// (A.3): -V sigma . grad N. With cell quadrature the mean stress of the cell acts through the
  /// gradient at its centre, so that a uniform pressure in full cells gives exactly no force.
  template <Stress kind, class Access>
  KOKKOS_INLINE_FUNCTION void force(const Row<D>& row, const Table<double>& scale,
                                    const Access& to) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      double sum[nodes][D] = {};
      if constexpr (M::cells) {
        Sym3 total;
        for (int p = begin; p < end; ++p) add_stress<kind>(total, p);
        for (int n = 0; n < nodes; ++n)
          pull<kind>(sum[n], total, centre_gradient<G>(n, lattice.h), scale(bin, 0));
      } else {
        for (int p = begin; p < end; ++p) {
          const At at = stencil(base, p);
          Sym3 total;
          add_stress<kind>(total, p);
          for (int n = 0; n < nodes; ++n) pull<kind>(sum[n], total, gradient(at, n), 1);
        }
      }
      add(to, bin, sum);
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

  template <Stress kind>
  KOKKOS_INLINE_FUNCTION static void pull(double (&force)[D], const Sym3& s, const Vec<D>& g,
                                          double factor) {
    for (int i = 0; i < D; ++i) {
      if constexpr (kind == Stress::pressure)
        force[i] -= factor * s[0] * g[i];
      else
        for (int j = 0; j < D; ++j) force[i] -= factor * s[Sym3::at(i, j)] * g[j];
    }
  }

  /// (A.13) at one particle, or once for the cell.
  KOKKOS_INLINE_FUNCTION static void add_outer(Mat<D>& m, const Vec<D>& v, const Vec<D>& g) {
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) m(i, j) += v[i] * g[j];
  }

  KOKKOS_INLINE_FUNCTION Mat<D> velocity_gradient(const Nodes<G, S, D>& v, const At& at) const {
    Mat<D> gradient_;
    for (int n = 0; n < nodes; ++n)
      add_outer(gradient_, v[n], M::cells ? centre_gradient<G>(n, lattice.h) : gradient(at, n));
    return gradient_;
  }

  KOKKOS_INLINE_FUNCTION void gradients(const Row<D>& row, const Table<double>& velocity) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Nodes<G, S, D> v(velocity, lattice, bin);
      for (int p = begin; p < end; ++p)
        points.set_matrix(points.gradient, p, velocity_gradient(v, stencil(base, p)));
    });
  }

  /// A step along the grid velocity (A.9), then what the ends of the domain demand.
  KOKKOS_INLINE_FUNCTION void move(int p, const Vec<D>& u, double dt,
                                   const Boundaries<D>& boundaries) const {
    for (int d = 0; d < D; ++d)
      points.position(p, d) = boundaries.settle(lattice, d, points.position(p, d) + dt * u[d]);
  }

  /// (A.6), (A.8), and a blend of `1 - flip` toward the grid velocity.
  KOKKOS_INLINE_FUNCTION void accelerate(const Row<D>& row, const Table<double>& before,
                                         const Table<double>& after, const Table<double>& own,
                                         double flip) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Nodes<G, S, D> v0(before, lattice, bin), v1(after, lattice, bin),
          mine(own, lattice, bin);
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        Vec<D> v = points.v(p), change;
        for (int n = 0; n < nodes; ++n) {
          const double w = at.weight(n);
          for (int i = 0; i < D; ++i)
            change[i] +=
                w * (v1.value[n][i] - v0.value[n][i] + (1 - flip) * (mine.value[n][i] - v[i]));
        }
        for (int i = 0; i < D; ++i) points.velocity(p, i) = v[i] + change[i];
      }
    });
  }

  KOKKOS_INLINE_FUNCTION void gradient_and_move(const Row<D>& row, const Table<double>& velocity,
                                                const Table<double>& after,
                                                const Boundaries<D>& boundaries, double dt) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Nodes<G, S, D> v1(after, lattice, bin), v(velocity, lattice, bin);
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        const Mat<D> gradient_ = velocity_gradient(v, at);
        points.set_matrix(points.gradient, p, gradient_);
        points.stretch(p, gradient_, dt);
        Vec<D> u;
        for (int n = 0; n < nodes; ++n)
          for (int i = 0; i < D; ++i) u[i] += at.weight(n) * v1.value[n][i];
        move(p, u, dt, boundaries);
      }
    });
  }

  /// sums <- V times the diagonal of L, and V, of the cell that holds each particle.
  template <class Access>
  KOKKOS_INLINE_FUNCTION void cells(const Row<D>& row, const Access& to) const {
    for (int p = points.first(row.begin); p < points.first(row.end); ++p) {
      const int cell = lattice.cell_of(points.x(p));
      const double v = points.vol(p);
      for (int d = 0; d < D; ++d) to(cell, d) += v * points.gradient(p, d * D + d);
      to(cell, D) += v;
    }
  }

  /// sums(column) <- V of each particle, spread over the cells that its shape overlaps.
  template <class Access>
  KOKKOS_INLINE_FUNCTION void overlap(const Row<D>& row, int column, const Access& to) const {
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

  template <class Access>
  KOKKOS_INLINE_FUNCTION void mean(const Row<D>& row, const Table<double>& value, int vc,
                                   const Table<double>& weight, int wc, const Access& to) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      double sum[nodes][2] = {};
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        const double w = weight(p, wc), wv = w * value(p, vc);
        for (int n = 0; n < nodes; ++n) {
          sum[n][0] += at.weight(n) * wv;
          sum[n][1] += at.weight(n) * w;
        }
      }
      add(to, bin, sum);
    });
  }

  template <class Access>
  KOKKOS_INLINE_FUNCTION void means(const Row<D>& row, const Table<double>& values,
                                    const Access& to) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      double sum[nodes][4] = {};
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        const double weight = values(p, 3);
        const double v[4] = {weight * values(p, 0), weight * values(p, 1), weight * values(p, 2),
                             weight};
        for (int n = 0; n < nodes; ++n)
          for (int k = 0; k < 4; ++k) sum[n][k] += at.weight(n) * v[k];
      }
      add(to, bin, sum);
    });
  }

  KOKKOS_INLINE_FUNCTION void subtract_means(const Row<D>& row, const Table<double>& field,
                                             const Table<double>& values) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      double f[nodes][3];
      for (int n = 0; n < nodes; ++n)
        for (int k = 0; k < 3; ++k) f[n][k] = field(bin + At::offset(lattice, n), k);
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        double sum[3] = {};
        for (int n = 0; n < nodes; ++n)
          for (int k = 0; k < 3; ++k) sum[k] += at.weight(n) * f[n][k];
        for (int k = 0; k < 3; ++k) values(p, k) -= sum[k];
      }
    });
  }

  KOKKOS_INLINE_FUNCTION void gather(const Row<D>& row, const Table<double>& field, int column,
                                     const Table<double>& value, int vc, double keep,
                                     double factor) const {
    for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      double f[nodes];
      for (int n = 0; n < nodes; ++n) f[n] = field(bin + At::offset(lattice, n), column);
      for (int p = begin; p < end; ++p) {
        const At at = stencil(base, p);
        double sum = 0;
        for (int n = 0; n < nodes; ++n) sum += at.weight(n) * f[n];
        value(p, vc) = keep * value(p, vc) + factor * sum;
      }
    });
  }
};

}  // namespace brisance
