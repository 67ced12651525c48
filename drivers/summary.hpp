#pragma once
// How a run ended: for machines as summary.json, for people as the lines at its end.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/checks.hpp"
#include "drivers/ledger.hpp"
#include "drivers/measure.hpp"
#include "drivers/time_spent.hpp"

namespace brisance {

struct Outcome {
  std::string status;  ///< "finished", "interrupted"
  double wall_seconds = 0, cpu_seconds = 0, particle_steps = 0;
  /// Where the scene lets gas sleep.
  struct Asleep {
    double particle_steps = 0;  ///< that were not computed
    double impulse = 0;         ///< see Simulation::Sleeping [N s]
  };
  std::optional<Asleep> asleep;
  std::vector<Measure> measures;
  std::vector<Verdict> verdicts;
  TimeSpent spent;  ///< since the start, or since the restart
  bool resumed = false;

  /// Of all particle-steps. [-]
  double share_asleep() const {
    return asleep->particle_steps / std::max(1.0, asleep->particle_steps + particle_steps);
  }
};

/// The text of summary.json, of a complete scene and the books at the end of its run.
std::string summary_text(const List& scene, const Outcome& outcome, const Ledger& ledger,
                         const Balance& balance);

/// What was modelled, how well the books balance, where the time went, what was reached, where the
/// files are (an empty folder: none) and how to look at them. A line each.
std::vector<std::string> report(const List& scene, const Outcome& outcome, const Ledger& ledger,
                                const Balance& balance, const std::filesystem::path& folder);

}  // namespace brisance
