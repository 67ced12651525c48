#include "materials/registry_impl.hpp"

namespace brisance {
template std::unique_ptr<Group<Line>> make_group<Line>(const List&, const List&);
}
