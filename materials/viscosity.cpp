#include "materials/viscosity.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/parameters.hpp"

namespace brisance {

Newtonian::Newtonian(const List& list)
    : mu(get<double>(list, "shear")), lambda(get<double>(list, "bulk") - 2 * mu / 3) {}

List Newtonian::valid_parameters() {
  List valid;
  declare_required<double>(valid, "shear", at_least_zero(), "dynamic viscosity mu [Pa s]");
  declare(valid, "bulk", 0.0, at_least_zero(),
          "bulk viscosity, lambda + 2 mu / 3; 0 is Stokes' assumption [Pa s]");
  return valid;
}

ShockViscosity::ShockViscosity(const List& list)
    : form(get<std::string>(list, "form") == "Kurapatenko" ? Form::kurapatenko
                                                           : Form::von_neumann_richtmyer),
      c0(get<double>(list, "quadratic")),
      c1(get<double>(list, "linear")),
      ce(get<double>(list, "expansion")),
      limiter(get<double>(list, "limiter")) {}

}  // namespace brisance
