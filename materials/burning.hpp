#pragma once
// How an explosive turns into its products, and the state variables that fluids keep for it.
#include "core/types.hpp"
#include "materials/material.hpp"

namespace brisance {

/// State variables of a fluid, whether it burns or not.
template <bool burns>
struct FluidState;

template <>
struct FluidState<false> {
  template <class T>
  struct HistoryOf {
    T energy = 0;
  };
  using History = HistoryOf<double>;
  static constexpr int field_count = 1, deciding = field_count;
  template <class T>
  static constexpr Field<HistoryOf<T>, T> fields_of[field_count] = {
      {"energy", "J/kg", &HistoryOf<T>::energy}};
  static constexpr const auto& fields = fields_of<double>;
};

template <>
struct FluidState<true> {
  struct History {
    double energy = 0;
    double burned = 1;  ///< share that is products: the pressure is that of the products times it
    double lighting_time = 0;  ///< when the detonation gets here
  };
  static constexpr int field_count = 3, deciding = field_count;
  static constexpr Field<History> fields[field_count] = {
      {"energy", "J/kg", &History::energy},
      {"burned", "-", &History::burned},
      {"lighting time", "s", &History::lighting_time}};
};

/// Program burn (Wilkins 1964): from its lighting time on, a point burns as the detonation crosses
/// a width. A burn within one step would make the pressure depend on where in its step a point is
/// lit.
struct Burn {
  bool at_once = false;  ///< all of it is products from the start
  double speed = 0;      ///< of detonation [m/s]
  double width = 2.5;    ///< over which it burns [spacings of the points]
  double cj_volume = 0;  ///< specific volume over the initial one at which compression has burned
                         ///< all; 0: compression burns nothing [-]

  /// The share burned at the end of a step that leaves the density at rho1.
  KOKKOS_INLINE_FUNCTION double after(const Strain& in, double rho_unburned, double burned,
                                      double lighting_time) const {
    const double lit = least(in.dt, in.time - lighting_time);
    double share = burned + most(lit, 0) * speed / (width * in.spacing);
    if (cj_volume > 0) share = most(share, (1 - rho_unburned / in.rho1) / (1 - cj_volume));
    return least(share, 1);
  }
};

}  // namespace brisance
