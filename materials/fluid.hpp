#pragma once
// A fluid: an equation of state with the viscosities it was given.
#include "materials/burning.hpp"
#include "materials/viscosity.hpp"

namespace brisance {

template <class Eos, class Shear = Inviscid, class Shock = NoShockViscosity>
struct Fluid {
  static constexpr const char* name = Eos::name;
  static constexpr Stress stress = Shear::stress;
  static constexpr bool fluid = true;
  static constexpr bool burns = Eos::burns, conducts = Eos::conducts, thermal = Eos::thermal;

  using State = FluidState<burns>;
  using History = typename State::History;
  static constexpr int field_count = State::field_count;
  static constexpr const auto& fields = State::fields;

  Eos eos;
  Shear shear;
  Shock shock;

  KOKKOS_INLINE_FUNCTION static double energy(const History& h) { return h.energy; }

  /// Of an explosive, the share that is products.
  KOKKOS_INLINE_FUNCTION static double burned([[maybe_unused]] const History& h) {
    if constexpr (burns)
      return h.burned;
    else
      return 1;
  }
  /// Whether corrections may move volume and heat of the point: not while it burns.
  KOKKOS_INLINE_FUNCTION static bool relaxes(const History& h) { return burned(h) >= 1; }
  /// The share burned after a step.
  KOKKOS_INLINE_FUNCTION void advance_burn([[maybe_unused]] const Strain& in,
                                           [[maybe_unused]] History& h) const {
    if constexpr (burns) h.burned = eos.burn.after(in, eos.rho0, h.burned, h.lighting_time);
  }

  KOKKOS_INLINE_FUNCTION double pressure(double rho, const History& h) const {
    const double p = eos.offset(rho) + eos.slope(rho) * h.energy;
    return (thermal ? most(p, 0) : p) * burned(h);
  }
  /// What bounds the viscosity of an expansion: the pressure, or the stiffness of what bears
  /// tension. [Pa]
  KOKKOS_INLINE_FUNCTION double strength(double rho, const History& h) const {
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
  KOKKOS_INLINE_FUNCTION double speed_of_sound(double rho, const History& h) const {
    return sqrt(most(eos.sound_speed2(rho, h.energy), 0) * burned(h));
  }
  /// While matter burns, the detonation is the signal: it runs at 1 / (1 - V_CJ) of the sound
  /// behind it, some four thirds.
  KOKKOS_INLINE_FUNCTION double sound_speed(double rho, const History& h) const {
    const double c = speed_of_sound(rho, h);
    if constexpr (burns)
      if (h.burned < 1) return most(c, 0.75 * eos.burn.speed);
    return c;
  }

  KOKKOS_INLINE_FUNCTION Response state(double rho, const History& h) const {
    Response r;
    r.stress[0] = r.stress[1] = r.stress[2] = -pressure(rho, h);
    r.sound_speed = sound_speed(rho, h);
    return r;
  }

  /// The fastest signal while the point is strained at `rate`. [m/s]
  KOKKOS_INLINE_FUNCTION double signal_speed(const Sym3& rate, double rho, double c,
                                             double h) const {
    const double b = shock.speed(c, eos.shock_slope(), trace(rate), h);
    return b + sqrt(square(b) + square(c)) + shear.signal_speed(rho, h);
  }

  /// Energy by the trapezoid rule in closed form, with which the iteration of (A.19)-(A.22) agrees:
  /// e1 = [e0 - ((p0 + offset1)/2 + q) dv + dev(sigma_visc) : D dt / rho0] / [1 + slope1 dv / 2],
  /// where q is the mean of the viscous pressures before and after, as far as `old` holds the
  /// former.
  KOKKOS_INLINE_FUNCTION Response update(const Strain& in, const Sym3& old, History& h) const {
    const double K = eos.shock_slope();
    const double q =
        shock.pressure(in.rho0, strength(in.rho0, h), speed_of_sound(in.rho0, h), K, in);
    advance_burn(in, h);
    const Sym3 viscous = shear.stress_of(in.rate);
    const double viscous_pressure = q - trace(viscous) / 3, p0 = -trace(old) / 3,
                 dv = in.volume_change;
    const double shear_work = contract(viscous, in.rate) - trace(viscous) * trace(in.rate) / 3;
    h.energy = (h.energy -
                (0.5 * (p0 + burned(h) * eos.offset(in.rho1)) +
                 (in.viscous_before ? 0.5 : 1) * viscous_pressure) *
                    dv +
                shear_work * in.dt / in.rho0) /
               (1 + 0.5 * burned(h) * eos.slope(in.rho1) * dv);
    if constexpr (thermal) h.energy = most(h.energy, 0);
    Response r = state(in.rho1, h);
    for (int k = 0; k < 3; ++k) r.stress[k] -= q;
    for (int k = 0; k < 6; ++k) r.stress[k] += viscous[k];
    return r;
  }
};

}  // namespace brisance
