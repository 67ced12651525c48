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
    point.look_ahead(p);
    auto h = point.load(p);
    const auto old = point.stress(p);
    point.set_stress(p, point.material.update(point.strain(p, 0.5 * dt, around), old, h).stress);
  }
};

/// Volume, share burned and rate of compression at the end of a step.
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
    const auto rate = point.rate(p);
    point.set_volume(p, point.volume(p) * point.growth(rate, dt));
    point.set_compression(p, -trace(rate));
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

// Relaxations: what the scratch columns hold is told in core/relaxation.cpp.

struct CorrectVolume {
  double rate;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    point.look_ahead(p);
    const auto s = point.scratch(p, 1);
    using T = std::decay_t<decltype(s)>;
    // Shares of nodes that are not full are much, or what is left of their difference.
    const auto full = s < T(1e9) && s > T(0.5) && P::Law::relaxes(point.load(p));
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
    point.look_ahead(p);
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

/// Volumes by the proposed exchange, if there is one, but not of points that would pay more than
/// they have: products of explosives press on with next to no energy. What the other half of the
/// corrections starts from: scratch 0 <- share of the internal energy that the exchange costs, 1 <-
/// the energy, and 2
/// <- the part of the mass that shares its heat.
struct ExchangeVolume {
  bool exchanges;
  double heat;  ///< rate of the relaxation times the time it stands for [s]
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    point.look_ahead(p);
    const auto h = point.load(p);
    using T = std::decay_t<decltype(h.energy)>;
    const auto relaxes = P::Law::relaxes(h);
    if (exchanges) {
      const T volume = point.volume(p), inner = select(relaxes, point.mass(p) * h.energy, T(0)),
              gain = point.scratch(p, 1) * volume, pays = point.smooth_pressure(p) * gain;
      const auto takes = inner > fabs(pays);
      point.set_scratch(p, 0, select(takes, pays / select(takes, inner, T(1)), T(0)));
      point.set_scratch(p, 1, inner);
      point.set_volume(p, select(takes, volume + gain, volume));
    }
    if (heat > 0) {
      const T share = clamp((P::Law::conducts ? heat : 0) * point.compression(p), T(0), T(0.5));
      point.set_scratch(p, 2, select(relaxes, point.mass(p) * share, T(0)));
    }
  }
};

/// Work <- what exchange and shared heat give, once scratch 0 holds the share of the energy without
/// its mean and 1 the mean energy around.
struct ExchangeEnergy {
  bool exchanges, conducts;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    point.look_ahead(p);
    const auto h = point.load(p);
    using T = std::decay_t<decltype(h.energy)>;
    T work = exchanges ? -point.scratch(p, 0) * h.energy : T(0);
    if (conducts) work -= point.scratch(p, 2) / point.mass(p) * (h.energy - point.scratch(p, 1));
    point.set_work(p, select(P::Law::relaxes(h), work, T(0)));
  }
};

}  // namespace fluid_stages
}  // namespace brisance
