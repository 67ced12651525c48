#pragma once
// The contract between a material law and the method. A law is a plain struct that works on plain
// numbers for one point, so that it can be tested without a mesh. One that is `wide` is written for
// a type T of numbers and serves eight points at once, too (core/wide.hpp): where a point decides,
// it selects in place of branching, and its state is HistoryOf<T> with fields_of<T>. A law has
//   name, stress, fluid           what the input calls it; pressure or tensor; whether density and
//                                 energy are its state
//   History, fields               its state variables, one of them `energy`, and their names and
//                                 units for output and restart
//   initial(rho, given, from_energy)  the state variables of fresh matter
//   update(Strain, old, history)  stress and state at the end of a strain increment
//   sound_speed(rho, history), signal_speed(rate, rho, c, h)  what limits the time step: sound and
//                                 viscosities [m/s]
//   energy(history)               specific internal energy [J/kg]
// and, on the host, valid_parameters() and a constructor from the checked list. Fluids have
//   state(rho, history)           the stress that belongs to a density and its history
// and solids, for which the method has already turned `old` with the rigid rotation of the step,
//   density()                     when free of stress [kg/m^3]
//   energies(stress, rho, history)  where the work done on the point has gone
//   whole(history)                whether stresses of neighbours tell of the point's own
//   directed, rotate(history, R)  whether the history holds directions, and their turn by R
// The energy of a solid is a ledger: the method adds to it the work and the heat that a point
// receives, the law does not read it.
#include "core/particles.hpp"
#include "core/types.hpp"

namespace brisance {

/// What happens to a point in a step.
template <class T>
struct StrainOf {
  SymOf<T> rate;         ///< rate of deformation [1/s]
  double dt = 0;         ///< [s]
  double time = 0;       ///< at its end [s]
  T growth = 1;          ///< volume after over that before [-]
  T rho0 = 0, rho1 = 0;  ///< density before and after [kg/m^3]
  T volume_change = 0;   ///< change of specific volume that pressure works on [m^3/kg]
  double h = 0;          ///< cell size, over which shocks and cracks are spread [m]
  T spacing = 0;         ///< of explosives: of the points before they burn [m]
  T smoothness = 0;      ///< 1 where the flow around is smooth, 0 in a shock [-]
  bool viscous_before =
      false;  ///< whether the stress before the step holds viscous parts (MUSL) or is of rest
};

/// What a law answers.
template <class T>
struct ResponseOf {
  SymOf<T> stress;    ///< tension positive [Pa]
  T sound_speed = 0;  ///< [m/s]
};

using Strain = StrainOf<double>;
using Response = ResponseOf<double>;

/// What a history is made of: one number, or several.
template <class History>
using Number = std::decay_t<decltype(History::energy)>;

/// One state variable of a law.
template <class History, class T = double>
struct Field {
  const char* name;
  const char* unit;
  T History::*member;
};

}  // namespace brisance
