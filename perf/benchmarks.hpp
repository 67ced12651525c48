#pragma once
// The benchmarks by subject. Their names begin with machine/, law/, kernel/, step/, weak/, size/,
// scene/. They count particle-steps, particles or points a second; kernels, steps and the machine
// also GB and GFLOP a second.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace brisance::perf {

void register_machine();
void register_laws();
void register_kernels();
/// `threads`: of the runtime, for boxes that grow with them.
void register_steps(int threads);
/// Boxes of gas of so many cells along an edge.
void register_sizes(const std::vector<int>& cells);
void register_scenes();

template <class F>
void add(const std::string& name, const F& work) {
  benchmark::RegisterBenchmark(name.c_str(), work)->Unit(benchmark::kMillisecond)->UseRealTime();
}

}  // namespace brisance::perf
