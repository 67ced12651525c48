#include "materials/solid.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/parameters.hpp"

namespace brisance {

Solid::Solid(const List& list)
    : intact(Isotropic::from_young(get<double>(list, "Young's modulus"),
                                   get<double>(list, "Poisson's ratio"))),
      rho_rest(get<double>(list, "density")) {}

Rule stiffness() { return between(1e-60, 1e60); }

List Solid::valid_parameters() {
  List valid;
  declare_required<double>(valid, "Young's modulus", stiffness(), "stiffness of a bar [Pa]");
  declare_required<double>(valid, "Poisson's ratio", above(-1) && below(0.5),
                           "lateral contraction over extension of a bar [-]");
  declare_required<double>(valid, "density", positive(), "when free of stress [kg/m^3]");
  return valid;
}

}  // namespace brisance
