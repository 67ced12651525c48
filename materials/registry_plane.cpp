#include "materials/registry_impl.hpp"

namespace brisance {
template std::unique_ptr<Group<PlaneStrain>> make_group<PlaneStrain>(const List&, const List&);
}
