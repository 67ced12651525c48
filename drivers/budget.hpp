#pragma once
// What a scene may ask of the machine.
#include "core/parameters.hpp"

namespace brisance {

/// Memory that is free to use; infinite where that is not known. [B]
double available_memory();

/// Throws InputError if the grid of a checked scene needs more memory than there is. Counted is
/// what every scheme has, so that nothing is refused that would fit.
void check_grid_memory(const List& scene, double available);

/// The same for its particles.
void check_particle_memory(const List& scene, double particles, double available);

/// Throws InputError if a scene takes steps without end, or its state at the start is not finite
/// or faster than light.
/// `dt`: the first step [s]; `fastest`: signal [m/s]; `mass` and `energy`: of all matter [kg], [J].
void check_start(const List& scene, double dt, double fastest, double mass, double energy);

}  // namespace brisance
