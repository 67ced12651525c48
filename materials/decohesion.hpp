#pragma once
// A plane that comes apart: discrete decohesion after Schreyer, Sulsky & Zhou (2002), in the frame
// of its normal n and the direction t across. With s = (tau . A . tau)^(1/2) / tau0 = hypot(tau_n /
// tau_np, tau_t / tau_tp) it opens on s = 1 - lambda^theta, along A . tau, until lambda = 1.
#include "core/wide.hpp"

namespace brisance {

struct Decohesion {
  double u0 = 6e-4;  ///< opening at which a plane under tension is separate [m]
  double Cm = 10;    ///< strength in shear over strength in tension [-]
  double theta = 1;  ///< exponent of softening [-]

  template <class T>
  struct PlaneOf {
    T strength = 0;  ///< tau_np, in tension at onset [Pa]
    T lambda = 0;    ///< 0 whole, 1 separate [-]
  };
  /// Stiffness of the matter around it, as strain over its share of the volume. [Pa, Pa, m]
  template <class T>
  struct AroundOf {
    T M = 0, G = 0, length = 0;
  };
  template <class T>
  struct TractionOf {
    T n = 0, t = 0;  ///< [Pa]
  };
  template <class T>
  struct OpeningOf {
    T n = 0, t = 0;  ///< [m]
    T work = 0;      ///< dissipated [J/m^2]
  };
  using Plane = PlaneOf<double>;
  using Around = AroundOf<double>;
  using Traction = TractionOf<double>;
  using Opening = OpeningOf<double>;

  /// Turns the trial traction of a step, elastic from `before`, into that on the plane. What is
  /// pressed together cannot open, but slip; a separate plane carries pressure and nothing else.
  template <class T>
  KOKKOS_INLINE_FUNCTION OpeningOf<T> update(PlaneOf<T>& plane, TractionOf<T>& tau,
                                             const TractionOf<T>& before,
                                             const AroundOf<T>& around) const {
    OpeningOf<T> du;
    const T s0 = 1 - raised(plane.lambda, theta), sn = most(tau.n, T(0)) / plane.strength,
            st = tau.t / (Cm * plane.strength);
    const auto separate = !(plane.lambda < T(1)),
               opens = !separate && square(sn) + square(st) > square(s0);
    if (!any(separate || opens)) return du;

    const T unit = u0 / (around.length * plane.strength);
    const FlowOf<T> flow{select(opens, sn, T(1)),
                         select(opens, st, T(0)),
                         around.M * unit,
                         around.G * unit * (1 / square(Cm)),
                         select(opens, plane.lambda, T(0)),
                         theta};
    const T step = !any(opens) ? T(0) : theta < 1 ? flow.first_root() : flow.root();
    const auto parts = separate || (opens && !(step < 1 - plane.lambda)), slides = opens && !parts;
    if (any(slides)) {
      const T s = 1 - raised(flow.lambda + step, theta);
      const T share_n = select(slides, 1 / (s + step * flow.an), T(0)),
              share_t = select(slides, 1 / (s + step * flow.at), T(0));
      du.n = step * u0 * sn * share_n;
      du.t = step * (u0 / Cm) * st * share_t;
      du.work = select(slides, released(plane, step), T(0));
      tau.n = select(slides && tau.n > T(0), tau.n * s * share_n, tau.n);
      tau.t = select(slides, tau.t * s * share_t, tau.t);
      plane.lambda += select(slides, step, T(0));
    }
    if (any(parts)) separated(parts, du, plane, tau, before, around);
    return du;
  }

 private:
  /// The backward Euler step d in lambda: hypot(sn / (s + d an), st / (s + d at)) = 1 with s = 1 -
  /// (lambda + d)^theta.
  template <class T>
  struct FlowOf {
    T sn, st, an, at, lambda;
    double theta;

