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

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION ResponseOf<T> update(const StrainOf<T>& in, const SymOf<T>& old,
                                                   HistoryOf<T>& h) const {
    ResponseOf<T> r{added(old, in.dt, intact.stress(in.rate)), speed(in.rho1)};
    const SymOf<T> trial = r.stress;
    const auto all = T(0) < T(1);
    if (!any(cone.bring_back(intact, r.stress, h.plastic_strain, all))) return r;
    h.plastic_work +=
        plastic_work(intact, middle(old, r.stress), added(trial, -1, r.stress)) / in.rho0;
    return r;
  }
};

}  // namespace brisance
