#include "materials/von_mises.hpp"

#include <Teuchos_ParameterList.hpp>
#include <limits>

#include "core/parameters.hpp"

namespace brisance {

namespace {

double or_endless(double limit) { return limit > 0 ? limit : std::numeric_limits<double>::max(); }

}  // namespace

VonMises::VonMises(const List& list)
    : Plastic(list),
      yield(get<double>(list, "yield stress")),
      hardening(get<double>(list, "hardening modulus")),
      cut_off(or_endless(get<double>(list, "tension cut-off"))),
      failure(or_endless(get<double>(list, "failure strain"))) {}

List VonMises::valid_parameters(const List&) {
  List valid = Solid::valid_parameters();
  declare_required<double>(valid, "yield stress", positive(), "in tension, at first yield [Pa]");
  declare(
      valid, "hardening modulus", 0.0, at_least_zero(),
      "growth of the yield stress over the equivalent plastic strain; 0: perfectly plastic [Pa]");
  declare(valid, "tension cut-off", 0.0, at_least_zero(),
          "greatest mean stress, at which the matter opens (spall); 0: none [Pa]");
  declare(valid, "failure strain", 0.0, at_least_zero(),
          "equivalent plastic strain from which it bears neither shear nor tension; 0: none [-]");
  return valid;
}

}  // namespace brisance
