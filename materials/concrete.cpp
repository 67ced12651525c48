#include "materials/concrete.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/parameters.hpp"

namespace brisance {
namespace {

// Constants without a source beside them are those of Hu & Chen (2006), section 4.2.
constexpr double E = 25e9, nu = 0.15, rho = 2320, toughness = 1e6, exponent = 6, flaws = 5e26;
constexpr double u0 = 6e-4, Cm = 10, theta = 1;
// f'c from E = 4700 sqrt(f'c) [MPa] of ACI 318, and a tenth of it in tension.
constexpr DruckerPragerCone::Strengths strengths{28.3e6, 2.83e6};

Concrete::ShearLimit limit_named(const std::string& name) {
  if (name == "none") return Concrete::ShearLimit::none;
  return name == "always" ? Concrete::ShearLimit::always : Concrete::ShearLimit::before_onset;
}

}  // namespace

Concrete::Concrete(const List& list)
    : Solid(list),
      damage(get<double>(list, "Young's modulus"), get<double>(list, "Poisson's ratio"), rho_rest,
             get<double>(list, "fracture toughness"), get<double>(list, "flaw density"),
             get<double>(list, "flaw exponent")),
      cone(list),
      decohesion{get<double>(list, "critical opening"), get<double>(list, "shear strength ratio"),
                 get<double>(list, "softening exponent")},
      strain_share(get<std::string>(list, "damage strain") == "mean" ? 1. / 3 : 1),
      rate_share(get<std::string>(list, "damage rate") == "mean" ? 1. / 3 : 1),
      least_rate(get<double>(list, "least damage rate")),
      shear_limit(limit_named(get<std::string>(list, "shear limit in tension"))),
      recovers(get<bool>(list, "recover stiffness")) {}

List Concrete::valid_parameters(const List& given) {
  List valid;
  declare(valid, "Young's modulus", E, stiffness(), "stiffness of a bar [Pa]");
  declare(
      valid, "Poisson's ratio", nu, between(0, 0.35),
      "lateral contraction over extension of a bar; beyond 0.39 damage would make it stiffer in "
      "shear [-]");
  declare(valid, "density", rho, positive(), "when free of stress [kg/m^3]");

  declare(valid, "fracture toughness", toughness, positive(), "K_IC [Pa m^0.5]");
  declare(valid, "flaw exponent", exponent, at_least(1),
          "m in N = k eps_v^m; strength grows with the rate to the power 2/m [-]");
  declare(valid, "flaw density", flaws, positive(), "k in N = k eps_v^m [1/m^3]");
  declare(valid, "damage strain", "mean", one_of({"mean", "trace"}),
          "what eps_v is of the volumetric strain: a third, or all [-]");
  declare(valid, "damage rate", "trace", one_of({"mean", "trace"}),
          "the same of the rate that sizes the fragments [-]");
  declare(valid, "least damage rate", 1.0, positive(),
          "floor of that rate; without one slow matter has no strength [1/s]");
  declare(
      valid, "shear limit in tension", "before onset", one_of({"none", "before onset", "always"}),
      "whether sqrt(J2) stays below the k of the cone though the mean stress is tensile; damage "
      "does not see shear [-]");

  declare(valid, "critical opening", u0, positive(),
          "of a plane under tension when it is separate [m]");
  declare(valid, "shear strength ratio", Cm, positive(),
          "strength of a plane in shear over that in tension [-]");
  declare(valid, "softening exponent", theta, positive(),
          "theta in the strength 1 - lambda^theta of a plane [-]");

  DruckerPragerCone::declare_in(valid, given, strengths);
  declare(valid, "recover stiffness", false, anything(),
          "whether damaged matter under pressure has its bulk modulus back [-]");
  return valid;
}

}  // namespace brisance
