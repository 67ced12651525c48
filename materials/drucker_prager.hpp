#pragma once
// Perfect plasticity with friction: the cone of Drucker and Prager with its own dilatancy.
#include "materials/drucker_prager_cone.hpp"
#include "materials/plastic.hpp"

namespace brisance {

struct DruckerPrager : Plastic {
  static constexpr const char* name = "drucker prager";

  DruckerPragerCone cone;

  explicit DruckerPrager(const Teuchos::ParameterList& list) : Plastic(list), cone(list) {}
  static Teuchos::ParameterList valid_parameters(const Teuchos::ParameterList& given);

  KOKKOS_INLINE_FUNCTION Response update(const Strain& in, const Sym3& old, History& h) const {
    Response r{added(old, in.dt, intact.stress(in.rate)), speed(in.rho1)};
    const Sym3 trial = r.stress;
    if (!cone.bring_back(intact, r.stress, h.plastic_strain)) return r;
    h.plastic_work +=
        plastic_work(intact, middle(old, r.stress), added(trial, -1, r.stress)) / in.rho0;
    return r;
  }
};

}  // namespace brisance
