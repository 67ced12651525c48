#pragma once
// What a scene's list "checks" demands, held against what was measured.
#include <cmath>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/measure.hpp"

namespace brisance {

struct Verdict {
  std::string quantity, unit;
  double measured = 0, least = 0, most = 0;
  /// NaN is never reached, and raises no floating point exception.
  bool reached() const {
    return std::isgreaterequal(measured, least) && std::islessequal(measured, most);
  }
  std::string limit() const;  ///< "<= 0.011", "4.4e6 .. 4.8e6"
};

/// One verdict for each range in the list (may be null), in its order.
std::vector<Verdict> judge(const List* ranges, const std::vector<Measure>& measured);

/// The verdict of one range on one value.
Verdict judge_one(const List& range, const std::string& quantity, double measured,
                  const std::string& unit);

bool all_reached(const std::vector<Verdict>& verdicts);

}  // namespace brisance
