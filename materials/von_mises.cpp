#include "materials/von_mises.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/parameters.hpp"

namespace brisance {

VonMises::VonMises(const List& list)
    : Plastic(list),
      yield(get<double>(list, "yield stress")),
      hardening(get<double>(list, "hardening modulus")) {}

List VonMises::valid_parameters(const List&) {
  List valid = Solid::valid_parameters();
  declare_required<double>(valid, "yield stress", positive(), "in tension, at first yield [Pa]");
  declare(
      valid, "hardening modulus", 0.0, at_least_zero(),
      "growth of the yield stress over the equivalent plastic strain; 0: perfectly plastic [Pa]");
  return valid;
}

}  // namespace brisance
