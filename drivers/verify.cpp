#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "drivers/commands.hpp"
#include "drivers/folder_lock.hpp"
#include "drivers/locations.hpp"
#include "drivers/run.hpp"
#include "drivers/runtime.hpp"

namespace brisance {
namespace {

class VerdictTable {
 public:
  VerdictTable() {
    std::printf("%-22s %-34s %12s  %-20s %s\n", "scene", "quantity", "measured", "limit",
                "verdict");
  }

  void add(const std::string& scene, const Verdict& v) {
    char measured[48];
    std::snprintf(measured, sizeof measured, "%.4g %s", v.measured,
                  v.unit == "-" ? "" : v.unit.c_str());
    std::printf("%-22s %-34s %12s  %-20s %s\n", scene.c_str(), v.quantity.c_str(), measured,
                v.limit().c_str(), v.reached() ? "reached" : "MISSED");
    std::fflush(stdout);
    ++(v.reached() ? reached_ : missed_);
  }
  void fail(const std::string& scene, const std::string& why) {
    std::printf("%-22s %s\n", scene.c_str(), why.c_str());
    ++missed_;
  }
  int close() const {
    std::printf("%d reached, %d missed\n", reached_, missed_);
    return missed_ == 0 && reached_ > 0 ? 0 : 1;
  }

 private:
  int reached_ = 0, missed_ = 0;
};

double value_of(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m.value;
  return std::nan("");
}

/// The same domain with so many cells along x, and as much finer or coarser along the others.
List with_cells(const List& scene, int along_x) {
  List finer(scene);
  List& grid = finer.sublist("grid");
  auto cells = get<std::vector<int>>(grid, "cells");
  const double factor = static_cast<double>(along_x) / cells[0];
  for (int& n : cells) n = n == 1 ? 1 : static_cast<int>(std::lround(n * factor));
  grid.set("cells", Teuchos::Array<int>(cells));
  grid.set("cell size", get<double>(grid, "cell size") / factor);
  return finer;
}

void verify_convergence(const List& scene, const List& convergence, VerdictTable& table) {
  std::vector<double> sizes;
  std::vector<std::vector<Measure>> all;
  for (const int cells : get<std::vector<int>>(convergence, "cells")) {
    RunOptions quiet;
    quiet.quiet = true;
    const RunResult result = run(with_cells(scene, cells), quiet);
    if (result.outcome.status != "finished") return;
    sizes.push_back(result.cell_size);
    all.push_back(result.outcome.measures);
    for (Verdict& v : judge(find_list(convergence, "every"), result.outcome.measures)) {
      v.quantity += ", " + std::to_string(cells) + " cells";
      table.add(scene.name(), v);
    }
  }
  const List* orders = find_list(convergence, "order");
  if (!orders) return;
  for (const auto& name : list_names(*orders)) {
    std::vector<double> errors;
    for (const auto& measures : all) errors.push_back(std::fabs(value_of(measures, name)));
    table.add(scene.name(),
              judge_one(orders->sublist(name), "order of " + name, order(sizes, errors), "-"));
  }
}

}  // namespace

int verify_command(const std::vector<std::string>& files, const std::string& folder, int threads) {
  const Runtime runtime(threads);
  std::vector<std::string> scenes = files;
  if (scenes.empty())
    for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "inputs"))
      if (entry.path().extension() == ".xml") scenes.push_back(entry.path().string());
  std::sort(scenes.begin(), scenes.end());
  VerdictTable table;
  for (const auto& file : scenes) {
    const List scene = load_scene({file, {}, {}});
    RunOptions options;
    options.quiet = folder.empty();
    if (!folder.empty()) options.folder = std::filesystem::path(folder) / scene.name();
    try {
      std::optional<FolderLock> lock;
      if (!options.folder.empty()) lock.emplace(options.folder);
      const RunResult result = run(scene, options);
      if (result.outcome.status != "finished") return 130;
      for (const Verdict& v : result.outcome.verdicts) table.add(scene.name(), v);
      if (const List* convergence = find_list(scene, "convergence"))
        verify_convergence(scene, *convergence, table);
    } catch (const InputError& error) {
      throw locate({file, {}, {}}, error);
    } catch (const std::exception& error) {
      table.fail(scene.name(), error.what());
    }
  }
  return table.close();
}

}  // namespace brisance
