#pragma once
// What all laws of solids have in common: isotropic elasticity and a density free of stress.
#include "core/particles.hpp"
#include "materials/isotropic.hpp"
#include "materials/material.hpp"

namespace Teuchos {
class ParameterList;
}

namespace brisance {

struct Rule;

struct Solid {
  static constexpr Stress stress = Stress::tensor;
  static constexpr bool fluid = false;
  static constexpr bool burns = false;
  static constexpr bool directed = false;
  static constexpr bool wide = true;

  Isotropic intact;     ///< moduli of sound matter
  double rho_rest = 0;  ///< [kg/m^3]

  explicit Solid(const Teuchos::ParameterList& list);
  static Teuchos::ParameterList valid_parameters();

  double density() const { return rho_rest; }

  /// Of longitudinal waves. [m/s]
  KOKKOS_FORCEINLINE_FUNCTION double speed(double rho) const {
    return sqrt(intact.constrained() / rho);
  }
  KOKKOS_FORCEINLINE_FUNCTION Wide speed(const Wide& rho) const {
    return sqrt(intact.constrained() / rho);
  }
  template <class T, class History>
  KOKKOS_FORCEINLINE_FUNCTION auto sound_speed(const T& rho, const History&) const {
    return speed(rho);
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T signal_speed(const SymOf<T>&, const T&, const T& c, double) const {
    return c;
  }
  /// Whether the point still hangs together with its neighbours, so that their stresses tell of its
  /// own.
  template <class History>
  KOKKOS_INLINE_FUNCTION static bool whole(const History&) {
    return true;
  }
  template <class History>
  KOKKOS_INLINE_FUNCTION static double energy(const History& h) {
    return h.energy;
  }
};

/// What a modulus may be: further on its products with stresses and strains are no numbers.
Rule stiffness();

/// The strain of a step.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION SymOf<T> increment(const StrainOf<T>& in) {
  return added(SymOf<T>{}, in.dt, in.rate);
}

}  // namespace brisance
