#pragma once
// The cone of Drucker & Prager (1952), tension positive: F = sqrt(J2) + alpha I1 - k <= 0, with
// flow along the potential sqrt(J2) + beta I1.
#include "materials/isotropic.hpp"

namespace Teuchos {
class ParameterList;
}

namespace brisance {

struct DruckerPragerCone {
  double alpha = 0;  ///< friction [-]
  double beta = 0;   ///< dilatancy, at most alpha: more would make energy [-]
  double k = 0;      ///< sqrt(J2) at no mean stress [Pa]

  /// Strengths that a schema offers as defaults; 0: none, they must be given. [Pa]
  struct Strengths {
    double compressive = 0, tensile = 0;
  };

  DruckerPragerCone(double alpha_, double beta_, double k_) : alpha(alpha_), beta(beta_), k(k_) {}
  explicit DruckerPragerCone(const Teuchos::ParameterList& list);
  /// Adds "cone" to a schema, and what the choice in `given` needs.
  static void declare_in(Teuchos::ParameterList& valid, const Teuchos::ParameterList& given,
                         const Strengths& standard);

  /// Returns a trial stress to the cone, implicitly and exactly: along the flow, or to the apex
  /// where that would pass it. The answer is whether it was outside; the equivalent plastic strain
  /// grows by that of the deviator.
  KOKKOS_INLINE_FUNCTION bool bring_back(const Isotropic& m, Sym3& stress,
                                         double& plastic_strain) const {
    const double J2 = second_invariant(stress), limit = k - alpha * trace(stress);
    if (limit >= 0 && J2 <= square(limit)) return false;
    constexpr double root3 = 1.7320508075688772;
    const double shear = sqrt(J2), flow = (shear - limit) / (m.G + 9 * m.K * alpha * beta),
                 left = shear - m.G * flow;
    if (left < 0 && alpha > 0) {
      stress = {};
      for (int i = 0; i < 3; ++i) stress[i] = k / (3 * alpha);
      plastic_strain += shear / (root3 * m.G);
      return true;
    }
    stress = with_deviator_scaled(stress, most(left, 0) / shear);
    for (int i = 0; i < 3; ++i) stress[i] -= 3 * m.K * beta * flow;
    plastic_strain += flow / root3;
    return true;
  }
};

}  // namespace brisance
