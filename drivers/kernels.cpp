#include "drivers/kernels.hpp"

#include "core/types.hpp"

namespace brisance {
namespace {

namespace tools = Kokkos::Tools::Experimental;
using Clock = std::chrono::steady_clock;

}  // namespace

Kernels* Kernels::running = nullptr;

void Kernels::begin(const char* name, std::uint32_t, std::uint64_t* kernel) {
  Kernels& k = *running;
  const auto known = k.places_.find(name);
  if (known != k.places_.end()) {
    *kernel = known->second;
  } else {
    *kernel = k.all_.size();
    k.all_.push_back({name});
    k.places_.emplace(k.all_.back().name, *kernel);
  }
  k.begun_ = Clock::now();
}

void Kernels::end(std::uint64_t kernel) {
  const auto now = Clock::now();
  Kernel& k = running->all_[kernel];
  ++k.launches;
  k.seconds += std::chrono::duration<double>(now - running->begun_).count();
}

void Kernels::start() {
  if (tools::get_callbacks().begin_parallel_for) return;
  running = this;
  tools::set_begin_parallel_for_callback(begin);
  tools::set_begin_parallel_reduce_callback(begin);
  tools::set_begin_parallel_scan_callback(begin);
  tools::set_end_parallel_for_callback(end);
  tools::set_end_parallel_reduce_callback(end);
  tools::set_end_parallel_scan_callback(end);
}

void Kernels::stop() {
  if (running != this) return;
  running = nullptr;
  tools::set_begin_parallel_for_callback(nullptr);
  tools::set_begin_parallel_reduce_callback(nullptr);
  tools::set_begin_parallel_scan_callback(nullptr);
  tools::set_end_parallel_for_callback(nullptr);
  tools::set_end_parallel_reduce_callback(nullptr);
  tools::set_end_parallel_scan_callback(nullptr);
}

std::vector<std::string> stages_of(const std::string& name) {
  std::vector<std::string> stages;
  if (is_second_launch(name)) return stages;
  for (std::size_t begin = 0; begin != std::string::npos;) {
    const std::size_t end = name.find(", ", begin);
    stages.push_back(name.substr(begin, end - begin));
    begin = end == std::string::npos ? end : end + 2;
  }
  return stages;
}

bool is_second_launch(const std::string& name) {
  const std::string mark = " (2)";
  return name.size() > mark.size() &&
         name.compare(name.size() - mark.size(), mark.size(), mark) == 0;
}

std::map<std::string, int> kernels_of(const std::function<void()>& work) {
  Kernels kernels;
  kernels.start();
  work();
  kernels.stop();
  std::map<std::string, int> launches;
  for (const auto& kernel : kernels.all())
    for (const auto& stage : stages_of(kernel.name))
      launches[stage] += static_cast<int>(kernel.launches);
  return launches;
}

}  // namespace brisance
