// Steps of scenes that come with the program: from their start, and on finer cells from a moment at
// which there is much going on.
#include <Teuchos_ParameterList.hpp>
#include <map>
#include <string>

#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "drivers/simulation.hpp"
#include "perf/benchmarks.hpp"
#include "perf/stepping.hpp"

namespace brisance::perf {
namespace {

struct Moment {
  std::string name, scene;
  std::string cells;      ///< along an edge
  std::string cell_size;  ///< [m]
  double time;            ///< [s]
};

/// A quarter of the air moves, and the case has broken; a third of the gas is behind the shock.
const Moment moments[] = {{"cased bomb", "bomb_cased", "400", "0.005", 2e-4},
                          {"Sedov blast", "sedov_table1", "240", "0.0025", 1e-5}};

List scene_of(const std::string& name, const std::vector<std::string>& assignments) {
  return load_scene({(data_folder() / "inputs" / (name + ".xml")).string(), {}, assignments});
}

std::unique_ptr<ExactSolution> exact_of(const List& scene) {
  const List* list = find_list(scene, "exact");
  return list ? make_exact(*list) : nullptr;
}

/// Reached once, in some seconds, whatever the number of repetitions.
Archive& state_at(const Moment& moment, const List& scene, const ExactSolution* exact) {
  static std::map<std::string, Archive> reached;
  const auto known = reached.find(moment.name);
  if (known != reached.end()) return known->second;
  const auto simulation = make_simulation(scene, exact);
  while (simulation->time() < moment.time) simulation->advance(moment.time);
  Archive written;
  simulation->keep(written);
  return reached.emplace(moment.name, Archive(std::move(written.entries()))).first->second;
}

}  // namespace

void register_scenes() {
  for (const std::string name :
       {"riemann", "detonation_1d", "sedov_table1", "concrete_impact", "bomb_cased"})
    add("scene/" + name, [=](benchmark::State& state) {
      const List scene = scene_of(name, {});
      steps_of(state, scene, exact_of(scene).get());
    });
  for (const Moment& moment : moments)
    add("step/" + moment.name + "/" + moment.cells, [=](benchmark::State& state) {
      const List scene =
          scene_of(moment.scene, {"grid/cells={" + moment.cells + ", " + moment.cells + "}",
                                  "grid/cell size=" + moment.cell_size});
      const auto exact = exact_of(scene);
      steps_of(state, scene, exact.get(), &state_at(moment, scene, exact.get()));
    });
}

}  // namespace brisance::perf
