#pragma once
// The folder of a run: what people open afterwards.
#include <filesystem>
#include <string>

#include "core/parameters.hpp"
#include "drivers/exact.hpp"
#include "drivers/files.hpp"
#include "drivers/ledger.hpp"
#include "drivers/output_choice.hpp"
#include "drivers/simulation.hpp"
#include "drivers/vtk.hpp"

namespace brisance {

/// Writes into one folder; all failures throw std::runtime_error with one line.
class Results {
 public:
  /// Makes the folder and writes the completed scene into it. What follows goes into the backlog,
  /// which outlives this.
  Results(const std::filesystem::path& folder, const List& scene, const Ledger& ledger,
          Backlog& backlog);

  /// Whether particles or the grid, which is their means, are to be written.
  bool takes_particles() const { return choice_.particles() || choice_.grid(); }
  /// Particles and grid at one time.
  void add(const Snapshot& shot);
  /// A line of history.csv.
  void note(const Ledger& ledger, const Balance& balance) { history_ += ledger.line(balance); }
  /// What grows and is written anew each time: history.csv, and which files there are at which
  /// times.
  void write_tables() const;
  /// The exact solution along the scene at its end, for plots.
  void write_exact(const ExactSolution& exact, const Snapshot& shot);

  /// What has been written so far, for restart: histories and series go on from there, and what is
  /// numbered beyond is deleted.
  void keep(Archive& archive);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  Backlog& backlog_;
  OutputChoice choice_;
  vtk::Series particle_series_, grid_series_;
  std::string history_;

  void add_particles(const Snapshot& shot);
  void add_grid(const Snapshot& shot);
};

}  // namespace brisance
