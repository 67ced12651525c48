#pragma once
// The explosives of a scene and what lights them.
#include "core/step.hpp"
#include "drivers/lighting.hpp"

namespace brisance {

/// Sets the state variable "lighting time" of all particles whose material has one and a parameter
/// "detonation speed", by the list "ignition" of a checked scene. Throws InputError for an
/// explosive that nothing lights.
template <class G>
void set_lighting_times(State<G>& state, const List& scene);

}  // namespace brisance
