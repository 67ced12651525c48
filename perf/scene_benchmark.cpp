// Steps of scenes that come with the program, from their start.
#include <Teuchos_ParameterList.hpp>
#include <string>

#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "perf/benchmarks.hpp"
#include "perf/stepping.hpp"

namespace brisance::perf {

void register_scenes() {
  for (const std::string name :
       {"riemann", "detonation_1d", "sedov_table1", "concrete_impact", "bomb_cased"}) {
    const std::string file = (data_folder() / "inputs" / (name + ".xml")).string();
    benchmark::RegisterBenchmark(("scene/" + name).c_str(),
                                 [=](benchmark::State& state) {
                                   const List scene = load_scene({file, {}, {}});
                                   const List* list = find_list(scene, "exact");
                                   const auto exact = list ? make_exact(*list) : nullptr;
                                   steps_of(state, scene, exact.get());
                                 })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  }
}

}  // namespace brisance::perf
