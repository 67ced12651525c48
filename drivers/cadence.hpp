#pragma once
// When something is due that happens at intervals of simulated time.

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

 private:
  double interval_, next_;
  long count_ = 1;
};

}  // namespace brisance
