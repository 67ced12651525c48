#include "drivers/checkpoint.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cstdio>
#include <regex>
#include <stdexcept>

#include "drivers/files.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

constexpr const char* subfolder = "checkpoints";
constexpr double never = 1e300;

fs::path name_of(std::int64_t step) {
  char name[40];
  std::snprintf(name, sizeof name, "step_%012lld.h5", static_cast<long long>(step));
  return name;
}

struct Numbered {
  std::int64_t step;
  fs::path file;
};

/// The oldest first. What a run that was killed left half done has another name.
std::vector<Numbered> all_in(const fs::path& folder) {
  static const std::regex form("step_([0-9]{12})\\.h5");
  std::vector<Numbered> all;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) {
    const std::string name = entry.path().filename().string();
    std::smatch parts;
    if (std::regex_match(name, parts, form)) all.push_back({std::stoll(parts[1]), entry.path()});
  }
  std::sort(all.begin(), all.end(),
            [](const Numbered& a, const Numbered& b) { return a.step < b.step; });
  return all;
}

double interval_of(const List* list) {
  const double given = list ? get<double>(*list, "simulated time") : 0;
  return given > 0 ? given : never;
}

}  // namespace

List Checkpoints::valid_parameters() {
  List valid;
  declare(valid, "steps", 0, at_least(0), "steps between checkpoints; 0: not by steps [-]");
  declare(valid, "simulated time", 0.0, at_least_zero(),
          "between checkpoints; 0: not by simulated time [s]");
  declare(valid, "wall time", 600.0, at_least_zero(),
          "of a clock, between checkpoints; 0: not by the clock [s]");
  declare(valid, "keep", 2, at_least(1), "how many of the newest stay on the disk [-]");
  return valid;
}

Checkpoints::Checkpoints(const List& scene, const fs::path& folder)
    : folder_(folder / subfolder),
      listed_(find_list(scene, "checkpoint") != nullptr),
      cadence_(interval_of(find_list(scene, "checkpoint"))) {
  if (!listed_) return;
  const List& list = scene.sublist("checkpoint");
  steps_ = get<int>(list, "steps");
  wall_ = get<double>(list, "wall time");
  number_ = get<int>(list, "keep");
}

bool Checkpoints::due(long step, double time) {
  const bool by_time = cadence_.due(time), by_steps = steps_ > 0 && step % steps_ == 0;
  const bool by_clock =
      wall_ > 0 && std::chrono::duration<double>(Clock::now() - last_).count() >= wall_;
  return by_time || by_steps || by_clock;
}

void Checkpoints::write(const CheckpointHead& head, Archive&& archive) {
  last_ = Clock::now();  // a disk that is full is not tried again in every step
  make_folder(folder_);
  write_checkpoint(folder_ / name_of(head.step), head, std::move(archive));
  remove_all_but(head.step);
}

void Checkpoints::remove_all_but(std::int64_t newest) const {
  const auto all = all_in(folder_);
  std::error_code ignored;
  std::size_t past = 0;
  for (const Numbered& one : all) past += one.step <= newest ? 1 : 0;
  for (const Numbered& one : all)
    if (one.step > newest || past-- > number_) fs::remove(one.file, ignored);
  for (const auto& entry : fs::directory_iterator(folder_))
    if (entry.path().extension() == ".tmp") fs::remove(entry.path(), ignored);
}

bool set_aside_checkpoints(const fs::path& folder) {
  if (all_in(folder / subfolder).empty()) return false;
  const fs::path aside = folder / (std::string(subfolder) + ".before");
  std::error_code error;
  fs::remove_all(aside, error);
  fs::rename(folder / subfolder, aside, error);
  if (error)
    throw std::runtime_error("cannot put aside '" + (folder / subfolder).string() +
                             "': " + error.message());
  return true;
}

fs::path folder_of_run(const fs::path& given) {
  if (fs::is_directory(given)) return given;
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error("cannot restart '" + given.string() + "': " + why);
  };
  if (!fs::exists(given)) refuse("there is no such file or folder");
  const fs::path holder = fs::absolute(given).parent_path();
  if (holder.filename() != subfolder)
    refuse(std::string("a checkpoint must lie in the folder '") + subfolder + "' of its run");
  return holder.parent_path();
}

Found find_checkpoint(const fs::path& given) {
  Found found;
  const bool folder = fs::is_directory(given);
  auto candidates = folder ? all_in(given / subfolder) : std::vector<Numbered>{{0, given}};
  if (candidates.empty())
    throw std::runtime_error(
        "cannot restart '" + given.string() +
        "': it holds no checkpoints; a list 'checkpoint' in the scene asks for "
        "some");
  std::reverse(candidates.begin(), candidates.end());
  for (const Numbered& one : candidates) {
    try {
      found.checkpoint = read_checkpoint(one.file);
    } catch (const std::exception& error) {
      const std::string why =
          "checkpoint '" + one.file.string() + "' cannot be used: it " + error.what();
      if (!folder) throw std::runtime_error(why);
      found.notes.push_back(why);
      continue;
    }
    found.file = one.file;
    const std::int64_t lost = candidates.front().step - one.step;
    if (lost > 0)
      found.notes.push_back("takes up step " + std::to_string(one.step) + " instead: " +
                            std::to_string(lost) + " steps are lost and will be done again");
    return found;
  }
  throw std::runtime_error("cannot restart '" + given.string() + "': no checkpoint is good; " +
                           found.notes.front());
}

}  // namespace brisance
