// Whole steps of a box of gas, in particle-steps per second: the starting point for all work on
// speed.
#include <benchmark/benchmark.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <limits>

#include "core/types.hpp"
#include "drivers/scene.hpp"
#include "drivers/simulation.hpp"

namespace {

using namespace brisance;

/// A periodic box of cells with 2 x 2 particles each, all of them moving at a tenth of the sound
/// speed or so.
List box(const std::string& preset, int cells) {
  List scene("box");
  scene.set("geometry", "plane strain").set("preset", preset);
  scene.sublist("grid").set("cells", Teuchos::Array<int>(std::vector<int>{cells, cells}));
  scene.sublist("grid").set("cell size", 1.0 / cells);
  for (const char* end : {"x low", "x high", "y low", "y high"})
    scene.sublist("boundaries").set(end, "periodic");
  scene.sublist("time").set("end", 1.0);
  scene.sublist("materials").sublist("gas").set("law", "perfect gas").set("gamma", 1.4);
  List& body = scene.sublist("bodies").sublist("gas");
  body.set("material", "gas").set("particles per cell", 2).set("initial state", "exact");
  List& vortex = scene.sublist("exact");
  vortex.set("solution", "vortex").set("gamma", 1.4).set("box length", 1.0).set("radius", 0.1);
  vortex.set("centre", Teuchos::Array<double>(std::vector<double>{0.5, 0.5}));
  return complete_scene(scene);
}

void step(benchmark::State& state, const std::string& preset) {
  const List scene = box(preset, static_cast<int>(state.range(0)));
  const auto exact = make_exact(scene.sublist("exact"));
  const auto simulation = make_simulation(scene, exact.get());
  double particle_steps = 0;
  for ([[maybe_unused]] auto once : state) {
    simulation->advance(std::numeric_limits<double>::max());
    particle_steps += static_cast<double>(simulation->particle_count());
  }
  state.counters["particles"] = static_cast<double>(simulation->particle_count());
  state.counters["particle-steps/s"] =
      benchmark::Counter(particle_steps, benchmark::Counter::kIsRate);
}

}  // namespace

int main(int argc, char** argv) {
  brisance::initialize_kokkos(-1);
  for (const char* preset : {"paper", "fast", "balanced", "accurate"})
    benchmark::RegisterBenchmark((std::string("step/plane strain/") + preset).c_str(), step,
                                 std::string(preset))
        ->Arg(50)
        ->Arg(500)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  Kokkos::finalize();
}
