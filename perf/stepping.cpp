#include "perf/stepping.hpp"

#include <Teuchos_ParameterList.hpp>
#include <limits>

#include "drivers/simulation.hpp"
#include "perf/memory.hpp"
#include "perf/shares.hpp"

namespace brisance::perf {

double steps_of(benchmark::State& state, const List& scene, const ExactSolution* exact,
                Archive* from) {
  constexpr double end = std::numeric_limits<double>::max();
  constexpr int before = 10;
  const PeakMemory memory;
  const auto simulation = make_simulation(scene, exact);
  if (from) simulation->keep(*from);
  for (int k = 0; k < before; ++k) simulation->advance(end);
  double particle_steps = 0;
  for ([[maybe_unused]] auto once : state) {
    simulation->advance(end);
    particle_steps += static_cast<double>(simulation->particle_count());
  }
  const auto particles = static_cast<double>(simulation->particle_count());
  state.counters["particles"] = particles;
  state.counters["peak bytes/particle"] = memory.bytes() / particles;
  state.counters["particle-steps/s"] =
      benchmark::Counter(particle_steps, benchmark::Counter::kIsRate);
  if (find_list(scene.sublist("scheme"), "solids"))
    for (const auto& [name, share] : shares_of(*simulation)) state.counters[name] = share;
  return particle_steps;
}

}  // namespace brisance::perf
