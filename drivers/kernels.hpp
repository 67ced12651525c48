#pragma once
// Which kernels a piece of work launches and how long they take, seen through the callbacks of
// Kokkos Tools: no kernel knows of it.
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace brisance {

/// Between start() and stop() every parallel_for, _reduce and _scan counts; otherwise nothing is
/// called and nothing paid. One at a time. Where another tool has the callbacks already
/// (KOKKOS_PROFILE_LIBRARY) it keeps them, and nothing is seen. On the host a kernel has ended when
/// its launch returns; Kokkos sees to it elsewhere, by a fence.
class Kernels {
 public:
  struct Kernel {
    std::string name;
    long launches = 0;
    double seconds = 0;
  };

  ~Kernels() { stop(); }
  void start();
  void stop();

  /// In the order in which they were first launched.
  const std::deque<Kernel>& all() const { return all_; }

 private:
  std::deque<Kernel> all_;
  std::unordered_map<std::string_view, std::uint64_t> places_;  // by the names in all_
  std::chrono::steady_clock::time_point begun_;

  static Kernels* running;
  static void begin(const char* name, std::uint32_t device, std::uint64_t* kernel);
  static void end(std::uint64_t kernel);
};

/// The stages of a sweep by its name, see Sweep::run; of another kernel, its name. None of a second
/// launch.
std::vector<std::string> stages_of(const std::string& name);
bool is_second_launch(const std::string& name);

/// Name and number of launches within `work`, of each stage.
std::map<std::string, int> kernels_of(const std::function<void()>& work);

}  // namespace brisance
