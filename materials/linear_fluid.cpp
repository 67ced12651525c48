#include "materials/linear_fluid.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <cstdio>

#include "core/parameters.hpp"

namespace brisance {

LinearFluid::LinearFluid(const List& list)
    : modulus(get<double>(list, "bulk modulus")), rho0(get<double>(list, "density")) {}

List LinearFluid::valid_parameters() {
  List valid;
  declare_required<double>(valid, "bulk modulus", positive(),
                           "pressure over the logarithm of compression [Pa]");
  declare_required<double>(valid, "density", positive(), "where the pressure is 0 [kg/m^3]");
  return valid;
}

void LinearFluid::declare_state(List& valid, const List& given) const {
  const bool pressed = given.isParameter("pressure"), dense = given.isParameter("density");
  List schema;
  declare(schema, "pressure", 0.0, anything(), "pressure, tension negative [Pa]");
  const double p = peek<double>(given, schema, "pressure");
  declare(valid, "density", rho0 * std::exp(p / modulus), positive(),
          "density; if absent, that of the pressure [kg/m^3]");
  const double of_density = offset(peek<double>(given, valid, "density"));
  declare(valid, "pressure", of_density, anything(),
          "pressure, tension negative; if absent, that of the density [Pa]");
  // Nine digits of the density: more than anyone types, less than round-off disturbs.
  if (!pressed || !dense || std::fabs(p - of_density) <= 1e-9 * modulus) return;
  char rule[80];
  std::snprintf(rule, sizeof rule, "must be %.9g, which belongs to its density, or be absent",
                of_density);
  refuse(given, "pressure", rule);
}

}  // namespace brisance
