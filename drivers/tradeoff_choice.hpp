#pragma once
// The cheapest setting that is good enough, or the best that is cheap enough, and what to expect of
// it.
#include <optional>
#include <string>

#include "drivers/tradeoff_table.hpp"

namespace brisance {

/// What is asked for: one of the two.
struct Wish {
  std::optional<double> error;   ///< at most [-]
  std::optional<double> budget;  ///< at most, of one core [s]
};

/// "2%" or "0.02" -> 0.02. Throws InputError that names the option unless it is above 0.
double error_from(const std::string& text);
/// "60", "60s", "5min", "2h" -> seconds. The same.
double budget_from(const std::string& text);

/// A setting with what is expected of it.
struct Choice {
  Setting setting;
  double error = 0, least_error = 0;  ///< [-]
  double cost = 0;                    ///< [s]
  bool fulfils = true;                ///< else the nearest to the wish that there is
};

/// From points of one scene; none where no point has an error.
std::optional<Choice> choose(const TradeoffPoints& points, const Wish& wish);

/// From the scenes of a family, for another one of it, in which `allows` tells the resolutions that
/// can be. The error is the largest that a setting has had in a scene of the family; the cost is
/// that of one cheap setting, the probe, in the scene itself, times the largest ratio of both costs
/// in the family. A preset alone is preferred to other settings that are as cheap within what such
/// estimates are worth.
class FamilyFit {
 public:
  FamilyFit(const TradeoffPoints& points, const std::string& family, const TradeoffScene& scene);

  const std::vector<std::string>& scenes() const { return scenes_; }
  /// That has to be run in the scene; none where nothing has been measured in all of the family.
  std::optional<Setting> probe() const;
  /// `cost`: of the probe [s].
  std::optional<Choice> choose(double cost, const Wish& wish) const;

 private:
  struct Entry {
    Setting setting;
    bool preset_alone;
    std::vector<double> errors, costs;  ///< scene by scene
  };
  std::vector<std::string> scenes_;
  std::vector<Entry> entries_;  ///< measured in all scenes, the cheapest first
  std::size_t probe_ = 0;
};

}  // namespace brisance
