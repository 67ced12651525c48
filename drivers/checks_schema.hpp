#pragma once
// The lists of a scene that speak of what is measured in it.
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace brisance {

/// Adds "checks", "convergence" and "tradeoff" to the schema of a scene that was given, with the
/// measures that it has. `solids`: whether there are any.
void declare_checks(List& valid, const List& given, const std::vector<std::string>& materials,
                    bool solids, int dim);

}  // namespace brisance
