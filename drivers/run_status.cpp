#include "drivers/run_status.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "core/parameters.hpp"
#include "drivers/folder_lock.hpp"
#include "drivers/input.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

/// A log that has not grown for so long belongs to a run that is gone [s].
constexpr double patience = 60;
constexpr std::size_t most_notes = 5;
/// Holds the last line of any history: a line has some 20 numbers for each material.
constexpr std::streamoff tail = 1 << 18;

double seconds_since_change(const fs::path& path) {
  std::error_code problem;
  const auto changed = fs::last_write_time(path, problem);
  if (problem) return HUGE_VAL;
  return std::chrono::duration<double>(fs::file_time_type::clock::now() - changed).count();
}

/// The whole lines of a file, from a place on; none if it cannot be read. A last line that is being
/// written is left out.
std::vector<std::string> lines_of(const fs::path& path, std::streamoff from_end = 0) {
  std::ifstream file(path, std::ios::binary);
  if (from_end > 0 && file.seekg(0, std::ios::end)) {
    const std::streamoff size = file.tellg();
    file.seekg(std::max<std::streamoff>(size - from_end, 0));
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line) && !file.eof();) lines.push_back(line);
  return lines;
}

std::vector<std::string> parts_of(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

/// Progress::show and Progress::finish write these.
void read_log(const fs::path& path, RunStatus& s) {
  static const std::regex progress(
      R"( *([0-9.]+) %  (.+) left  dt (\S+) s  (.+) particle-steps/s  step (\d+)  t (\S+) s)");
  static const std::regex end(
      R"((?:done|stopped at ([0-9.]+) %): t (\S+) s, step (\d+), .+, (.+) particle-steps/s)");
  std::smatch found;
  for (const auto& line : lines_of(path)) {
    if (std::regex_match(line, found, progress)) {
      s.phase = RunStatus::Phase::running;
      s.percent = std::stod(found[1]);
      s.left = found[2];
      s.dt = std::stod(found[3]);
      s.rate = found[4];
      s.step = std::stoll(found[5]);
      s.time = std::stod(found[6]);
      s.ending.clear();
    } else if (std::regex_match(line, found, end)) {
      s.phase = RunStatus::Phase::ended;
      s.percent = found[1].matched ? std::stod(found[1]) : 100;
      s.time = std::stod(found[2]);
      s.step = std::stoll(found[3]);
      s.rate = found[4];
      s.ending = line;
    } else if (!line.empty()) {
      s.notes.push_back(line);
    }
  }
  if (s.notes.size() > most_notes) s.notes.erase(s.notes.begin(), s.notes.end() - most_notes);
}

/// The simulated time at which the run is to end; 0 where its input is no longer what it was. [s]
double end_of(const fs::path& input) {
  try {
    return get<double>(read_input(input.string()).list->sublist("time"), "end");
  } catch (const std::exception&) {
    return 0;
  }
}

/// Later than the log, where outputs are more frequent than its lines.
void read_history(const fs::path& path, RunStatus& s) {
  std::string head;
  std::getline(std::ifstream(path), head);
  const auto lines = lines_of(path, tail);
  if (lines.size() < 2) return;
  const auto names = parts_of(head), values = parts_of(lines.back());
  if (values.size() != names.size()) return;
  const auto number = [&](const char* name) -> std::optional<double> {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) return {};
    return std::strtod(values[static_cast<std::size_t>(at - names.begin())].c_str(), nullptr);
  };
  const auto step = number("step"), time = number("time"), dt = number("dt"),
             error = number("energy_error");
  if (time && error) s.energy = {*time, *error};
  if (!step || !time || !dt || *step < static_cast<double>(s.step)) return;
  s.step = static_cast<std::int64_t>(*step);
  s.time = *time;
  s.dt = *dt;
}

void read_summary(const fs::path& path, RunStatus& s) {
  std::ifstream file(path);
  const auto j = nlohmann::json::parse(file, nullptr, false);
  if (!j.is_object()) return;
  s.status = j.value("status", "");
  for (const auto& check : j.value("checks", nlohmann::json::array()))
    ++(check.value("verdict", "") == "reached" ? s.reached : s.missed);
}

std::optional<RunStatus::Kept> newest_checkpoint(const fs::path& folder) {
  std::error_code problem;
  fs::path newest;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (entry.path().extension() == ".h5" && entry.path().filename() > newest.filename())
      newest = entry.path();
  if (newest.empty()) return {};
  return RunStatus::Kept{newest.filename().string(), seconds_since_change(newest)};
}

long outputs_in(const fs::path& folder) {
  const auto count = [&](const char* series) {
    const auto lines = lines_of(folder / series);
    return std::count_if(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("<DataSet ") != line.npos;
    });
  };
  return std::max(count("particles.pvd"), count("grid.pvd"));
}

}  // namespace

RunStatus read_run_status(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw InputError("", "", "", "is not a folder", folder.string());
  if (!fs::exists(folder / "input.xml"))
    throw InputError("", "", "", "holds no run: it has no input.xml", folder.string());
  RunStatus s;
  // Before the files: a run that ends in between is seen to go on, and its end the next time.
  const auto in_use = is_in_use(folder);
  read_log(folder / "log.txt", s);
  read_history(folder / "history.csv", s);
  if (const double end = end_of(folder / "input.xml"); end > 0)
    s.percent = std::min(100 * s.time / end, 100.0);
  s.age = seconds_since_change(folder / "log.txt");
  s.checkpoint = newest_checkpoint(folder / "checkpoints");
  s.outputs = outputs_in(folder);
  const bool said_its_end = s.phase == RunStatus::Phase::ended;
  if (in_use.value_or(!said_its_end && s.age < patience)) {
    if (said_its_end) s.phase = RunStatus::Phase::running;  // it writes its last output
  } else if (said_its_end) {
    read_summary(folder / "summary.json", s);
  } else {
    s.phase = RunStatus::Phase::cut_off;
  }
  return s;
}

}  // namespace brisance
