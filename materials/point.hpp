#pragma once
// A law and its particles as kernels capture them: one point's state in and out of the columns.
#include "core/geometry.hpp"
#include "core/grid.hpp"
#include "materials/material.hpp"

namespace brisance {

/// The fields of the grid that a law may look at.
template <class G>
struct Surroundings {
  Lattice<G::dim> lattice;
  double time;  ///< at the start of the step [s]
  Table<double> smoothness;
  bool limited;
  explicit Surroundings(const Grid<G>& grid)
      : lattice(grid.lattice),
        time(grid.time),
        smoothness(grid.smoothness),
        limited(grid.smoothness.extent(0) > 0) {}
};

/// The law and its particles, as kernels capture them.
template <class G, class M>
struct MaterialPoint {
  using History = typename M::History;

  M material;
  Particles<G> particles;

  KOKKOS_INLINE_FUNCTION History load(int p) const {
    History h;
    for (int k = 0; k < M::field_count; ++k) h.*(M::fields[k].member) = particles.history(p, k);
    return h;
  }
  KOKKOS_INLINE_FUNCTION void save(int p, const History& h) const {
    for (int k = 0; k < M::field_count; ++k) particles.history(p, k) = h.*(M::fields[k].member);
  }
  KOKKOS_INLINE_FUNCTION double rho(int p) const { return particles.m(p) / particles.vol(p); }
  KOKKOS_INLINE_FUNCTION double pressure(int p) const {
    return -particles.template sigma<M::stress>(p)[0];
  }
  /// The pressure without the part that no node sees, which scratch column 0 holds.
  KOKKOS_INLINE_FUNCTION double smooth_pressure(int p) const {
    return clamp(pressure(p) - particles.scratch(p, 0), 0.5 * pressure(p), 2 * pressure(p));
  }
  KOKKOS_INLINE_FUNCTION void refresh(int p) const {
    particles.template set_sigma<M::stress>(p, material.state(rho(p), load(p)).stress);
  }
  /// 1 + tr D dt (A.16), bounded where a step overshoots; see largest volume change in the time
  /// step.
  KOKKOS_INLINE_FUNCTION static double growth(const Sym3& rate, double dt) {
    return most(1 + trace(rate) * dt, 0.1);
  }
  /// Solids: the stress turned with the rigid rotation of a step, as are the directions in h.
  KOKKOS_INLINE_FUNCTION Sym3 turn(int p, double dt, [[maybe_unused]] History& h) const {
    const Mat<3> r = rotation<G>(particles.matrix(particles.gradient, p), dt);
    if constexpr (M::directed) M::rotate(h, r);
    return turned<G>(particles.template sigma<M::stress>(p), r);
  }
  KOKKOS_INLINE_FUNCTION Strain strain(int p, double dt, const Surroundings<G>& around) const {
    Strain in;
    in.rate = strain_rate<G>(particles.matrix(particles.gradient, p));
    in.dt = dt;
    in.time = around.time + dt;
    in.rho0 = rho(p);
    in.growth = growth(in.rate, dt);
    in.rho1 = in.rho0 / in.growth;
    in.volume_change = (in.growth - 1) / in.rho0;
    in.h = around.lattice.h;
    if constexpr (M::burns) in.spacing = particles.root(particles.m(p) / material.eos.rho0);
    if (around.limited)
      in.smoothness = around.smoothness(around.lattice.cell_of(particles.x(p)), 0);
    return in;
  }
};

}  // namespace brisance
