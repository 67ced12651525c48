#pragma once
// What a run leaves behind while it goes on: it lets observers look, writes outputs and lines of
// the history when they are due, and keeps account of the time that this takes. Particles and grids
// are written at once. Tables, and lists of what there is, grow and are written anew each time:
// that is done twice a second at most, before a checkpoint and at the end, be it by an error.
#include <chrono>
#include <optional>

#include "drivers/observers.hpp"
#include "drivers/output_times.hpp"
#include "drivers/results.hpp"
#include "drivers/time_spent.hpp"

namespace brisance {

class Recording {
 public:
  /// All of it is the run's and outlives the recording; `exact` may be null.
  Recording(const List& scene, Simulation& simulation, const Ledger& ledger, ExactSolution* exact,
            TimeKeeper& keeper);
  ~Recording();
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// From here on files are written, into this folder; without one observers still look.
  void open(const std::filesystem::path& folder, const List& scene);

  /// To be called at the start and after each step.
  void follow();
  /// The output at the start, which costs nothing where nobody looks.
  void output_if_seen();
  /// To be called after each step but the last.
  void output_if_due();
  /// The output at the end; returns what was written or is to be measured, until secure().
  const Snapshot& last_output();

  /// To be called after the last output, with that.
  std::vector<Measure> measures(const Snapshot& end) const { return observers_.measures(end); }
  /// The exact solution at the end, for plots.
  void write_exact(const Snapshot& end);

  void keep(Archive& archive);

  /// Forces to the disk what has been written so far. A checkpoint must not be there before that:
  /// who takes it up does not write the outputs of the time before it again. The last output's copy
  /// of the particles is given up for the memory that a checkpoint needs.
  void secure();

 private:
  Simulation& simulation_;
  const Ledger& ledger_;
  const ExactSolution* exact_;
  TimeKeeper& keeper_;
  Observers observers_;
  OutputTimes times_;
  Backlog backlog_;
  std::optional<Results> results_;
  Snapshot shot_;  ///< of the last output; its memory is used again
  using Clock = std::chrono::steady_clock;
  bool owed_ = false;        ///< whether tables lag behind what there is
  Clock::time_point wrote_;  ///< tables, when last

  void write_tables();
  void write_tables_if_due();
  /// The particles are copied where somebody looks at them.
  const Snapshot& output(bool look);
  bool shown() const;
};

}  // namespace brisance
