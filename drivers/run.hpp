#pragma once
// The loop of a run: steps, output, books, and the measures at its end.
#include <filesystem>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/archive.hpp"
#include "drivers/output_choice.hpp"
#include "drivers/simulation.hpp"
#include "drivers/summary.hpp"

namespace brisance {

struct RunOptions {
  std::filesystem::path folder;  ///< where results go; empty: nowhere
  bool quiet = false;            ///< no progress on the screen
  double wall_limit = 0;         ///< stops as a signal does after so long; 0: never [s]
  Archive* resume = nullptr;     ///< what a checkpoint of the same scene holds, to go on from
  std::vector<std::string> notes = {};  ///< lines for people, at the start
};

struct RunResult {
  Outcome outcome;
  Balance end;
  double cell_size = 0;     // [m]
  std::vector<std::string> report;  ///< lines for people, see summary.hpp
  bool resumable = false;  ///< interrupted, and a checkpoint tells where to go on
};

/// Runs a checked scene to its end, or until a signal (SIGINT, SIGTERM) or the clock asks to stop:
/// then the output so far is complete, a checkpoint is in the folder, if there is one, and the
/// status is "interrupted".
RunResult run(const List& scene, const RunOptions& options);

/// What the run of a scene will write, from the first step on that its simulation is about to take.
OutputSize output_size(const List& scene, const Simulation& simulation);

/// Asks running loops to stop after the step they are in; safe in a signal handler.
void request_stop();
bool stop_requested();

}  // namespace brisance
