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

  /// Returns trial stresses to the cone where it is wanted, implicitly and exactly: along the flow,
  /// or to the apex where that would pass it. The answer is which of them were outside; their
  /// equivalent plastic strain grows by that of the deviator.
  template <class M, class T>
  KOKKOS_FORCEINLINE_FUNCTION Truth<T> bring_back(const IsotropicOf<M>& m, SymOf<T>& stress,
                                                  T& plastic_strain, const Truth<T>& wanted) const {
    const T J2 = second_invariant(stress), limit = k - alpha * trace(stress);
    const auto outside = wanted && (limit < T(0) || J2 > square(limit));
    if (!any(outside)) return outside;
    constexpr double per_root3 = 0.57735026918962576;
    const T shear = sqrt(J2), stiffness = select(outside, T(m.G + 9 * alpha * beta * m.K), T(1)),
            flow = (shear - limit) / stiffness, left = shear - m.G * flow;
    const auto beyond = alpha * left < T(0);
    const T apex = alpha > 0 ? k / (3 * alpha) : 0, kept = most(left, T(0)),
            scale = kept / select(outside && kept > T(0), shear, T(1));
    SymOf<T> back = with_deviator_scaled(stress, scale);
    for (int i = 0; i < 3; ++i) back[i] = select(beyond, apex, back[i] - 3 * beta * m.K * flow);
    stress = select(outside, back, stress);
    plastic_strain += select(outside, select(beyond, shear * m.per_G, flow) * per_root3, T(0));
    return outside;
  }
};

}  // namespace brisance
