#pragma once
// The folder of a run: what people open afterwards.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/checks.hpp"
#include "drivers/exact.hpp"
#include "drivers/ledger.hpp"
#include "drivers/simulation.hpp"
#include "drivers/vtk.hpp"

namespace brisance {

/// How a run ended, for summary.json.
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

  /// Of all particle-steps. [-]
  double share_asleep() const {
    return asleep->particle_steps / std::max(1.0, asleep->particle_steps + particle_steps);
  }
};

/// Writes into one folder; all failures throw std::runtime_error with one line.
class Results {
 public:
  /// Makes the folder and writes the completed scene into it.
  Results(const std::filesystem::path& folder, const List& scene, const Ledger& ledger);

  /// Particles and grid at one time.
  void add(const Snapshot& shot);
  /// A line of history.csv, on the disk at once; or kept until the next that is.
  void add(const Ledger& ledger, const Balance& balance);
  void note(const Ledger& ledger, const Balance& balance) { history_ += ledger.line(balance); }
  /// The exact solution along the scene at its end, for plots.
  void write_exact(const ExactSolution& exact, const Snapshot& shot);
  void write_summary(const Outcome& outcome, const Ledger& ledger, const Balance& balance);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::string scene_, title_, geometry_;
  double cell_size_;
  bool particles_, grid_;
  vtk::Series particle_series_, grid_series_;
  std::string history_;

  std::string numbered(const std::string& name) const;
};

}  // namespace brisance
