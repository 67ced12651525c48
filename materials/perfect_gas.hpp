#pragma once
// p = (gamma - 1) rho e, eq. (11) of Hu & Chen (2006).
#include "core/types.hpp"

namespace Teuchos {
class ParameterList;
}

namespace brisance {

/// An equation of state, linear in the specific energy at a given density: p = offset(rho) +
/// slope(rho) e. It says, too, whether that depends on the energy at all (where it does not, the
/// energy is a ledger and the pressure may be a tension), whether the matter burns, whether it is
/// written for eight points, too (materials/material.hpp), how much of the scheme's volume
/// relaxation it takes and whether it takes part in conduction.
struct PerfectGas {
  static constexpr const char* name = "perfect gas";
  static constexpr bool thermal = true, burns = false, wide = true;
  static constexpr double volume_share = 1;
  static constexpr bool conducts = true;

  double gamma = 1.4;

  explicit PerfectGas(double gamma_) : gamma(gamma_) {}
  explicit PerfectGas(const Teuchos::ParameterList& list);
  static Teuchos::ParameterList valid_parameters();

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T offset(const T&) const {
    return 0;
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T slope(const T& rho) const {
    return (gamma - 1) * rho;
  }
  /// Square of the sound speed. [m^2/s^2]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T sound_speed2(const T&, const T& e) const {
    return gamma * (gamma - 1) * e;
  }
  /// Half the slope of the shock speed over the jump in velocity, s/2 = (gamma + 1)/4
  /// (Kurapatenko). [-]
  KOKKOS_INLINE_FUNCTION double shock_slope() const { return 0.25 * (gamma + 1); }
};

}  // namespace brisance
