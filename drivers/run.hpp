#pragma once
// The loop of a run: steps, output, books, and the measures at its end.
#include <filesystem>

#include "core/parameters.hpp"
#include "drivers/results.hpp"

namespace brisance {

struct RunOptions {
  std::filesystem::path folder;  ///< where results go; empty: nowhere
  bool quiet = false;            ///< no progress on the screen
};

struct RunResult {
  Outcome outcome;
  Balance end;
  double cell_size = 0;  // [m]
};

/// Runs a checked scene to its end, or until a signal (SIGINT, SIGTERM) asks to stop: then the
/// output so far is complete and the status "interrupted".
RunResult run(const List& scene, const RunOptions& options);

/// Asks running loops to stop after the step they are in; safe in a signal handler.
void request_stop();

}  // namespace brisance
