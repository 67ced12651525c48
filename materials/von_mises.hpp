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

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION ResponseOf<T> update(const StrainOf<T>& in, const SymOf<T>& old,
                                                   HistoryOf<T>& h) const {
    ResponseOf<T> r{added(old, in.dt, intact.stress(in.rate)), speed(in.rho1)};
    const SymOf<T> trial = r.stress;
    const T mean = trace(trial) * (1. / 3), q2 = 3 * second_invariant(trial),
            limit = yield + hardening * h.plastic_strain;
    const auto sound = h.plastic_strain < T(failure);
    const auto yields = q2 > square(limit) && sound, opens = mean > T(cut_off);
    if (!any(yields || opens || !sound)) return r;
    const T q = select(yields, sqrt(q2), limit),
            slip = (q - limit) * (1 / (3 * intact.G + hardening));
    h.plastic_strain += slip;
    r.stress = with_deviator_scaled(trial, select(yields, (limit + hardening * slip) / q, T(1)));
    // Slip may have used up the strength: then, too, it is what counts from here on.
    const auto holds = h.plastic_strain < T(failure);
    const T to_cut_off = select(opens, cut_off - mean, T(0));
    for (int k = 0; k < 3; ++k)
      r.stress[k] = select(holds, r.stress[k] + to_cut_off, least(mean, T(0)));
    for (int k = 3; k < 6; ++k) r.stress[k] = select(holds, r.stress[k], T(0));
    h.plastic_work +=
        plastic_work(intact, middle(old, r.stress), added(trial, -1, r.stress)) / in.rho0;
    return r;
  }
};

}  // namespace brisance
