// Going on with a run. What may change is where it ends and what it writes; everything else would
// make it another run.
#include <Teuchos_ParameterList.hpp>
#include <cstdio>
#include <cstdlib>

#include "drivers/checkpoint.hpp"
#include "drivers/commands.hpp"
#include "drivers/folder_lock.hpp"
#include "drivers/input.hpp"
#include "drivers/output_times.hpp"
#include "drivers/run.hpp"
#include "drivers/runtime.hpp"
#include "drivers/scene.hpp"
#include "version.hpp"

namespace brisance {
namespace {

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

bool may_change(const std::string& assignment) {
  for (const char* list : {"output/", "checkpoint/"})
    if (assignment.rfind(list, 0) == 0) return true;
  return false;
}

/// Intervals that follow from the end keep to the first one.
void fix_interval(List& list, const char* name, double standard) {
  if (get<double>(list, name) == 0) list.set(name, standard);
}

/// The scene of a checkpoint with what the request changes in it, which is told in `notes`.
List changed_scene(const Checkpoint& checkpoint, const std::string& file,
                   const RestartRequest& request, std::vector<std::string>& notes) {
  Document document = parse_input(checkpoint.head.input, file);
  List& given = *document.list;
  try {
    List& time = given.sublist("time");
    if (request.until > 0) {
      const double end = get<double>(time, "end");
      if (!(request.until > checkpoint.head.time))
        throw InputError("time", "end", text_of(request.until),
                         "must be after the checkpoint's " + text_of(checkpoint.head.time) + " s",
                         "--until");
      List& output = given.sublist("output");
      if (!OutputTimes::by_steps(output)) fix_interval(output, "interval", end / 10);
      if (find_list(given, "gauges")) fix_interval(given.sublist("gauges"), "interval", end / 1000);
      time.set("end", request.until);
      notes.push_back("ends at " + text_of(request.until) + " s instead of " + text_of(end) + " s");
      if (checkpoint.head.time >= end)
        notes.push_back("its step to " + text_of(end) + " s was cut to end there, as none of one run to " +
                        text_of(request.until) + " s is: numbers differ from those by that");
    }
    for (const auto& assignment : request.assignments) {
      if (!may_change(assignment))
        throw InputError("", "", "'" + assignment + "'",
                         "a restart may change 'output/...', 'checkpoint/...' and, by --until, the "
                         "end; anything else makes it another run",
                         "--set");
      apply_override(document, assignment, valid_scene(given));
      notes.push_back("changed: " + assignment);
    }
    List scene = complete_scene(given);
    scene.setName(checkpoint.head.scene);
    return scene;
  } catch (const InputError& error) {
    throw document.locate(error);
  }
}

}  // namespace

int restart_command(const RestartRequest& request, int threads, double wall_limit) {
  const std::filesystem::path from = request.from;
  RunOptions options;
  options.folder = folder_of_run(from);
  const FolderLock lock(options.folder);
  Found found = find_checkpoint(from);
  const CheckpointHead& head = found.checkpoint.head;
  options.wall_limit = wall_limit;
  options.notes = found.notes;
  const List scene = changed_scene(found.checkpoint, found.file.string(), request, options.notes);
  if (head.program != version::number || head.commit != version::commit)
    options.notes.push_back("the checkpoint was written by brisance " + head.program + " (" +
                            head.commit + "): numbers may differ from those of one run");

  const bool chosen = threads > 0 || std::getenv("OMP_NUM_THREADS");
  const Runtime runtime(chosen ? threads : static_cast<int>(head.threads));
  if (running_threads() != head.threads)
    options.notes.push_back("goes on with " + std::to_string(running_threads()) +
                            " threads after " + std::to_string(head.threads) +
                            ": round-off will differ");
  options.notes.push_back("goes on from step " + std::to_string(head.step) + ", checkpoint '" +
                          found.file.string() + "'");
  options.resume = &found.checkpoint.archive;
  return tell(run(scene, options), options.folder);
}

}  // namespace brisance
