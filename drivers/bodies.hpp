#pragma once
// Bodies: where matter is at the start, and its particles.
#include <memory>
#include <vector>

#include "core/parameters.hpp"
#include "core/step.hpp"
#include "drivers/exact.hpp"

namespace brisance {

/// Fills the groups, one for each material of the scene in its order, with the particles of the
/// scene's bodies.
template <class G>
void seed(State<G>& state, const List& scene, const ExactSolution* exact);

}  // namespace brisance
