#include "drivers/kernels.hpp"

#include "core/types.hpp"

namespace brisance {
namespace {

std::map<std::string, int>* launched = nullptr;

void note(const char* name, uint32_t, uint64_t*) {
  if (launched) ++(*launched)[name];
}

}  // namespace

std::map<std::string, int> kernels_of(const std::function<void()>& work) {
  namespace tools = Kokkos::Tools::Experimental;
  std::map<std::string, int> seen;
  launched = &seen;
  tools::set_begin_parallel_for_callback(note);
  tools::set_begin_parallel_reduce_callback(note);
  tools::set_begin_parallel_scan_callback(note);
  work();
  launched = nullptr;
  tools::set_begin_parallel_for_callback(nullptr);
  tools::set_begin_parallel_reduce_callback(nullptr);
  tools::set_begin_parallel_scan_callback(nullptr);
  return seen;
}

}  // namespace brisance
