// Steps of scenes that come with the program, from their start.
#include <Teuchos_ParameterList.hpp>
#include <limits>
#include <string>

#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "drivers/simulation.hpp"
#include "perf/benchmarks.hpp"
#include "perf/stepping.hpp"

namespace brisance::perf {

void steps_of(benchmark::State& state, const List& scene) {
  constexpr double end = std::numeric_limits<double>::max();
  constexpr int before = 10;
  const List* exact_list = find_list(scene, "exact");
  const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
  const auto simulation = make_simulation(scene, exact.get());
  for (int k = 0; k < before; ++k) simulation->advance(end);
  double particle_steps = 0;
  for ([[maybe_unused]] auto once : state) {
    simulation->advance(end);
    particle_steps += static_cast<double>(simulation->particle_count());
  }
  const Footprint f = simulation->footprint();
  double bytes = (f.grid_bytes + f.sort_bytes) / f.particles;
  for (const auto& column : f.columns) bytes += column.bytes;
  state.counters["particles"] = f.particles;
  state.counters["bytes/particle"] = bytes;
  state.counters["particle-steps/s"] =
      benchmark::Counter(particle_steps, benchmark::Counter::kIsRate);
}

void register_scenes() {
  for (const std::string name :
       {"riemann", "detonation_1d", "sedov_table1", "concrete_impact", "bomb_cased"}) {
    const std::string file = (data_folder() / "inputs" / (name + ".xml")).string();
    benchmark::RegisterBenchmark(("scene/" + name).c_str(),
                                 [=](benchmark::State& state) {
                                   steps_of(state, load_scene({file, {}, {}}));
                                 })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
}

}  // namespace brisance::perf