    /// 1 / hypot(...) - 1 and its slope.
    KOKKOS_FORCEINLINE_FUNCTION T excess(const T& d, T& slope) const {
      const T s = 1 - raised(lambda + d, theta), s_slope = -theta * raised(lambda + d, theta - 1);
      const T per_n = 1 / (s + d * an), per_t = 1 / (s + d * at), n2 = square(sn * per_n),
              t2 = square(st * per_t), inverse = 1 / sqrt(n2 + t2);
      slope =
          inverse * inverse * inverse * (n2 * (s_slope + an) * per_n + t2 * (s_slope + at) * per_t);
      return inverse - 1;
    }

    /// For theta >= 1 the function is concave, so that Newton's iterates from 0 approach the
    /// smallest root from below; in pure modes with theta = 1 the first one is it. 1 if there is
    /// none.
    KOKKOS_INLINE_FUNCTION T root() const {
      T d = 0;
      auto done = d < T(0);
      for (int k = 0; k < 60 && any(!done); ++k) {
        T slope;
        const T value = excess(d, slope);
        const auto below = value<T(0), rises = slope> T(0);
        const T next = d - value / select(rises, slope, T(1));
        const auto none = below && !(rises && next < 1 - lambda),
                   nearer = below && !none && next > d;
        d = select(done, d, select(none, T(1), select(nearer, next, d)));
        done = done || !nearer;
      }
      return d;
    }

    /// For theta < 1 strength falls at an infinite slope first: looks for a change of sign over
    /// nine decades, then halves. 1 if there is none.
    KOKKOS_INLINE_FUNCTION T first_root() const {
      const T end = 1 - lambda;
      const double ratio = pow(10., 0.15);
      T low = 0, d = 1e-9 * end, slope;
      for (auto looks = d < end && excess(d, slope) < T(0); any(looks);
           looks = d < end && excess(d, slope) < T(0)) {
        low = select(looks, d, low);
        d = select(looks, d * ratio, d);
      }
      const auto none = !(d < end) && excess(end * (1 - 1e-12), slope) < T(0);
      T high = least(d, end);
      for (int k = 0; k < 60; ++k) {
        const T mid = 0.5 * (low + high);
        const auto below = excess(mid, slope) < T(0);
        low = select(below, mid, low);
        high = select(below, high, mid);
      }
      return select(none, T(1), high);
    }
  };

  /// U0 times the integral of 1 - lambda^theta, whatever the mode and the length. [J/m^2]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T released(const PlaneOf<T>& plane, const T& step) const {
    const T l0 = plane.lambda, l1 = l0 + step,
            lost = (l1 * raised(l1, theta) - l0 * raised(l0, theta)) * (1 / (theta + 1));
    return most(plane.strength * u0 * (step - lost), T(0));
  }

  /// All of the traction but pressure goes, at once. Matter around that is longer than M u0 /
  /// strength (in shear G u0 / (Cm^2 strength)) snaps: it has stored more than the plane takes, and
  /// all that is lost, which the mean of the tractions counts.
  template <class T>
  KOKKOS_INLINE_FUNCTION void separated(const Truth<T>& which, OpeningOf<T>& du, PlaneOf<T>& plane,
                                        TractionOf<T>& tau, const TractionOf<T>& before,
                                        const AroundOf<T>& around) const {
    const T n = around.length * most(tau.n, T(0)) / around.M, t = around.length * tau.t / around.G;
    const T taken = released(plane, 1 - plane.lambda),
            stored = 0.5 * around.length *
                     (square(most(before.n, T(0))) / around.M + square(before.t) / around.G),
            lost = most(taken, 0.5 * (before.n * n + before.t * t));
    du.n = select(which, n, du.n);
    du.t = select(which, t, du.t);
    du.work = select(which, select(stored > taken, lost, taken), du.work);
    plane.lambda = select(which, T(1), plane.lambda);
    tau.n = select(which, least(tau.n, T(0)), tau.n);
    tau.t = select(which, T(0), tau.t);
  }
};

}  // namespace brisance
