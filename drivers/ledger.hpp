#pragma once
// What must be conserved: mass, momentum and energy of all particles, with what went out through
// free ends and what walls have taken.
#include <string>
#include <vector>

#include "core/group.hpp"
#include "drivers/measure.hpp"

namespace brisance {

/// The books at one time.
struct Balance {
  long step = 0;
  double time = 0, dt = 0;  // [s]
  long particles = 0;
  Totals totals, outflow;
  double wall_impulse[3] = {};  // [N s]
  long floors = 0;              // states held at a lower bound, so far
};

class Ledger {
 public:
  explicit Ledger(const Balance& start) : start_(start.totals) {}

  /// Errors relative to the start; momentum relative to sqrt(2 mass energy).
  double mass_error(const Balance& now) const;
  double momentum_error(const Balance& now) const;
  double energy_error(const Balance& now) const;
  std::vector<Measure> measures(const Balance& now) const;

  /// A line of history.csv, and its head.
  static std::string head();
  std::string line(const Balance& now) const;

 private:
  Totals start_;
};

/// The measures that every scene has.
std::vector<MeasureDoc> conservation_measures();

}  // namespace brisance
