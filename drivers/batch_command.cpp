#include <cstdio>
#include <filesystem>

#include "drivers/batch.hpp"
#include "drivers/batch_plan.hpp"
#include "drivers/batch_table.hpp"
#include "drivers/commands.hpp"
#include "drivers/files.hpp"
#include "drivers/folder_lock.hpp"
#include "drivers/run.hpp"
#include "drivers/runtime.hpp"
#include "drivers/scripts.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

void tell_needs(const BatchPlan& plan, const Batch& batch) {
  const char* const work[] = {"finished", "to go on", "to run"};
  for (std::size_t k = 0; k < plan.runs.size(); ++k)
    std::printf("%-9s %s\n", work[batch.needs()[k].work], plan.runs[k].name.c_str());
}

/// Everything that a run would refuse at its start is told before the first one starts.
void try_scenes(const BatchPlan& plan, const Batch& batch) {
  const Runtime runtime(1);
  for (std::size_t k = 0; k < plan.runs.size(); ++k)
    if (batch.needs()[k].work == Need::all) try_scene(plan.runs[k]);
}

/// Returns whether all could be drawn.
bool draw(const BatchPlan& plan, const fs::path& folder) {
  bool drawn = true;
  for (const Picture& picture : plan.pictures) {
    std::vector<std::string> words = {(folder / "batch.csv").string(),
                                      (folder / picture.file).string(),
                                      "--title",
                                      picture.title,
                                      "--x",
                                      picture.x.label()};
    for (const auto& quantity : picture.by) words.insert(words.end(), {"--by", quantity.label()});
    for (const auto& quantity : picture.y) words.insert(words.end(), {"--y", quantity.label()});
    drawn = run_script("plot_sweep.py", words) == 0 && drawn;
  }
  return drawn;
}

}  // namespace

int batch_command(const BatchRequest& request) {
  const BatchPlan plan = plan_batch(request.what, request.results);
  const fs::path folder =
      request.folder.empty() ? fs::path("out") / plan.name : fs::path(request.folder);
  if (request.list) {
    tell_needs(plan, Batch(plan, folder, request.jobs));
    return 0;
  }
  const FolderLock lock(folder);
  Batch batch(plan, folder, request.jobs);
  try_scenes(plan, batch);
  std::fprintf(stderr, "%zu runs in '%s': %zu finished before, %zu to go on, %zu to run\n",
               plan.runs.size(), folder.c_str(), batch.count(Need::nothing),
               batch.count(Need::rest), batch.count(Need::all));
  const fs::path csv = folder / "batch.csv";
  const auto save = [&] { write_file(csv, BatchTable(plan, batch.records()).csv()); };
  save();
  batch.run(save);
  std::printf("%s", BatchTable(plan, batch.records()).text().c_str());
  if (stop_requested()) {
    std::printf("stopped; the same command goes on; table in %s\n", csv.c_str());
    return 1;
  }
  std::size_t well = 0;
  for (const Record& record : batch.records()) well += record.well();
  std::printf("%zu of %zu runs finished with all checks passed; table in %s\n", well,
              plan.runs.size(), csv.c_str());
  std::fflush(stdout);
  return draw(plan, folder) && well == plan.runs.size() ? 0 : 1;
}

}  // namespace brisance
