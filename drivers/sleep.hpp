#pragma once
// Lets gas that no wave has reached yet sleep, where a scene asks for it.
#include "core/parameters.hpp"
#include "core/step.hpp"

namespace brisance {

/// Refuses schemes in which the nodes of gas at rest do not stand still by themselves.
void check_sleep(const List& scheme);

/// Once, after prepare(). Explosives stay awake, and what springs hold.
template <class G>
void put_to_sleep(State<G>& state, const List& scene);

}  // namespace brisance
