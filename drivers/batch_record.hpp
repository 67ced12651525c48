#pragma once
// What stands in the folder of a run, seen from a batch.
#include <filesystem>
#include <map>
#include <string>

namespace brisance {

/// How a run of a batch has ended.
struct Record {
  std::string status = "not run";  ///< or "finished", "interrupted", "failed"
  int passed = 0, failed = 0;      ///< checks
  double wall_seconds = 0, cpu_seconds = 0;
  std::map<std::string, double> measures;  ///< of a finished run, those with a value
  std::string remark;                      ///< why it failed

  bool well() const { return status == "finished" && failed == 0; }
};

/// What summary.json says. Without one that can be read, "failed".
Record read_record(const std::filesystem::path& folder);

/// What is still to be done for a run of that input (XML of the complete scene) by this version of
/// the program.
struct Need {
  enum Work { nothing, rest, all } work = all;
  int threads = 1;  ///< of the checkpoint from which the rest can be computed
};
Need need_of(const std::filesystem::path& folder, const std::string& input);

}  // namespace brisance
