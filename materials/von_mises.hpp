#pragma once
// J2 plasticity by the radial return of Wilkins (1964), exact for the step; perfectly plastic or
// with linear isotropic hardening (Krieg & Krieg 1977).
#include "materials/plastic.hpp"

namespace brisance {

struct VonMises : Plastic {
  static constexpr const char* name = "von mises";

  double yield = 0;      ///< stress in tension at which it first yields [Pa]
  double hardening = 0;  ///< its growth over the equivalent plastic strain [Pa]

  explicit VonMises(const Teuchos::ParameterList& list);
  static Teuchos::ParameterList valid_parameters(const Teuchos::ParameterList& given);

  KOKKOS_INLINE_FUNCTION Response update(const Strain& in, const Sym3& old, History& h) const {
    Response r{added(old, in.dt, intact.stress(in.rate)), speed(in.rho1)};
    const double q2 = 3 * second_invariant(r.stress), limit = yield + hardening * h.plastic_strain;
    if (!(q2 > square(limit))) return r;
    const double q = sqrt(q2), slip = (q - limit) / (3 * intact.G + hardening);
    const Sym3 trial = r.stress;
    r.stress = with_deviator_scaled(trial, (limit + hardening * slip) / q);
    h.plastic_strain += slip;
    h.plastic_work +=
        plastic_work(intact, middle(old, r.stress), added(trial, -1, r.stress)) / in.rho0;
    return r;
  }
};

}  // namespace brisance
