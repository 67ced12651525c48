#pragma once
#include <benchmark/benchmark.h>

#include "core/parameters.hpp"
#include "drivers/archive.hpp"
#include "drivers/exact.hpp"

namespace brisance::perf {

/// Measures steps of a complete scene, after some that fill caches and set things going:
/// particle-steps/s, particles, the peak of memory since before the set-up, all included; of solids
/// the shares of the points that yield in a step, are damaged, have begun to come apart. `from`: a
/// state of that scene to start from in place of its own. Returns how many particle-steps were
/// measured.
double steps_of(benchmark::State& state, const List& scene, const ExactSolution* exact,
                Archive* from = nullptr);

}  // namespace brisance::perf
