#pragma once

namespace brisance::perf {

/// The most memory that the process has held since this was made, beyond what it held then. Linux
/// (proc(5)) and glibc, which is told to give back first what is free; where the high-water mark
/// cannot be reset, what it holds when asked. Right to some 0.2 MB.
class PeakMemory {
 public:
  PeakMemory();
  double bytes() const;  // [B]
  bool marks() const { return marks_; }

 private:
  bool marks_ = false;
  double before_ = 0;
};

}  // namespace brisance::perf
