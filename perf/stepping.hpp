#pragma once
#include <benchmark/benchmark.h>

#include "core/parameters.hpp"

namespace brisance::perf {

/// Measures steps of a complete scene, after some that fill caches and set things going:
/// particle-steps/s, particles, bytes a particle.
void steps_of(benchmark::State& state, const List& scene);

}  // namespace brisance::perf
