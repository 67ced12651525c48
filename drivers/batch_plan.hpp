#pragma once
// From the words of the command line to the runs of a batch, all of them valid.
#include <string>
#include <vector>

#include "drivers/sweep.hpp"

namespace brisance {

/// Scenes, sweeps, and folders that hold some (*.xml, not deeper). `results`: further measures for
/// the table. The plan is named after the only word; runs of a sweep beside others stand below its
/// name, "sweep_charge/charge_radius_0.05". Throws InputError.
BatchPlan plan_batch(const std::vector<std::string>& words,
                     const std::vector<std::string>& results);

/// Sets up the scene of a run as the run itself would; throws the same InputError. Needs a Runtime.
void try_scene(const PlannedRun& run);

}  // namespace brisance
