#include <algorithm>
#include <cstdio>

#include "drivers/batch.hpp"
#include "drivers/commands.hpp"
#include "drivers/files.hpp"
#include "drivers/folder_lock.hpp"
#include "drivers/locations.hpp"
#include "drivers/run.hpp"
#include "drivers/scripts.hpp"
#include "drivers/tradeoff_choice.hpp"
#include "version.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

struct Stopped {};

/// Does the runs of a plan that are not finished, and returns how all have ended.
std::vector<Record> records_of(const BatchPlan& plan, const fs::path& folder, int jobs) {
  Batch batch(plan, folder, jobs);
  std::fprintf(stderr, "%zu runs in '%s', %zu finished before\n", plan.runs.size(), folder.c_str(),
               batch.count(Need::nothing));
  batch.run([] {});
  if (stop_requested()) throw Stopped();
  return batch.records();
}

TradeoffPoints measure(const TradeoffScene& scene, const fs::path& folder, bool quick, int jobs) {
  auto settings = scene.settings(quick);
  Setting reference;
  const bool compared = scene.reference(reference);
  if (compared) {
    settings.erase(std::remove(settings.begin(), settings.end(), reference), settings.end());
    settings.push_back(reference);
  }
  BatchPlan plan;
  for (const auto& setting : settings) plan.runs.push_back(scene.planned(setting));
  const auto records = records_of(plan, folder, jobs);
  TradeoffPoints points;
  for (std::size_t k = 0; k < settings.size() - compared; ++k)
    points.push_back({scene.name(), scene.family(), settings[k],
                      settings[k] == scene.preset_alone(settings[k].preset, settings[k].resolution),
                      records[k].status,
                      scene.error(records[k], compared ? &records.back() : nullptr),
                      records[k].cpu_seconds, 0, version::commit});
  return points;
}

/// Older points of a scene stay if this program has measured them, too.
void renew(TradeoffPoints& all, const TradeoffPoints& measured) {
  const auto old = [&](const TradeoffPoint& p) {
    const auto same = [&](const TradeoffPoint& m) { return m.setting == p.setting; };
    return p.scene == measured.front().scene &&
           (p.commit != version::commit || std::any_of(measured.begin(), measured.end(), same));
  };
  all.erase(std::remove_if(all.begin(), all.end(), old), all.end());
  all.insert(all.end(), measured.begin(), measured.end());
  compare_with_front(all);
}

/// Measured when the program was made, which it comes with.
TradeoffPoints shipped_points() {
  const fs::path csv = data_folder() / "inputs/tradeoff.csv";
  return fs::exists(csv) ? read_points(csv) : TradeoffPoints();
}

TradeoffPoints of_scene(const TradeoffPoints& points, const std::string& scene) {
  TradeoffPoints some;
  for (const auto& point : points)
    if (point.scene == scene) some.push_back(point);
  return some;
}

/// Prints it; whether it does what was asked for.
bool tell_choice(const TradeoffScene& scene, const std::optional<Choice>& choice,
                 const std::string& source) {
  if (!choice) {
    std::printf("%s: no setting has a result\n", scene.name().c_str());
    return false;
  }
  if (!choice->fulfils)
    std::printf("%s: no setting that was measured is good for that; the nearest:\n",
                scene.name().c_str());
  std::printf("%s\n  expected: error ", scene.command(choice->setting).c_str());
  if (choice->least_error < choice->error) std::printf("%.3g to ", 100 * choice->least_error);
  std::printf("%.3g %%, %.3g s of one core, by %s\n", 100 * choice->error, choice->cost,
              source.c_str());
  return choice->fulfils;
}

/// What was measured elsewhere, in other scenes or on another machine, and the cost of one cheap
/// run here.
bool choose_by_fit(const TradeoffScene& scene, const FamilyFit& fit, const Wish& wish,
                   const fs::path& folder) {
  BatchPlan plan;
  plan.runs.push_back(scene.planned(*fit.probe()));
  const Record record = records_of(plan, folder, 1).front();
  if (record.status != "finished")
    throw std::runtime_error("the cheapest setting does not run in '" + scene.file() +
                             "': " + record.remark);
  std::string source = "a cheap run here and the table of ";
  for (const auto& name : fit.scenes()) source += (&name == &fit.scenes()[0] ? "" : ", ") + name;
  return tell_choice(scene, fit.choose(record.cpu_seconds, wish), source);
}

/// From what was measured in the folder, else in the table of the program.
bool choose_for(const TradeoffScene& scene, const TradeoffPoints& here, const Wish& wish,
                const fs::path& folder) {
  const auto own = of_scene(here, scene.name());
  if (!own.empty()) return tell_choice(scene, choose(own, wish), "the table in " + folder.string());
  const FamilyFit near(here, scene.family(), scene);
  if (near.probe()) return choose_by_fit(scene, near, wish, folder);
  const TradeoffPoints shipped = shipped_points(), same = of_scene(shipped, scene.name());
  const FamilyFit far(same.empty() ? shipped : same, scene.family(), scene);
  if (far.probe()) return choose_by_fit(scene, far, wish, folder);
  throw InputError(
      "", "", "",
      "has no list 'tradeoff', and no scene like it (" + scene.family() + ") has been measured",
      scene.file());
}

std::vector<std::string> with_list_in(const fs::path& inputs) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(inputs))
    if (entry.path().extension() == ".xml" && TradeoffScene(entry.path().string()).measured())
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

int carry_out(const TradeoffRequest& request, const Wish& wish) {
  const bool asks = wish.error || wish.budget;
  std::vector<TradeoffScene> scenes;
  for (const auto& file : request.all ? with_list_in(data_folder() / "inputs") : request.scenes) {
    scenes.emplace_back(file);
    if (!asks && !scenes.back().measured())
      throw InputError("", "", "", "has no list 'tradeoff' that says what its error is", file);
  }
  if (scenes.empty()) throw InputError("", "", "", "needs a scene, or --all", "tradeoff");
  const fs::path folder = request.folder.empty() ? "out/tradeoff" : request.folder;
  const fs::path csv = folder / "tradeoff.csv";
  const FolderLock lock(folder);
  TradeoffPoints points;
  if (fs::exists(csv)) points = read_points(csv);
  bool drawn = true, well = true, more = false;
  for (const auto& scene : scenes) {
    const bool known = !of_scene(points, scene.name()).empty() ||
                       !of_scene(shipped_points(), scene.name()).empty();
    if (!scene.measured() || (asks && known)) continue;
    renew(points, measure(scene, folder, request.quick, request.jobs));
    write_points(csv, points);
    std::printf("%s", front_table(points, scene.name()).c_str());
    std::fflush(stdout);
    more = true;
  }
  if (more) {
    std::printf("table in %s\n", csv.c_str());
    std::fflush(stdout);
    drawn = run_script("plot_tradeoff.py", {csv.string(), (folder / "tradeoff.png").string()}) == 0;
  }
  if (asks)
    for (const auto& scene : scenes) well = choose_for(scene, points, wish, folder) && well;
  return drawn && well ? 0 : 1;
}

}  // namespace

int tradeoff_command(const TradeoffRequest& request) {
  Wish wish;
  if (!request.target_error.empty()) wish.error = error_from(request.target_error);
  if (!request.budget.empty()) wish.budget = budget_from(request.budget);
  try {
    return carry_out(request, wish);
  } catch (const Stopped&) {
    std::printf("stopped; the same command goes on\n");
    return 130;
  }
}

}  // namespace brisance
