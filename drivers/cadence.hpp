#pragma once
// When something is due that happens at intervals of simulated time.

#include "drivers/archive.hpp"

namespace brisance {

/// The multiples of an interval; a step passes one when it first reaches it.
class Cadence {
 public:
  explicit Cadence(double interval) : interval_(interval), next_(interval) {}
  bool due(double time) {
    if (time < next_ * (1 - 1e-12)) return false;
    while (next_ <= time * (1 + 1e-12)) next_ = static_cast<double>(++count_) * interval_;
    return true;
  }

  /// For restart. With another interval it goes on with the first multiple that has not been due.
  void keep(Archive& archive, const std::string& name = "cadence") {
    const Archive::Part part(archive, name);
    double interval = interval_;
    archive.keep("interval", interval);
    archive.keep("count", count_);
    if (interval != interval_) {
      const double passed = static_cast<double>(count_ - 1) * interval;
      count_ = 1 + static_cast<long>(passed / interval_ * (1 + 1e-12));
    }
    next_ = static_cast<double>(count_) * interval_;
  }

 private:
  double interval_, next_;
  long count_ = 1;
};

}  // namespace brisance
