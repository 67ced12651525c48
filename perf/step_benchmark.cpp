// Whole steps of boxes of gas, steel and concrete, in particle-steps per second: the starting point
// for all work on speed. GB/s and GFLOP/s are what a step has to do at least, see work.hpp.
#include <benchmark/benchmark.h>

#include <cmath>
#include <exception>
#include <functional>

#include "perf/benchmarks.hpp"
#include "perf/boxes.hpp"
#include "perf/stepping.hpp"

namespace brisance::perf {
namespace {

using Make = std::function<Box(int)>;
constexpr const char* presets[] = {"paper", "fast", "balanced", "accurate"};

void run(benchmark::State& state, const Box& box) {
  const double particle_steps = steps_of(state, box.scene, box.start.get());
  const auto count = [&](const char* unit, double of_one) {
    if (of_one > 0)
      state.counters[unit] =
          benchmark::Counter(1e-9 * of_one * particle_steps, benchmark::Counter::kIsRate);
  };
  count("GB/s", box.work.bytes);
  count("GFLOP/s", box.work.flops);
}

void add(const std::string& name, int cells, const Make& make) {
  benchmark::RegisterBenchmark((name + "/" + std::to_string(cells)).c_str(),
                               [=](benchmark::State& state) {
                                 try {
                                   run(state, make(cells));
                                 } catch (const std::exception& error) {  // too little memory
                                   state.SkipWithError(error.what());
                                 }
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

Make gas(const std::string& preset, bool quadratic = false) {
  return [=](int cells) { return gas_box(preset, quadratic, cells); };
}

/// The same with a copy of the nodes for each thread, beside which the default shows what the same
/// bits for any number of threads cost.
Make gas_by_duplicates(const std::string& preset) {
  return [=](int cells) {
    Box box = gas_box(preset, false, cells);
    box.scene.sublist("scheme").set("summation", "duplicates");
    return box;
  };
}

}  // namespace

void register_steps(int threads) {
  const int weak = static_cast<int>(std::lround(200 * std::sqrt(threads)));
  for (const std::string preset : presets) {
    for (const int cells : {50, 500}) add("step/plane strain/" + preset, cells, gas(preset));
    // As many cells for each thread, whatever their number.
    add("weak/plane strain/" + preset, weak, gas(preset));
  }
  for (const std::string preset : {"paper", "balanced"})
    add("step/plane strain/" + preset + " duplicates", 500, gas_by_duplicates(preset));
  for (const int cells : {50, 500}) {
    add("step/plane strain/paper quadratic", cells, gas("paper", true));
    for (const bool quadratic : {false, true}) {
      const std::string shape = quadratic ? "quadratic" : "linear";
      add("step/steel/" + shape, cells, [=](int n) { return steel_box(quadratic, n); });
      add("step/concrete/" + shape, cells, [=](int n) { return concrete_box(quadratic, n); });
    }
  }
}

void register_sizes(const std::vector<int>& cells) {
  for (const std::string preset : presets)
    for (const int n : cells) add("size/" + preset, n, gas(preset));
}

}  // namespace brisance::perf
