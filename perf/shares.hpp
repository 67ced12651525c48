#pragma once
#include <map>
#include <string>

#include "drivers/simulation.hpp"

namespace brisance::perf {

/// What solids are doing, as shares of all points [-]: those whose plastic strain grows in the step
/// that this takes, those with damage, those with a plane that comes apart. A share that no
/// material knows is not there.
std::map<std::string, double> shares_of(Simulation& simulation);

}  // namespace brisance::perf
