#pragma once
// The end of a midpoint step as a function of a row. Work is done by the half-step stress on the
// mean of the grid velocities before and after, the adjoint of the force, and what the transfer of
// velocity loses in kinetic energy becomes heat, so that the total energy is kept to round-off.
// Points move with that mean, too, so that places and volumes tell of the same motion. With the
// velocities after, as (A.9) has it, a point that is set in motion to u gets u dt / 2 ahead of what
// its volume has seen: a contact some 0.15 cells at CFL 0.8, the shock before it with it (0.21 in
// place of 0.10 at Mach 13 and gamma 1.4), and every error a sixth larger.
#include "core/transfer_rows.hpp"

namespace brisance {

template <class G, class M, Stress kind>
struct Midpoint {
  using R = Rows<G, M>;
  using S = typename M::Shape;
  using At = typename R::At;
  static constexpr int D = G::dim, nodes = R::nodes;
  using Field = Nodes<G, S, D>;

  R rows;
  Table<double> before, after, own, scale;
  Boundaries<D> boundaries;
  double flip, dt;

  KOKKOS_INLINE_FUNCTION void operator()(const Row<D>& row) const {
    rows.for_bins(row, [&](int bin, int begin, int end, const int(&base)[D]) {
      const Field v0(before, rows.lattice, bin), v1(after, rows.lattice, bin),
          mine(own, rows.lattice, bin);
      Field middle(v0);
      for (int n = 0; n < nodes; ++n)
        for (int i = 0; i < D; ++i) middle.value[n][i] = 0.5 * (v0.value[n][i] + v1.value[n][i]);
      const double fill = M::cells ? scale(bin, 0) : 1;
      double heat = 0, mass = 0;
      for (int p = begin; p < end; ++p) {
        const At at = rows.stencil(base, p);
        const Mat<D> gradient = rows.velocity_gradient(middle, at);
        const double m = rows.points.m(p);
        mass += m;
        heat += m * (M::affine ? affine_velocity(p, at, v0, v1, mine)
                               : flip_velocity(p, at, v0, v1, mine));
        const double power = contract(rows.points.template sigma<kind>(rows.points.acting, p),
                                      strain_rate<G>(gradient));
        rows.points.work(p, 0) = power * fill * rows.points.vol(p) * dt / m;
        rows.points.set_matrix(rows.points.gradient, p, gradient);
        rows.points.stretch(p, gradient, dt);
        Vec<D> u;
        for (int n = 0; n < nodes; ++n)
          for (int i = 0; i < D; ++i) u[i] += at.weight(n) * middle.value[n][i];
        rows.move(p, u, dt, boundaries);
      }
      // Shared by all of the bin: given to each its own, it would burn light particles beside heavy
      // ones.
      for (int p = begin; p < end; ++p) rows.points.work(p, 0) += heat / mass;
    });
  }

  /// FLIP with the share b = 1 - flip drawn to the velocity field of the particle's own class.
  /// Returns the kinetic energy per mass that this loses: (sum N |dv|^2 - |D|^2) / 2 + b (sum N
  /// |v_p - v_i|^2 + D . d) - b^2 |d|^2 / 2, D = sum N dv, d = v_p - sum N v_i.
  KOKKOS_INLINE_FUNCTION double flip_velocity(int p, const At& at, const Field& v0, const Field& v1,
                                              const Field& mine) const {
    const Vec<D> v = rows.points.v(p);
    Vec<D> change, mean;
    double change2 = 0, spread2 = 0;
    for (int n = 0; n < nodes; ++n) {
      const double w = at.weight(n);
      for (int i = 0; i < D; ++i) {
        const double dv = v1.value[n][i] - v0.value[n][i];
        change[i] += w * dv;
        mean[i] += w * mine.value[n][i];
        change2 += w * dv * dv;
        spread2 += w * square(v[i] - mine.value[n][i]);
      }
    }
    const double b = 1 - flip;
    Vec<D> drift, result;
    for (int i = 0; i < D; ++i) {
      drift[i] = v[i] - mean[i];
      result[i] = v[i] + change[i] - b * drift[i];
    }
    rows.points.store(rows.points.velocity, p, result);
    return 0.5 * (change2 - dot(change, change)) + b * (spread2 + dot(change, drift)) -
           0.5 * b * b * dot(drift, drift);
  }

  /// APIC (Jiang et al. 2015): w_i = v_i + dv_i; v_p = sum N w, C = sum N w r / inertia. Returns
  /// the loss sum N (|v_p + C r - v_i|^2 before + |w_i - v_p - C r|^2 after) / 2.
  KOKKOS_INLINE_FUNCTION double affine_velocity(int p, const At& at, const Field& v0,
                                                const Field& v1, const Field& mine) const {
    const Vec<D> old = rows.points.v(p);
    const Mat<D> old_affine = rows.points.matrix(rows.points.affine, p);
    const double h = rows.lattice.h, per_inertia = 1 / (S::affine_inertia * h * h);
    Vec<D> v;
    Mat<D> affine;
    double loss = 0;
    for (int n = 0; n < nodes; ++n) {
      const double weight = at.weight(n);
      const Vec<D> r = at.arm(n);
      for (int i = 0; i < D; ++i) {
        const double w = mine.value[n][i] + v1.value[n][i] - v0.value[n][i];
        double left = old[i] - mine.value[n][i];
        for (int j = 0; j < D; ++j) left += old_affine(i, j) * r[j];
        loss += weight * left * left;
        v[i] += weight * w;
        for (int j = 0; j < D; ++j) affine(i, j) += weight * w * r[j] * per_inertia;
      }
    }
    for (int n = 0; n < nodes; ++n) {
      const Vec<D> r = at.arm(n);
      for (int i = 0; i < D; ++i) {
        double left = mine.value[n][i] + v1.value[n][i] - v0.value[n][i] - v[i];
        for (int j = 0; j < D; ++j) left -= affine(i, j) * r[j];
        loss += at.weight(n) * left * left;
      }
    }
    rows.points.store(rows.points.velocity, p, v);
    rows.points.set_matrix(rows.points.affine, p, affine);
    return 0.5 * loss;
  }
};

}  // namespace brisance
