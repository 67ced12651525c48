#pragma once
// A place to look at, and what is seen there.
#include <array>

namespace brisance {

struct Window {
  std::array<double, 3> place{};  ///< [m]
  double radius = 0;              ///< distance between the knots of the weight [m]
  int material = -1;  ///< that counts, in the order of the scene; -1: fluids, else all [-]
  bool rides = false;
};

struct Seen {
  int points = 0;                    ///< in reach; without any, all is 0
  double pressure = 0;               ///< mean by volume [Pa]
  std::array<double, 3> velocity{};  ///< mean by mass [m/s]
};

}  // namespace brisance
