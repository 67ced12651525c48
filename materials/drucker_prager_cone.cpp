#include "materials/drucker_prager_cone.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "core/parameters.hpp"

namespace brisance {
namespace {

const double root3 = std::sqrt(3.0);

/// The cone around the corners of Mohr and Coulomb's pyramid under compression.
DruckerPragerCone compression_cone(double sine, double cosine, double cohesion) {
  const double share = 2 / (root3 * (3 - sine));
  return {share * sine, 0, 3 * share * cohesion * cosine};
}

DruckerPragerCone cone_of(const List& list) {
  const std::string cone = get<std::string>(list, "cone");
  if (cone == "alpha and k") return {get<double>(list, "alpha"), 0, get<double>(list, "k")};
  if (cone == "friction") {
    const double angle = get<double>(list, "friction angle") * std::acos(-1.0) / 180;
    return compression_cone(std::sin(angle), std::cos(angle), get<double>(list, "cohesion"));
  }
  const double fc = get<double>(list, "compressive strength");
  if (cone == "A") {
    const double ft = get<double>(list, "tensile strength");
    if (ft > fc) refuse(list, "tensile strength", "must be <= 'compressive strength'");
    return {(fc - ft) / (root3 * (fc + ft)), 0, 2 * fc * ft / (root3 * (fc + ft))};
  }
  if (cone == "B") {  // Kupfer, Hilsdorf & Rusch (1969)
    const double ratio = 1.16;
    return {(ratio - 1) / (root3 * (2 * ratio - 1)), 0, ratio * fc / (root3 * (2 * ratio - 1))};
  }
  // Richart, Brandtzaeg & Brown (1928): s1 = fc + 4.1 s3, where 4.1 = (1 + sin) / (1 - sin).
  const double sine = (4.1 - 1) / (4.1 + 1), cosine = std::sqrt(1 - sine * sine);
  return compression_cone(sine, cosine, fc * (1 - sine) / (2 * cosine));
}

void declare_strength(List& valid, const char* name, double standard, const char* doc) {
  if (standard > 0) return declare(valid, name, standard, positive(), doc);
  declare_required<double>(valid, name, positive(), doc);
}

}  // namespace

DruckerPragerCone::DruckerPragerCone(const List& list) : DruckerPragerCone(cone_of(list)) {
  beta = get<double>(list, "dilatancy");
  if (beta > alpha) {
    refuse(list, "dilatancy", "must be <= alpha of the cone, " + text_of(alpha));
  }
}

void DruckerPragerCone::declare_in(List& valid, const List& given, const Strengths& standard) {
  declare(valid, "cone", "C", one_of({"A", "B", "C", "alpha and k", "friction"}),
          "fitted to A: compressive and tensile strength, B: compressive and 1.16 times that if "
          "biaxial, C: compressive and 4.1 times the confinement; or given directly [-]");
  const std::string cone = peek<std::string>(given, valid, "cone");
  if (cone == "alpha and k") {
    declare_required<double>(valid, "alpha", at_least_zero(),
                             "friction in sqrt(J2) + alpha I1 = k [-]");
    declare_required<double>(valid, "k", positive(), "strength in shear without pressure [Pa]");
  } else if (cone == "friction") {
    declare_required<double>(valid, "friction angle", at_least_zero() && below(90),
                             "of Mohr and Coulomb, matched in compression [degree]");
    declare_required<double>(valid, "cohesion", positive(), "of Mohr and Coulomb [Pa]");
  } else {
    declare_strength(valid, "compressive strength", standard.compressive,
                     "of a bar, as a positive number [Pa]");
    if (cone == "A") {
      declare_strength(valid, "tensile strength", standard.tensile, "of a bar [Pa]");
    }
  }
  declare(valid, "dilatancy", 0.0, at_least_zero(),
          "beta of the flow potential sqrt(J2) + beta I1; 0: no change of volume [-]");
}

}  // namespace brisance
