#include "perf/memory.hpp"

#include <malloc.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace brisance::perf {
namespace {

/// A line of /proc/self/status in bytes; 0 if there is none.
double status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  double kilobytes = 0;
  for (std::string line; std::getline(file, line);)
    if (line.rfind(name + ":", 0) == 0)
      std::sscanf(line.c_str() + name.size(), ": %lf", &kilobytes);
  return 1024 * kilobytes;
}

}  // namespace

PeakMemory::PeakMemory() {
  malloc_trim(0);
  std::ofstream mark("/proc/self/clear_refs");
  marks_ = static_cast<bool>(mark << "5" << std::flush);
  before_ = status("VmRSS");
}

double PeakMemory::bytes() const { return status(marks_ ? "VmHWM" : "VmRSS") - before_; }

}  // namespace brisance::perf
