#pragma once
// dp = -B div u dt, that is p = B ln(rho / rho0): the liquid of section 4.3.1 of Hu & Chen (2006).
#include "core/types.hpp"

namespace Teuchos {
class ParameterList;
}

namespace brisance {

/// A liquid of constant bulk modulus. Its pressure does not depend on its energy, which is a ledger
/// of elastic energy and heat, and may be a tension.
struct LinearFluid {
  static constexpr const char* name = "linear fluid";
  static constexpr bool thermal = false, burns = false, conducts = false, wide = false;
  static constexpr double volume_share = 0;

  double modulus = 1, rho0 = 1;  ///< [Pa], [kg/m^3]

  LinearFluid(double modulus_, double density) : modulus(modulus_), rho0(density) {}
  explicit LinearFluid(const Teuchos::ParameterList& list);
  static Teuchos::ParameterList valid_parameters();

  /// Declares "density" and "pressure" of a body of it. Either gives the other; both must agree.
  void declare_state(Teuchos::ParameterList& valid, const Teuchos::ParameterList& given) const;

  KOKKOS_INLINE_FUNCTION double offset(double rho) const { return modulus * log(rho / rho0); }
  KOKKOS_INLINE_FUNCTION double slope(double) const { return 0; }
  KOKKOS_INLINE_FUNCTION double sound_speed2(double rho, double) const { return modulus / rho; }
  /// (K' + 1)/4 with K' = dB/dp = 0 (see PerfectGas, whose K' is gamma). [-]
  KOKKOS_INLINE_FUNCTION double shock_slope() const { return 0.25; }

  /// The integral of -p dv from rho0: B/rho0 (y e^y - e^y + 1), y = -p/B. [J/kg]
  KOKKOS_INLINE_FUNCTION double elastic_energy(double rho) const {
    const double y = log(rho0 / rho);
    return modulus / rho0 * (y * exp(y) - math::expm1(y));
  }
};

}  // namespace brisance
