#pragma once
// A fluid: an equation of state with the viscosities it was given.
#include "materials/burning.hpp"
#include "materials/viscosity.hpp"

namespace brisance {

template <class Eos, class Shear = Inviscid, class Shock = NoShockViscosity>
struct Fluid : FluidState<Eos::burns> {
  static constexpr const char* name = Eos::name;
  static constexpr Stress stress = Shear::stress;
  static constexpr bool fluid = true;
  static constexpr bool burns = Eos::burns, conducts = Eos::conducts, thermal = Eos::thermal;

  static constexpr bool wide = Eos::wide;

  using History = typename FluidState<burns>::History;

  Eos eos;
  Shear shear;
  Shock shock;

  Fluid(const Eos& eos_, const Shear& shear_, const Shock& shock_)
      : eos(eos_), shear(shear_), shock(shock_) {}

  KOKKOS_INLINE_FUNCTION static double energy(const History& h) { return h.energy; }

  /// Of an explosive, the share that is products.
  template <class H>
  KOKKOS_FORCEINLINE_FUNCTION static auto burned([[maybe_unused]] const H& h) {
    if constexpr (burns)
      return h.burned;
    else
      return decltype(h.energy)(1);
  }
  /// Whether corrections may move volume and heat of the point: not while it burns.
  template <class H>
  KOKKOS_FORCEINLINE_FUNCTION static auto relaxes(const H& h) {
    return !(burned(h) < decltype(h.energy)(1));
  }
  /// The share burned after a step.
  template <class T, class H>
  KOKKOS_FORCEINLINE_FUNCTION void advance_burn([[maybe_unused]] const StrainOf<T>& in,
                                                [[maybe_unused]] H& h) const {
    if constexpr (burns) h.burned = eos.burn.after(in, eos.rho0, h.burned, h.lighting_time);
  }

  template <class H = History, class T = Number<H>>
  KOKKOS_FORCEINLINE_FUNCTION T pressure(const Number<H>& rho, const H& h) const {
    const T p = eos.offset(rho) + eos.slope(rho) * h.energy;
    return (thermal ? most(p, T(0)) : p) * burned(h);
  }
  /// What bounds the viscosity of an expansion: the pressure, or the stiffness of what bears
  /// tension. [Pa]
  template <class H = History, class T = Number<H>>
  KOKKOS_FORCEINLINE_FUNCTION T strength(const Number<H>& rho, const H& h) const {
    return thermal ? pressure(rho, h) : rho * eos.sound_speed2(rho, h.energy);
  }
  /// The state variables of gas at a given density and pressure [Pa], or specific energy [J/kg].
  KOKKOS_INLINE_FUNCTION History initial(double rho, double given, bool from_energy) const {
    History h;
    if (from_energy)
      h.energy = given;
    else if constexpr (thermal)
      h.energy = (given - eos.offset(rho)) / eos.slope(rho);
    else
      h.energy = eos.elastic_energy(rho);
    if constexpr (burns) h.burned = eos.burn.at_once ? 1 : 0;
    return h;
  }
  template <class H = History, class T = Number<H>>
  KOKKOS_FORCEINLINE_FUNCTION T speed_of_sound(const Number<H>& rho, const H& h) const {
    return sqrt(most(eos.sound_speed2(rho, h.energy), T(0)) * burned(h));
  }
  /// While matter burns, the detonation is the signal: it runs at 1 / (1 - V_CJ) of the sound
  /// behind it, some four thirds.
  template <class H = History, class T = Number<H>>
  KOKKOS_FORCEINLINE_FUNCTION T sound_speed(const Number<H>& rho, const H& h) const {
    const T c = speed_of_sound(rho, h);
    if constexpr (burns)
      if (h.burned < 1) return most(c, 0.75 * eos.burn.speed);
    return c;
  }

  template <class H = History>
  KOKKOS_FORCEINLINE_FUNCTION ResponseOf<Number<H>> state(const Number<H>& rho, const H& h) const {
    ResponseOf<Number<H>> r;
    r.stress[0] = r.stress[1] = r.stress[2] = -pressure(rho, h);
    r.sound_speed = sound_speed(rho, h);
    return r;
  }

  /// The fastest signal while the point is strained at `rate`. [m/s]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T signal_speed(const SymOf<T>& rate, const T& rho, const T& c,
                                             double h) const {
    const T b = shock.speed(c, eos.shock_slope(), trace(rate), h);
    return b + sqrt(square(b) + square(c)) + shear.signal_speed(rho, h);
  }

  /// Energy by the trapezoid rule in closed form, with which the iteration of (A.19)-(A.22) agrees:
  /// e1 = [e0 - ((p0 + offset1)/2 + q) dv + dev(sigma_visc) : D dt / rho0] / [1 + slope1 dv / 2],
  /// where q is the mean of the viscous pressures before and after, as far as `old` holds the
  /// former.
  template <class T, class H>
  KOKKOS_FORCEINLINE_FUNCTION ResponseOf<T> update(const StrainOf<T>& in, const SymOf<T>& old,
                                                   H& h) const {
    const double K = eos.shock_slope();
    const T q = shock.pressure(in.rho0, strength(in.rho0, h), speed_of_sound(in.rho0, h), K, in);
    advance_burn(in, h);
    const SymOf<T> viscous = shear.stress_of(in.rate);
    const T viscous_pressure = q - trace(viscous) * (1. / 3), p0 = -trace(old) * (1. / 3),
            dv = in.volume_change;
    if constexpr (Shear::stress == Stress::tensor)
      h.energy += (contract(viscous, in.rate) - trace(viscous) * trace(in.rate) * (1. / 3)) *
                  in.dt / in.rho0;
    h.energy = (h.energy - (0.5 * (p0 + burned(h) * eos.offset(in.rho1)) +
                            (in.viscous_before ? 0.5 : 1) * viscous_pressure) *
                               dv) /
               (1 + 0.5 * burned(h) * eos.slope(in.rho1) * dv);
    if constexpr (thermal) h.energy = most(h.energy, T(0));
    ResponseOf<T> r = state(in.rho1, h);
    for (int k = 0; k < 3; ++k) r.stress[k] -= q;
    for (int k = 0; k < 6; ++k) r.stress[k] += viscous[k];
    return r;
  }
};

}  // namespace brisance
