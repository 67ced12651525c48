// Runs the benchmarks of this folder. What they were measured with stands in the context of the
// output: program, threads, processor.
#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

#include "core/types.hpp"
#include "perf/benchmarks.hpp"
#include "version.hpp"

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

int main(int argc, char** argv) {
  brisance::initialize_kokkos(-1);
  const int threads = brisance::Space().concurrency();
  benchmark::AddCustomContext("commit", brisance::version::commit);
  benchmark::AddCustomContext("compiler", brisance::version::compiler);
  benchmark::AddCustomContext("processor", processor());
  benchmark::AddCustomContext("threads", std::to_string(threads));
  brisance::perf::register_machine();
  brisance::perf::register_laws();
  brisance::perf::register_kernels();
  brisance::perf::register_steps(threads);
  brisance::perf::register_scenes();
  benchmark::Initialize(&argc, argv);
  const bool refused = benchmark::ReportUnrecognizedArguments(argc, argv);
  if (!refused) benchmark::RunSpecifiedBenchmarks();
  Kokkos::finalize();
  return refused ? 2 : 0;
}
