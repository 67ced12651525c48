#pragma once
#include <iosfwd>

#include "core/parameters.hpp"

namespace brisance {

/// Prints every list and parameter of a schema for a terminal of 100 columns: name, default or
/// "required", unit, rule, documentation.
void describe(const List& valid, std::ostream& out);

}  // namespace brisance
