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
  using Law = M;
  using History = typename M::History;

  M material;
  Particles<G> particles;

  /// Calls f(single) for the particles of a row, f(bundle) where the law is wide.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void each(const Row<G::dim>& row, const F& f) const {
    if constexpr (M::wide) {
      particles.for_all(row, f);
    } else {
      const int end = particles.first(row.end), shift = particles.shift(row);
      for (int p = particles.first(row.begin); p < end; ++p) f(Single{p, shift});
    }
  }

  KOKKOS_INLINE_FUNCTION History load(int p) const {
    History h;
    for (int k = 0; k < M::field_count; ++k) h.*(M::fields[k].member) = particles.history(p, k);
    return h;
  }
  KOKKOS_INLINE_FUNCTION void save(int p, const History& h) const {
    for (int k = 0; k < M::field_count; ++k) particles.history(p, k) = h.*(M::fields[k].member);
  }
  /// To be called where a stage is the first of a sweep to read what decides the state.
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION void look_ahead(const Bundle<full, repeats>& b) const {
    particles.ask_for(particles.mass, 1, b);
    particles.ask_for(particles.volume, 1, b);
    particles.ask_for(particles.history, M::deciding, b);
    particles.ask_for(particles.stress, M::stress == Stress::pressure ? 1 : G::stress_components,
                      b);
  }
  KOKKOS_FORCEINLINE_FUNCTION void look_ahead(const Single&) const {}
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION auto load(const Bundle<full, repeats>& b) const {
    typename M::template HistoryOf<Wide> h;
    for (int k = 0; k < M::field_count; ++k)
      h.*(M::template fields_of<Wide>[k].member) = particles.get(particles.history, b, k);
    return h;
  }
  template <bool full, bool repeats, class H>
  KOKKOS_FORCEINLINE_FUNCTION void save(const Bundle<full, repeats>& b, const H& h) const {
    for (int k = 0; k < M::field_count; ++k)
      particles.put(particles.history, b, k, h.*(M::template fields_of<Wide>[k].member));
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto mass(const I& p) const {
    return particles.get(particles.mass, p);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto volume(const I& p) const {
    return particles.get(particles.volume, p);
  }
  template <class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION void set_volume(const I& p, const T& value) const {
    particles.put(particles.volume, p, 0, value);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto stress(const I& p) const {
    return particles.template sigma<M::stress>(p);
  }
  template <class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION void set_stress(const I& p, const SymOf<T>& value) const {
    particles.template set_sigma<M::stress>(p, value);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto work(const I& p) const {
    return particles.get(particles.work, p);
  }
  template <class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION void set_work(const I& p, const T& value) const {
    particles.put(particles.work, p, 0, value);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto scratch(const I& p, int column) const {
    return particles.get(particles.scratch, p, column);
  }
  template <class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION void set_scratch(const I& p, int column, const T& value) const {
    particles.put(particles.scratch, p, column, value);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto compression(const I& p) const {
    return particles.get(particles.compression, p);
  }
  template <class I, class T>
  KOKKOS_FORCEINLINE_FUNCTION void set_compression(const I& p, const T& value) const {
    if (particles.compression.extent(1) > 0) particles.put(particles.compression, p, 0, value);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto rho(const I& p) const {
    return mass(p) / volume(p);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto pressure(const I& p) const {
    return -stress(p)[0];
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto rate(const I& p) const {
    return strain_rate<G>(particles.matrix(particles.gradient, p));
  }
  /// The pressure without the part that no node sees, which scratch column 0 holds.
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto smooth_pressure(const I& p) const {
    const auto all = pressure(p);
    return clamp(all - scratch(p, 0), 0.5 * all, 2 * all);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION void refresh(const I& p) const {
    set_stress(p, material.state(rho(p), load(p)).stress);
  }
  /// The state at the end of a step.
  template <class I, class T, class H>
  KOKKOS_FORCEINLINE_FUNCTION void finish(const I& p, const StrainOf<T>& in, const ResponseOf<T>& r,
                                          const H& h) const {
    set_volume(p, volume(p) * in.growth);
    set_stress(p, r.stress);
    save(p, h);
  }
  /// 1 + tr D dt (A.16), bounded where a step overshoots; see largest volume change in the time
  /// step.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T growth(const SymOf<T>& rate, double dt) {
    return most(1 + trace(rate) * T(dt), T(0.1));
  }
  /// Solids: the stress turned with the rigid rotation of a step, as are the directions in h.
  template <class I, class H>
  KOKKOS_FORCEINLINE_FUNCTION auto turn(const I& p, double dt, [[maybe_unused]] H& h) const {
    const auto r = rotation<G>(particles.matrix(particles.gradient, p), dt);
    if constexpr (M::directed) M::rotate(h, r);
    return turned<G>(stress(p), r);
  }
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto strain(const I& p, double dt,
                                          const Surroundings<G>& around) const {
    StrainOf<decltype(mass(p))> in;
    in.rate = rate(p);
    in.dt = dt;
    in.time = around.time + dt;
    in.rho0 = rho(p);
    in.growth = growth(in.rate, dt);
    in.rho1 = in.rho0 / in.growth;
    in.volume_change = (in.growth - 1) / in.rho0;
    in.h = around.lattice.h;
    if constexpr (M::burns) in.spacing = particles.root(mass(p) / material.eos.rho0);
    if (around.limited) in.smoothness = smoothness(p, around);
    return in;
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION double smoothness(int p, const Surroundings<G>& around) const {
    return around.smoothness(around.lattice.cell_of(particles.x(p)), 0);
  }
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION Wide smoothness(const Bundle<full, repeats>& b,
                                              const Surroundings<G>& around) const {
    const Lattice<G::dim>& lattice = around.lattice;
    Wide cell;
    for (int d = 0; d < G::dim; ++d) {
      const Wide at = (particles.get(particles.position, b, d) - lattice.origin[d]) * lattice.per_h;
      cell += (clamp(floor(at), 0, lattice.cells[d] - 1) + lattice.halo) * lattice.stride[d];
    }
    int number[Wide::lanes];
    cell.write_whole(number);
    return Wide::of([&](int lane) { return around.smoothness(number[lane], 0); });
  }
};

}  // namespace brisance
