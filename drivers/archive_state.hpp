#pragma once
// The state of the method itself in an archive.
#include "core/step.hpp"
#include "drivers/archive.hpp"

namespace brisance {

void keep(Archive& archive, const std::string& name, Totals& totals);

/// Particles in their order, books, time, and what bins and springs remember. A state that is read
/// is that of the same scene, prepared; fields of the grid live no longer than a step.
template <class G>
void keep(Archive& archive, State<G>& state);

}  // namespace brisance
