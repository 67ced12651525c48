#pragma once
// A plane that comes apart: discrete decohesion after Schreyer, Sulsky & Zhou (2002), in the frame
// of its normal n and the direction t across. With s = (tau . A . tau)^(1/2) / tau0 = hypot(tau_n /
// tau_np, tau_t / tau_tp) it opens on s = 1 - lambda^theta, along A . tau, until lambda = 1.
#include "core/types.hpp"

namespace brisance {

struct Decohesion {
  double u0 = 6e-4;  ///< opening at which a plane under tension is separate [m]
  double Cm = 10;    ///< strength in shear over strength in tension [-]
  double theta = 1;  ///< exponent of softening [-]

  struct Plane {
    double strength = 0;  ///< tau_np, in tension at onset [Pa]
    double lambda = 0;    ///< 0 whole, 1 separate [-]
  };
  /// Stiffness of the matter around it, as strain over its share of the volume. [Pa, Pa, m]
  struct Around {
    double M = 0, G = 0, length = 0;
  };
  struct Traction {
    double n = 0, t = 0;  ///< [Pa]
  };
  struct Opening {
    double n = 0, t = 0;  ///< [m]
    double work = 0;      ///< dissipated [J/m^2]
  };

  /// Turns the trial traction of a step, elastic from `before`, into that on the plane. What is
  /// pressed together cannot open, but slip; a separate plane carries pressure and nothing else.
  KOKKOS_INLINE_FUNCTION Opening update(Plane& plane, Traction& tau, const Traction& before,
                                        const Around& around) const {
    const double normal = most(tau.n, 0);
    if (!(plane.lambda < 1)) return separated(plane, tau, before, around);
    const double s0 = 1 - raised(plane.lambda, theta);
    const double sn = normal / plane.strength, st = tau.t / (Cm * plane.strength);
    if (!(square(sn) + square(st) > square(s0))) return {};

    const double unit = u0 / (around.length * plane.strength);
    const Flow flow{sn, st, around.M * unit, around.G * unit / square(Cm), plane.lambda, theta};
    const double step = theta < 1 ? flow.first_root() : flow.root();
    if (!(step < 1 - plane.lambda)) return separated(plane, tau, before, around);

    const double s = 1 - raised(plane.lambda + step, theta), shares_n = s + step * flow.an,
                 shares_t = s + step * flow.at;
    Opening du;
    du.n = step * u0 * sn / shares_n;
    du.t = step * u0 * st / (Cm * shares_t);
    du.work = released(plane, step);
    if (tau.n > 0) tau.n *= s / shares_n;
    tau.t *= s / shares_t;
    plane.lambda += step;
    return du;
  }

 private:
  KOKKOS_INLINE_FUNCTION static double raised(double base, double exponent) {
    return exponent == 1 ? base : pow(base, exponent);
  }

  /// The backward Euler step d in lambda: hypot(sn / (s + d an), st / (s + d at)) = 1 with s = 1 -
  /// (lambda + d)^theta.
  struct Flow {
    double sn, st, an, at, lambda, theta;

    /// 1 / hypot(...) - 1 and its slope.
    KOKKOS_INLINE_FUNCTION double excess(double d, double& slope) const {
      const double s = 1 - raised(lambda + d, theta),
                   s_slope = -theta * raised(lambda + d, theta - 1);
      const double pn = s + d * an, pt = s + d * at, n2 = square(sn / pn), t2 = square(st / pt),
                   inverse = 1 / sqrt(n2 + t2);
      slope = inverse * inverse * inverse * (n2 * (s_slope + an) / pn + t2 * (s_slope + at) / pt);
      return inverse - 1;
    }

    /// For theta >= 1 the function is concave, so that Newton's iterates from 0 approach the
    /// smallest root from below; in pure modes with theta = 1 the first one is it. 1 if there is
    /// none.
    KOKKOS_INLINE_FUNCTION double root() const {
      double d = 0;
      for (int k = 0; k < 60; ++k) {
        double slope;
        const double value = excess(d, slope);
        if (value >= 0) return d;
        if (!(slope > 0)) return 1;
        const double next = d - value / slope;
        if (!(next < 1 - lambda)) return 1;
        if (!(next > d)) return d;
        d = next;
      }
      return d;
    }

    /// For theta < 1 strength falls at an infinite slope first: looks for a change of sign over
    /// nine decades, then halves. 1 if there is none.
    KOKKOS_INLINE_FUNCTION double first_root() const {
      double low = 0, high = 1 - lambda, slope;
      const double ratio = pow(10., 0.15);
      double d = 1e-9 * high;
      while (d < high && excess(d, slope) < 0) {
        low = d;
        d *= ratio;
      }
      if (d < high) {
        high = d;
      } else if (excess(high * (1 - 1e-12), slope) < 0) {
        return 1;
      }
      for (int k = 0; k < 60 && low < high; ++k) {
        const double mid = 0.5 * (low + high);
        (excess(mid, slope) < 0 ? low : high) = mid;
      }
      return high;
    }
  };

  /// U0 times the integral of 1 - lambda^theta, whatever the mode and the length. [J/m^2]
  KOKKOS_INLINE_FUNCTION double released(const Plane& plane, double step) const {
    const double l0 = plane.lambda, l1 = l0 + step,
                 lost = (l1 * raised(l1, theta) - l0 * raised(l0, theta)) / (theta + 1);
    return most(plane.strength * u0 * (step - lost), 0);
  }

  /// All of the traction but pressure goes, at once. Matter around that is longer than M u0 /
  /// strength (in shear G u0 / (Cm^2 strength)) snaps: it has stored more than the plane takes, and
  /// all that is lost, which the mean of the tractions counts.
  KOKKOS_INLINE_FUNCTION Opening separated(Plane& plane, Traction& tau, const Traction& before,
                                           const Around& around) const {
    Opening du;
    du.n = around.length * most(tau.n, 0) / around.M;
    du.t = around.length * tau.t / around.G;
    const double taken = released(plane, 1 - plane.lambda),
                 stored = 0.5 * around.length *
                          (square(most(before.n, 0)) / around.M + square(before.t) / around.G);
    du.work = stored > taken ? most(taken, 0.5 * (before.n * du.n + before.t * du.t)) : taken;
    plane.lambda = 1;
    tau.n = least(tau.n, 0);
    tau.t = 0;
    return du;
  }
};

}  // namespace brisance
