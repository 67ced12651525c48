#include "drivers/commands.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cstdio>
#include <iostream>

#include "drivers/folder_lock.hpp"
#include "drivers/input.hpp"
#include "drivers/run.hpp"
#include "drivers/runtime.hpp"
#include "drivers/scene.hpp"
#include "drivers/sweep.hpp"

namespace brisance {

namespace {

/// The scene as it is given by the file and the command line.
Document read_scene(const SceneRequest& request) {
  Document document = read_input(request.file);
  if (is_sweep(*document.list))
    throw InputError("", "", "", "is a sweep, not a scene: run it by 'brisance batch'", request.file);
  try {
    if (!request.preset.empty())
      apply_override(document, "preset=" + request.preset, valid_scene(*document.list));
    for (const auto& assignment : request.assignments)
      apply_override(document, assignment, valid_scene(*document.list));
    return document;
  } catch (const InputError& error) {
    throw document.locate(error);
  }
}

}  // namespace

List load_scene(const SceneRequest& request) {
  const Document document = read_scene(request);
  try {
    List scene = complete_scene(*document.list);
    scene.setName(std::filesystem::path(request.file).stem().string());
    return scene;
  } catch (const InputError& error) {
    throw document.locate(error);
  }
}

InputError locate(const SceneRequest& request, const InputError& error) {
  return read_scene(request).locate(error);
}

int tell(const RunResult& result, const std::filesystem::path& folder) {
  for (const auto& line : result.report) std::printf("%s\n", line.c_str());
  if (result.resumable) std::printf("to go on: brisance restart '%s'\n", folder.c_str());
  if (result.outcome.status == "finished") return 0;
  return result.resumable ? 75 : 130;
}

int run_command(const SceneRequest& request, const std::string& folder, int threads,
                double wall_limit) {
  const List scene = load_scene(request);
  const Runtime runtime(threads > 0 ? threads : threads_for(scene));
  RunOptions options;
  options.folder = folder.empty() ? "out/" + scene.name() : folder;
  options.wall_limit = wall_limit;
  const FolderLock lock(options.folder);
  try {
    return tell(run(scene, options), options.folder);
  } catch (const InputError& error) {
    throw locate(request, error);
  }
}

}  // namespace brisance
