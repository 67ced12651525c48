#pragma once
// Runs what a plan holds, several at once, each in a process of its own.
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <vector>

#include "drivers/batch_record.hpp"
#include "drivers/sweep.hpp"

namespace brisance {

/// In its folder: scenes/NAME.xml, the complete input; runs/NAME/, the folder of the run, with all
/// that it has said in output.log.
class Batch {
 public:
  /// `jobs`: runs at once; 0: one for each core, as long as there are so many.
  Batch(const BatchPlan& plan, std::filesystem::path folder, int jobs);

  const std::vector<Need>& needs() const { return needs_; }
  std::size_t count(Need::Work work) const;

  /// Does what is needed, goes on after a failure, and tells on stderr what starts and ends. After
  /// request_stop() nothing new starts, and what runs is asked to stop. `changed` is called when a
  /// run has ended.
  void run(const std::function<void()>& changed);

  /// One for each run of the plan, up to date while it runs.
  const std::vector<Record>& records() const { return records_; }

  std::filesystem::path folder_of(std::size_t run) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Running {
    std::size_t run;
    pid_t process;
    Clock::time_point start;
  };

  void start(std::size_t run);
  void finish(const Running& running, int status);
  double seconds_left() const;

  const BatchPlan& plan_;
  std::filesystem::path folder_;
  std::vector<Need> needs_;
  std::vector<Record> records_;
  std::size_t jobs_;
  std::vector<Running> running_;
  std::vector<std::size_t> waiting_;
  std::size_t done_ = 0;
  double spent_ = 0, ended_ = 0;  ///< wall seconds of the runs that have ended, and their number
};

}  // namespace brisance
