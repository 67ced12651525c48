#include "drivers/batch_record.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "drivers/checkpoint.hpp"
#include "drivers/files.hpp"
#include "version.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Without the comment in its first line, which differs from writer to writer.
std::string content(const std::string& input) { return input.substr(input.find('\n') + 1); }

bool is_finished(const fs::path& folder, const std::string& input) {
  try {
    if (content(read_file(folder / "input.xml")) != content(input)) return false;
    const json summary = json::parse(read_file(folder / "summary.json"));
    return summary.at("status") == "finished" && summary.at("version") == version::number &&
           summary.at("commit") == version::commit;
  } catch (const std::exception&) {  // not there, or not whole
    return false;
  }
}

}  // namespace

Record read_record(const fs::path& folder) {
  Record record;
  try {
    const json summary = json::parse(read_file(folder / "summary.json"));
    record.status = summary.at("status");
    record.wall_seconds = summary.at("wall_seconds");
    record.cpu_seconds = summary.at("cpu_seconds");
    if (record.status != "finished") return record;
    for (const auto& check : summary.at("checks"))
      ++(check.at("verdict") == "reached" ? record.passed : record.failed);
    for (const auto& [name, measure] : summary.at("measures").items())
      if (!measure.at("value").is_null()) record.measures[name] = measure.at("value");
  } catch (const std::exception& error) {
    record.status = "failed";
    record.remark = error.what();
  }
  return record;
}

Need need_of(const fs::path& folder, const std::string& input) {
  if (is_finished(folder, input)) return {Need::nothing};
  if (!fs::is_directory(folder / "checkpoints")) return {Need::all};
  try {
    const CheckpointHead head = find_checkpoint(folder).checkpoint.head;
    if (head.program == version::number && head.commit == version::commit &&
        content(head.input) == content(input))
      return {Need::rest, static_cast<int>(head.threads)};
  } catch (const std::runtime_error&) {  // none, or none that is good
  }
  return {Need::all};
}

}  // namespace brisance
