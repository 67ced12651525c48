#pragma once
// What momentum and force do to nodes, as function objects for eight of them.
#include "core/pieces.hpp"

namespace brisance {

/// velocity <- momentum over mass, 0 where there is none; column D: mass. (A.5)
template <int D>
struct NodalVelocity {
  Table<double> momentum, velocity;

  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const Bundle& n) const {
    const Wide m = n.read(&momentum(0, D));
    const WideBool any = m > Wide(0);
    const Wide per_m = select(any, 1 / select(any, m, 1), 0);
    for (int d = 0; d < D; ++d) n.write(&velocity(0, d), per_m * n.read(&momentum(0, d)));
    n.write(&velocity(0, D), m);
  }
};

/// after <- before + dt force / mass. Returns the greater of both velocities, the greatest of the
/// directions. [m/s]
template <int D>
struct MoveNodes {
  Table<double> before, force, after;
  double dt;

  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION Wide operator()(const Bundle& n) const {
    const Wide m = n.read(&before(0, D));
    const WideBool any = m > Wide(0);
    const Wide kick = select(any, dt / select(any, m, 1), 0);
    Wide fastest;
    for (int d = 0; d < D; ++d) {
      const Wide v0 = n.read(&before(0, d)), v1 = v0 + kick * n.read(&force(0, d));
      n.write(&after(0, d), v1);
      fastest = most(fastest, most(fabs(v0), fabs(v1)));
    }
    return fastest;
  }
};

}  // namespace brisance
