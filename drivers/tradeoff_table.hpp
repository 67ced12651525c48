#pragma once
// Error and cost of settings: who lies on the front, the table for people and the file that keeps
// it.
#include <filesystem>
#include <string>
#include <vector>

#include "drivers/tradeoff_scene.hpp"

namespace brisance {

struct TradeoffPoint {
  std::string scene, family;
  Setting setting;
  bool preset_alone = false;  ///< nothing is set beside preset and resolution
  std::string status;         ///< as that of a Record
  double error = 0;           ///< [-]; NaN where the run has none
  double cost = 0;            ///< of one core [s]
  double excess = 0;   ///< cost over that of the cheapest as good as this one: 1 on the front
  std::string commit;  ///< of the program

  bool valid() const { return error >= 0; }
};
using TradeoffPoints = std::vector<TradeoffPoint>;

/// Sets `excess`, scene by scene; NaN where there is no error.
void compare_with_front(TradeoffPoints& points);

/// One line each, below a line of names and units.
void write_points(const std::filesystem::path& csv, const TradeoffPoints& points);

/// The same points. Throws InputError with file and line for a file that write_points() has not
/// written.
TradeoffPoints read_points(const std::filesystem::path& csv);

/// Of one scene: the front from dear to cheap, and where the presets stand beside it.
std::string front_table(const TradeoffPoints& points, const std::string& scene);

}  // namespace brisance
