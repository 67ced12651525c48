#pragma once
// What the files in the folder of a run tell about it, while it goes on and afterwards.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace brisance {

struct RunStatus {
  enum class Phase { starting, running, ended, cut_off };

  /// A checkpoint, and how long it has been on the disk [s].
  struct Kept {
    std::string file;  ///< its name
    double age = 0;
  };
  /// A line of history.csv: the error of the total energy [-] and the time it belongs to [s].
  struct Energy {
    double time = 0, error = 0;
  };

  Phase phase = Phase::starting;
  double percent = 0;       ///< of the simulated time
  std::string left, rate;   ///< time left; particle-steps per second: as the log has them
  double time = 0, dt = 0;  ///< [s]
  std::int64_t step = 0;
  double age = 0;               ///< since the last line of the log [s]
  std::string ending;           ///< the last line of a run that ended: how far, how long, how fast
  std::string status;           ///< as summary.json has it: "finished", "interrupted"
  int reached = 0, missed = 0;  ///< limits of the scene, at its end
  std::vector<std::string> notes;  ///< lines of the log that are no progress, the last few
  std::optional<Energy> energy;
  std::optional<Kept> checkpoint;  ///< the newest
  long outputs = 0;
};

/// Reads log.txt, history.csv, summary.json, the series and checkpoints/. What is not there yet is
/// left as it is. A run is taken to go on while it holds the lock of its folder; on file systems
/// without locks, while its log grows. Throws InputError for a folder that holds no run.
RunStatus read_run_status(const std::filesystem::path& folder);

/// Several lines that tell all of it, none wider than `width`.
std::string block_of(const RunStatus& status, const std::filesystem::path& folder,
                     std::size_t width);
/// The same in one line, of what changes.
std::string line_of(const RunStatus& status);

}  // namespace brisance
