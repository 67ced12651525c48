// Runs the benchmarks of this folder. What they were measured with stands in the context of the
// output: program, threads, processor.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
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

/// Takes --cells=N,N,... out of the words.
std::vector<int> sizes(int& argc, char** argv) {
  const std::string option = "--cells=";
  std::vector<int> cells;
  int kept = 0;
  for (int k = 0; k < argc; ++k) {
    const std::string word = argv[k];
    if (word.rfind(option, 0) != 0) {
      argv[kept++] = argv[k];
      continue;
    }
    std::istringstream list(word.substr(option.size()));
    for (std::string n; std::getline(list, n, ',');) {
      cells.push_back(std::atoi(n.c_str()));
      if (cells.back() > 0) continue;
      std::fprintf(stderr, "brisance: bench: --cells takes numbers above 0, not '%s'\n", n.c_str());
      std::exit(2);
    }
  }
  argc = kept;
  return cells;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<int> cells = sizes(argc, argv);
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
  brisance::perf::register_sizes(cells);
  brisance::perf::register_scenes();
  benchmark::Initialize(&argc, argv);
  const bool refused = benchmark::ReportUnrecognizedArguments(argc, argv);
  if (!refused) benchmark::RunSpecifiedBenchmarks();
  Kokkos::finalize();
  return refused ? 2 : 0;
}
