#pragma once
// Scenes whose values are each allowed and together cannot be meant.
#include "core/parameters.hpp"

namespace brisance {

/// Throws InputError for such a scene, as far as its lists alone show it.
void check_plausible(const List& scene);

}  // namespace brisance
