#pragma once
// What the parameter lists of several exact solutions have in common.
#include <array>
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace brisance {

/// A schema that begins with the parameter "solution".
List list_for_solution(const std::string& solution);

/// "gamma", which must be the material's.
void declare_gamma(List& valid);

/// "direction": x, y or z; and what it is as a number.
void declare_direction(List& valid);
int direction_of(const List& list);

/// "centre", up to three coordinates.
void declare_centre(List& valid, const std::vector<double>& standard);

/// An array of one to three entries, the missing ones 0. Throws InputError for any other number.
std::array<double, 3> place_of(const List& list, const std::string& name);

}  // namespace brisance
