#include "materials/drucker_prager.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/parameters.hpp"

namespace brisance {

List DruckerPrager::valid_parameters(const List& given) {
  List valid = Solid::valid_parameters();
  DruckerPragerCone::declare_in(valid, given, {});
  return valid;
}

}  // namespace brisance
