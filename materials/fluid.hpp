#pragma once
// A fluid: an equation of state with the viscosities it was given.
#include <type_traits>

#include "materials/material.hpp"
#include "materials/viscosity.hpp"

namespace brisance {

/// Whether pressure depends on energy. Where an equation of state says that it does not, the energy
/// is a ledger and the pressure may be a tension.
template <class Eos, class = void>
inline constexpr bool is_thermal = true;
template <class Eos>
inline constexpr bool is_thermal<Eos, std::void_t<decltype(Eos::thermal)>> = Eos::thermal;

template <class Eos, class Shear = Inviscid, class Shock = NoShockViscosity>
struct Fluid {
  static constexpr const char* name = Eos::name;
  static constexpr Stress stress = Shear::stress;
  static constexpr bool fluid = true, thermal = is_thermal<Eos>;

  struct History {
    double energy = 0;
  };
  static constexpr int field_count = 1;
  static constexpr Field<History> fields[field_count] = {{"energy", "J/kg", &History::energy}};

  Eos eos;
  Shear shear;
  Shock shock;

  KOKKOS_INLINE_FUNCTION static double energy(const History& h) { return h.energy; }

  KOKKOS_INLINE_FUNCTION double pressure(double rho, double e) const {
    const double p = eos.offset(rho) + eos.slope(rho) * e;
    return thermal ? most(p, 0) : p;
  }
  /// What bounds the viscosity of an expansion: the pressure, or the stiffness of what bears
  /// tension. [Pa]
  KOKKOS_INLINE_FUNCTION double strength(double rho, double e) const {
    return thermal ? pressure(rho, e) : rho * eos.sound_speed2(rho, e);
  }
  /// The state variables of gas at a given density and pressure [Pa], or specific energy [J/kg].
  KOKKOS_INLINE_FUNCTION History initial(double rho, double given, bool from_energy) const {
    if (from_energy) return {given};
    if constexpr (thermal)
      return {(given - eos.offset(rho)) / eos.slope(rho)};
    else
      return {eos.elastic_energy(rho)};
  }
  KOKKOS_INLINE_FUNCTION double sound_speed(double rho, const History& h) const {
    return sqrt(most(eos.sound_speed2(rho, h.energy), 0));
  }

  KOKKOS_INLINE_FUNCTION Response state(double rho, const History& h) const {
    Response r;
    r.stress[0] = r.stress[1] = r.stress[2] = -pressure(rho, h.energy);
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
        shock.pressure(in.rho0, strength(in.rho0, h.energy), sound_speed(in.rho0, h), K, in);
    const Sym3 viscous = shear.stress_of(in.rate);
    const double viscous_pressure = q - trace(viscous) / 3, p0 = -trace(old) / 3,
                 dv = in.volume_change;
    const double shear_work = contract(viscous, in.rate) - trace(viscous) * trace(in.rate) / 3;
    h.energy =
        (h.energy -
         (0.5 * (p0 + eos.offset(in.rho1)) + (in.viscous_before ? 0.5 : 1) * viscous_pressure) *
             dv +
         shear_work * in.dt / in.rho0) /
        (1 + 0.5 * eos.slope(in.rho1) * dv);
    if constexpr (thermal) h.energy = most(h.energy, 0);
    Response r = state(in.rho1, h);
    for (int k = 0; k < 3; ++k) r.stress[k] -= q;
    for (int k = 0; k < 6; ++k) r.stress[k] += viscous[k];
    return r;
  }
};

}  // namespace brisance
