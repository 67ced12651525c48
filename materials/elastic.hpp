#pragma once
// Linear elasticity in rate form: sigma' = C : D, the method turns the stress with the matter.
#include "materials/solid.hpp"

namespace brisance {

struct Elastic : Solid {
  static constexpr const char* name = "elastic";

  struct History {
    double energy = 0;
  };
  static constexpr int field_count = 1;
  static constexpr Field<History> fields[field_count] = {{"energy", "J/kg", &History::energy}};

  using Solid::Solid;
  static Teuchos::ParameterList valid_parameters(const Teuchos::ParameterList& given);

  KOKKOS_INLINE_FUNCTION History initial(double, double, bool) const { return {}; }

  KOKKOS_INLINE_FUNCTION Response update(const Strain& in, const Sym3& old, History&) const {
    return {added(old, in.dt, intact.stress(in.rate)), speed(in.rho1)};
  }

  KOKKOS_INLINE_FUNCTION Energies energies(const Sym3& sigma, double rho, const History&) const {
    Energies e;
    e.elastic = intact.energy(sigma) / rho;
    return e;
  }
};

}  // namespace brisance
