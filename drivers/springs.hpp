#pragma once
// The scene's optional list "springs": what holds a material to the ground.
#include "core/parameters.hpp"
#include "core/step.hpp"

namespace brisance {

/// The schema of one spring, in a scene of these materials.
List valid_spring(const std::vector<std::string>& materials, int dim);

/// Refuses springs where the scheme has no place for them.
void check_springs(const List& scene);

/// The springs of a checked scene, whose groups stand in the order of its materials.
template <class G>
void add_springs(State<G>& state, const List& scene);

}  // namespace brisance
