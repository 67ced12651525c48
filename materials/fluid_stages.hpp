#pragma once
// What the stages of a step do to the points of a fluid, as function objects f(point, p): p is one
// particle, or eight where the law is wide, so that points are selected, not branched upon.
#include "materials/point.hpp"

namespace brisance {
namespace fluid_stages {

/// Stress <- the stress half a step on.
template <class G>
struct HalfStep {
  Surroundings<G> around;
  double dt;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    auto h = point.load(p);
    const auto old = point.stress(p);
    point.set_stress(p, point.material.update(point.strain(p, 0.5 * dt, around), old, h).stress);
  }
};

/// Volume, and the share burned, at the end of a step.
template <class G>
struct Strained {
  Surroundings<G> around;
  double dt;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    if constexpr (P::Law::burns) {
      auto h = point.load(p);
      point.material.advance_burn(point.strain(p, dt, around), h);
      point.save(p, h);
    }
    point.set_volume(p, point.volume(p) * point.growth(point.rate(p), dt));
  }
};

/// The whole step of MUSL.
template <class G>
struct Update {
  Surroundings<G> around;
  double dt;
  bool printed_work;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    auto strain = point.strain(p, dt, around);
    strain.viscous_before = true;
    if (printed_work) strain.volume_change = trace(strain.rate) * dt / strain.rho1;
    auto h = point.load(p);
    const auto r = point.material.update(strain, point.stress(p), h);
    point.finish(p, strain, r, h);
  }
};

/// Energy <- energy + work.
struct ReceiveWork {
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    auto h = point.load(p);
    h.energy += point.work(p);
    point.save(p, h);
    point.refresh(p);
  }
};

// Relaxations: what the two scratch columns hold is told in core/relaxation.cpp.

struct CorrectVolume {
  double rate;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    const auto s = point.scratch(p, 0), emptiness = point.scratch(p, 1);
    using T = std::decay_t<decltype(s)>;
    const auto full = !(emptiness > T(0)) && s > T(0) && P::Law::relaxes(point.load(p));
    const T share = rate * point.material.eos.volume_share;
    const T growth = clamp(1 - share * (1 - 1 / select(full, s, T(1))), T(0.7), T(1.4));
    point.set_volume(p, point.volume(p) * growth);
    point.refresh(p);
  }
};

struct LoadPressure {
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    point.set_scratch(p, 0, point.pressure(p));
  }
};

struct ProposeExchange {
  double rate, dt, h;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    const auto state = point.load(p);
    const auto pressure = point.pressure(p), smooth = point.smooth_pressure(p);
    using T = std::decay_t<decltype(pressure)>;
    const auto presses = pressure > T(0) && P::Law::relaxes(state);
    const T rho = point.rho(p), c = point.material.sound_speed(rho, state);
    const T modulus = rho * c * c * smooth,
            most_z = 0.3 * least(T(1), point.mass(p) * state.energy /
                                           select(presses, pressure * point.volume(p), T(1)));
    const T z = least(T(1), c * (rate * dt / h)) * (pressure - smooth) * pressure /
                select(presses, modulus, T(1));
    point.set_scratch(p, 1, select(presses, clamp(z, -most_z, most_z), T(0)));
  }
};

struct ExchangeVolume {
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    const auto h = point.load(p);
    const auto volume = point.volume(p);
    using T = std::decay_t<decltype(volume)>;
    const T inner = select(P::Law::relaxes(h), point.mass(p) * h.energy, T(0));
    const auto takes = inner > T(0);
    const T gain = point.scratch(p, 1) * volume;
    point.set_scratch(
        p, 0, select(takes, point.smooth_pressure(p) * gain / select(takes, inner, T(1)), T(0)));
    point.set_scratch(p, 1, inner);
    point.set_volume(p, select(takes, volume + gain, volume));
  }
};

struct ExchangeEnergy {
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    const auto h = point.load(p);
    using T = std::decay_t<decltype(h.energy)>;
    point.set_work(p, select(P::Law::relaxes(h), -point.scratch(p, 0) * h.energy, T(0)));
  }
};

struct LoadHeat {
  double rate, dt;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    const auto h = point.load(p);
    using T = std::decay_t<decltype(h.energy)>;
    const T compression = -trace(point.rate(p));
    const T share =
        select(P::Law::relaxes(h), compression * (P::Law::conducts ? rate * dt : 0), T(0));
    point.set_scratch(p, 0, h.energy);
    point.set_scratch(p, 1, point.mass(p) * clamp(share, T(0), T(0.5)));
  }
};

struct Conduct {
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    const auto share = point.scratch(p, 1) / point.mass(p);
    if (!any(share > std::decay_t<decltype(share)>(0))) return;
    auto h = point.load(p);
    h.energy -= share * point.scratch(p, 0);
    point.save(p, h);
    point.refresh(p);
  }
};

}  // namespace fluid_stages
}  // namespace brisance
