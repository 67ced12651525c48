#pragma once
// Stacked layers of explosive, gas and steel in one direction, plane or about an axis, on cells
// that move with the matter: what a run is held against where there is no closed answer.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "drivers/exact_solid.hpp"
#include "materials/jwl.hpp"

namespace brisance {

struct Layer {
  enum class Law { explosive, gas, steel };
  std::string name;
  Law law = Law::gas;
  double thickness = 1;                 // [m]
  double density = 1, energy = 0;       // at first; of an explosive: chemical [kg/m3], [J/kg]
  double gamma = 1.4;                   // of a gas
  PlateMatter steel;                    // its moduli
  double yield = 0;                     // of steel [Pa]
  std::shared_ptr<const Jwl> products;  // of an explosive
  double detonation_speed = 1;          // at which it is lit from the origin on [m/s]
};

/// The scheme of von Neumann & Richtmyer (1950) with Wilkins' stresses and burn by time or
/// compression (1964), its steps written as half a drift, a kick by the forces there, half a drift.
/// Cells pay the work of the forces that accelerate, over the mean velocity, which keeps total
/// energy to round-off (Caramana, Burton, Shashkov & Whalen, Journal of Computational Physics 146
/// (1998) 227-262).
class Lagrangian {
 public:
  struct Data {
    std::vector<Layer> layers;  // from the origin outward
    bool cylindrical = false;
    double origin = 0;                       // inner end of the first layer [m]
    bool low_wall = true, high_wall = true;  // else free ends
    double cell_size = 1;                    // [m]
  };
  explicit Lagrangian(const Data& data);

  /// One step, which does not go beyond `end`.
  void step(double end);
  void advance_to(double end) {
    while (time_ < end) step(end);
  }

  struct Cell {
    int layer = 0;
    double mass = 0, volume = 0;  // plane: per area; cylindrical: per angle and length
    double energy = 0;            // internal [J/kg]
    double pressure = 0;          // at the last half step [Pa]
    double sound_speed = 0;       // [m/s]
    double along = 0, hoop = 0;   // deviatoric stress [Pa]
    double burned = 1, lit = 0, burn_time = 0;  // share [-]; begin and length of its burn [s]
    double cj_volume = 1;  // over the initial one: compression to it burns all [-]
  };
  double time() const { return time_; }
  long steps() const { return steps_; }
  double energy_error() const { return energy() / start_energy_ - 1; }
  const std::vector<Cell>& cells() const { return cells_; }
  const std::vector<double>& places() const { return x_; }  // of the ends of cells [m]
  const std::vector<double>& velocities() const { return u_; }
  double centre(std::size_t cell) const { return 0.5 * (x_[cell] + x_[cell + 1]); }
  double mean_velocity(int layer) const;               // by mass [m/s]
  std::pair<double, double> ends_of(int layer) const;  // [m]

 private:
  struct Push {
    double low = 0, high = 0;  // forces on the ends of a cell [N per area, or per angle and length]
  };
  Push push(std::size_t i);
  double volume_between(double low, double high) const;
  double energy() const;

  Data data_;
  std::vector<Cell> cells_;
  std::vector<double> x_, u_, mass_;  // of the ends of cells
  std::vector<double> half_x_, mean_u_;
  std::vector<Push> push_;
  double time_ = 0, dt_ = 0, next_dt_ = 0, start_energy_ = 0;
  long steps_ = 0;
};

}  // namespace brisance
