#pragma once
// The checkpoints of a run: when one is due, which are kept, and which one a restart takes up. They
// stand as DIR/checkpoints/step_000000001234.h5; what each holds is told in checkpoint_file.hpp.
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/cadence.hpp"
#include "drivers/checkpoint_file.hpp"

namespace brisance {

class Checkpoints {
 public:
  /// The schema of the scene's list "checkpoint".
  static List valid_parameters();

  /// Of a complete scene that writes into a folder. Without the list nothing is due on the way.
  Checkpoints(const List& scene, const std::filesystem::path& folder);

  /// To be asked after each step, and at its end.
  bool due(long step, double time);
  bool due_at_end() const { return listed_; }

  /// Writes one and deletes the oldest beyond those to be kept, and those of later steps, which
  /// another future has left. Throws std::runtime_error with one line; then all others are still
  /// there.
  void write(const CheckpointHead& head, Archive&& archive);

  void keep(Archive& archive) { cadence_.keep(archive, "checkpoint"); }

 private:
  using Clock = std::chrono::steady_clock;
  std::filesystem::path folder_;
  bool listed_;
  long steps_ = 0;
  double wall_ = 0;  // [s]
  std::size_t number_ = 2;
  Cadence cadence_;
  Clock::time_point last_ = Clock::now();

  /// Leaves the newest up to that step, and nothing that is half done.
  void remove_all_but(std::int64_t newest) const;
};

/// Puts the checkpoints of an earlier run aside, in place of those that were put aside before, so
/// that no restart mixes the two. Returns whether there were any.
bool set_aside_checkpoints(const std::filesystem::path& folder);

/// The folder of the run that is named by it or by one of its checkpoints. Throws
/// std::runtime_error for what is neither.
std::filesystem::path folder_of_run(const std::filesystem::path& folder_or_file);

/// The newest good checkpoint of a run, or the file that is named, and what there is to tell about
/// those passed over. Throws std::runtime_error if there is none.
struct Found {
  Checkpoint checkpoint;
  std::filesystem::path file;
  std::vector<std::string> notes;
};
Found find_checkpoint(const std::filesystem::path& folder_or_file);

}  // namespace brisance
