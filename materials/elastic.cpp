#include "materials/elastic.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/parameters.hpp"

namespace brisance {

List Elastic::valid_parameters(const List&) { return Solid::valid_parameters(); }

}  // namespace brisance
