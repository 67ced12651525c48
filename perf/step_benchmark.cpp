// Whole steps of a box of gas, in particle-steps per second: the starting point for all work on
// speed.
#include <benchmark/benchmark.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <limits>

#include "drivers/scene.hpp"
#include "perf/benchmarks.hpp"
#include "perf/stepping.hpp"

namespace brisance::perf {
namespace {

/// A periodic box of cells with 2 x 2 particles each: a vortex in gas that drifts at 0.3 and 0.2 of
/// the sound speed, so that particles change their cells as those of real flows do.
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
  const double sound = std::sqrt(1.4);  // of density and pressure 1
  vortex.set("velocity", Teuchos::Array<double>(std::vector<double>{0.3 * sound, 0.2 * sound}));
  return complete_scene(scene);
}

void add(const std::string& name, const std::string& preset, int cells) {
  benchmark::RegisterBenchmark(
      (name + "/" + preset + "/" + std::to_string(cells)).c_str(),
      [=](benchmark::State& state) { steps_of(state, box(preset, cells)); })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace

void register_steps(int threads) {
  for (const char* preset : {"paper", "fast", "balanced", "accurate"}) {
    for (const int cells : {50, 500}) add("step/plane strain", preset, cells);
    // As many cells for each thread, whatever their number.
    add("weak/plane strain", preset, static_cast<int>(std::lround(200 * std::sqrt(threads))));
  }
}

}  // namespace brisance::perf
