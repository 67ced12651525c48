#pragma once
// Where the time of a run goes: its parts by the clock, and the kernels within its steps.
#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "drivers/kernels.hpp"

namespace brisance {

/// One line of the account.
struct TimeRow {
  std::string name;
  double seconds = 0;
  double calls = 0;  ///< launches of a kernel, or how often it was done
};

/// The account of a run. Shares are those of all seconds, and sum to one at most.
struct TimeSpent {
  double seconds = 0;            ///< from the start to when it was asked for
  std::vector<TimeRow> kernels;  ///< of the steps, under their labels, longest first
  std::vector<TimeRow> parts;    ///< the whole run: set-up, steps, ... and what is left
  double measured_steps = 0;     ///< those whose kernels were timed; the others are like them
};

/// The kernels with those that are alike as one: "count bins" and "permute", all that the library
/// does to arrays, and so on; longest first.
std::vector<TimeRow> alike_together(const std::vector<TimeRow>& kernels);

class TimeKeeper {
 public:
  enum Part { set_up, steps, watches, output, tables, checkpoints, disk, count };

  /// What `work` returns; its time counts for a part. Parts are not nested.
  template <class F>
  auto on(Part part, const F& work) {
    const Timed timed(*this, part);
    return work();
  }

  /// A step. To look at kernels costs some 100 ns for each launch, so that in a small scene only
  /// one step in so many is measured: some 0.2 % of the time go into it.
  template <class F>
  void step(const F& work) {
    const bool measured = skip_ == 0;
    if (measured) kernels_.start();
    const double before = spent_[steps];
    on(steps, work);
    if (measured)
      measure(spent_[steps] - before);
    else
      --skip_;
  }

  TimeSpent so_far() const;

 private:
  using Clock = std::chrono::steady_clock;
  static double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  /// Counts for a part while it lives.
  struct Timed {
    TimeKeeper& keeper;
    Part part;
    Clock::time_point start = Clock::now();
    Timed(TimeKeeper& k, Part p) : keeper(k), part(p) {}
    ~Timed() {
      keeper.spent_[part] += since(start);
      ++keeper.calls_[part];
    }
  };

  void measure(double seconds);

  Clock::time_point started_ = Clock::now();
  std::array<double, count> spent_{};  // [s]
  std::array<long, count> calls_{};
  Kernels kernels_;
  double measured_seconds_ = 0;
  long measured_steps_ = 0, launches_ = 0;
  long skip_ = 1;  ///< steps until the next is measured; the first has begun in the set-up
};

}  // namespace brisance
