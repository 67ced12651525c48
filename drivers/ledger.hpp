#pragma once
// What must be conserved: mass, momentum and energy of all particles, with what went out through
// free ends and what walls have taken.
#include <optional>
#include <string>
#include <vector>

#include "core/group.hpp"
#include "drivers/archive.hpp"
#include "drivers/measure.hpp"

namespace brisance {

/// The books at one time.
struct Balance {
  long step = 0;
  double time = 0, dt = 0;  // [s]
  long particles = 0;
  Totals totals, outflow;
  long left = 0;  // particles in the outflow
  struct Material {
    std::string name;
    bool solid = false;
    long particles = 0;
    Totals totals;
  };
  std::vector<Material> materials;
  double wall_impulse[3] = {};    // [N s]
  std::optional<double> springs;  // energy of the springs, if there are any [J]
  long floors = 0;                // states held at a lower bound, so far
};

class Ledger {
 public:
  explicit Ledger(const Balance& start);

  /// Errors relative to the start; momentum relative to sqrt(2 mass energy).
  double mass_error(const Balance& now) const;
  double momentum_error(const Balance& now) const;
  double energy_error(const Balance& now) const;
  std::vector<Measure> measures(const Balance& now) const;

  /// What has left through free ends, in a line for people.
  std::string departures(const Balance& now) const;

  /// What there was at the start, for restart.
  void keep(Archive& archive);

  /// A line of history.csv, and its head. After the sums over everything stand those over each
  /// material, as mass_NAME.
  std::string head() const;
  std::string line(const Balance& now) const;

 private:
  Totals start_;
  double springs_ = 0;  // their energy at the start [J]
  std::vector<std::string> materials_;
  bool solids_ = false, sprung_ = false;
};

/// A name as the last part of that of a column: what is neither letter nor digit becomes _.
std::string column_name(std::string name);

/// The measures of a scene with these materials, whatever happens in it; those of solids if it has
/// any.
std::vector<MeasureDoc> balance_measures(const std::vector<std::string>& materials, bool solids);

}  // namespace brisance
