#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "drivers/commands.hpp"
#include "drivers/describe.hpp"
#include "drivers/input.hpp"
#include "drivers/kernels.hpp"
#include "drivers/presets.hpp"
#include "drivers/run.hpp"
#include "drivers/runtime.hpp"
#include "drivers/scene.hpp"
#include "drivers/simulation.hpp"
#include "drivers/sweep.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

/// A scene in which everything that the schema can hold is there.
List example_scene() {
  List scene;
  scene.set("geometry", "plane strain");
  scene.sublist("materials").sublist("NAME").set("law", law_names().front());
  scene.sublist("bodies").sublist("NAME").set("material", "NAME");
  scene.sublist("gauges").sublist("NAME");
  scene.sublist("springs").sublist("NAME").set("material", "NAME");
  scene.sublist("exact").set("solution", "uniform").set("gamma", 1.4);
  return scene;
}

/// A list of that name anywhere in the schema, or null.
const List* find_anywhere(const List& list, const std::string& name) {
  if (const List* found = find_list(list, name)) return found;
  for (const auto& below : list_names(list))
    if (const List* found = find_anywhere(list.sublist(below), name)) return found;
  return nullptr;
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The part of all schemas that a word of the command line means.
List schema_of(const std::string& name) {
  if (std::filesystem::is_regular_file(name)) {
    const Document document = read_input(name);
    return is_sweep(*document.list) ? valid_sweep(*document.list) : valid_scene(*document.list);
  }
  if (name == "sweep") {
    List sweep;
    sweep.sublist("vary").sublist("NAME");
    return valid_sweep(sweep);
  }
  const List everything = valid_scene(example_scene());
  if (name.empty()) return everything;
  List given;
  if (contains(law_names(), name))
    return valid_material(given.set("law", name), valid_shock_viscosity(preset("balanced", 2, false)));
  if (contains(exact_solutions(), name)) return valid_exact(given.set("solution", name));
  if (const List* found = find_anywhere(everything, name)) return *found;
  std::vector<std::string> words = list_names(everything);
  words.push_back("sweep");
  for (const auto& more : {law_names(), exact_solutions()})
    words.insert(words.end(), more.begin(), more.end());
  throw InputError("", "", "",
                   "there is no list, law, exact solution or file '" + one_line(name) + "'" +
                       did_you_mean(name, words));
}

}  // namespace

int describe_command(const std::string& name) {
  describe(schema_of(name), std::cout);
  return 0;
}

namespace {

void tell_what_it_takes(const std::string& file, const List& scene, int threads) {
  const Runtime runtime(threads > 0 ? threads : threads_for(scene));
  const List* exact_list = find_list(scene, "exact");
  const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
  const auto simulation = make_simulation(scene, exact.get());
  const double end = get<double>(scene.sublist("time"), "end");
  const double steps = std::ceil(end / simulation->dt());
  const OutputSize size = output_size(scene, *simulation);
  OutputChoice::expect_within_limit(scene, size);
  simulation->advance(end);  // the first step's beginning is part of setting up
  const auto kernels = kernels_of([&] { simulation->advance(end); });
  const Footprint f = simulation->footprint();

  std::printf("%s: %s\n", file.c_str(), get<std::string>(scene, "title").c_str());
  std::printf("cells      %.0f\nparticles  %.0f\n", f.cells, f.particles);
  std::printf("steps      about %.0f, from the fastest signal at the start\n", steps);
  std::printf("output     %s\n", size.text().c_str());
  double bytes = 0;
  std::printf("columns    bytes a particle\n");
  for (const auto& column : f.columns) {
    std::printf("  %-16s %6.1f\n", column.name.c_str(), column.bytes);
    bytes += column.bytes;
  }
  const double sort = f.sort_bytes / f.particles, grid = f.grid_bytes / f.particles;
  std::printf("  %-16s %6.1f\n  %-16s %6.1f\n  %-16s %6.1f\n", "sorting", sort, "grid", grid, "all",
              bytes + sort + grid);
  std::printf("kernels    launches in a step\n");
  for (const auto& [name, launches] : kernels) std::printf("  %-28s %4d\n", name.c_str(), launches);
}

}  // namespace

int check_command(const SceneRequest& request, int threads) {
  const List scene = load_scene(request);
  try {
    tell_what_it_takes(request.file, scene, threads);
  } catch (const InputError& error) {
    throw locate(request, error);
  }
  return 0;
}

}  // namespace brisance
