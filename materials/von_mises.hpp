#pragma once
// J2 plasticity by the radial return of Wilkins (1964), exact for the step; perfectly plastic or
// with linear isotropic hardening (Krieg & Krieg 1977). Two ends of strength, each on request and
// without a state variable of its own:
// - tension cut-off: the mean stress stays at this limit while the matter opens, as in the pressure
//   limit of LS-DYNA (material 15, SPALL = 1; Hallquist, Theory Manual (2006));
// - failure strain: from this plastic strain on, neither shear nor tension, like what has spalled
//   there under SPALL = 2 and 3.
// In rate form neither remembers how far the matter has opened: it presses as soon as it is
// compressed again. What elastic energy is lost counts as plastic.
#include "materials/plastic.hpp"

namespace brisance {

struct VonMises : Plastic {
  static constexpr const char* name = "von mises";

  double yield = 0;      ///< stress in tension at which it first yields [Pa]
  double hardening = 0;  ///< its growth over the equivalent plastic strain [Pa]
  double cut_off = 0;    ///< greatest mean stress [Pa]
  double failure = 0;    ///< plastic strain that ends the strength [-]

  explicit VonMises(const Teuchos::ParameterList& list);
  static Teuchos::ParameterList valid_parameters(const Teuchos::ParameterList& given);

  KOKKOS_INLINE_FUNCTION Response update(const Strain& in, const Sym3& old, History& h) const {
    Response r{added(old, in.dt, intact.stress(in.rate)), speed(in.rho1)};
    const Sym3 trial = r.stress;
    const double mean = trace(trial) / 3, q2 = 3 * second_invariant(trial),
                 limit = yield + hardening * h.plastic_strain;
    const bool yields = q2 > square(limit) && h.plastic_strain < failure;
    if (yields) {
      const double q = sqrt(q2), slip = (q - limit) / (3 * intact.G + hardening);
      r.stress = with_deviator_scaled(trial, (limit + hardening * slip) / q);
      h.plastic_strain += slip;
    }
    if (!(h.plastic_strain < failure)) {
      r.stress = {};
      for (int k = 0; k < 3; ++k) r.stress[k] = least(mean, 0);
    } else if (mean > cut_off) {
      for (int k = 0; k < 3; ++k) r.stress[k] += cut_off - mean;
    } else if (!yields) {
      return r;
    }
    h.plastic_work +=
        plastic_work(intact, middle(old, r.stress), added(trial, -1, r.stress)) / in.rho0;
    return r;
  }
};

}  // namespace brisance
