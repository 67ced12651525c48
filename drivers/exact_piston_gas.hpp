#pragma once
// A piston of elastic steel drives a shock into a gas at rest, section 4.3.2 of Hu & Chen (2006).
#include "drivers/exact_solid.hpp"

namespace brisance {

/// Along x: a piston at rest, gas, and a piston that runs towards it with `speed`. Behind the shock
/// in the gas and the elastic wave in the piston, pressure and velocity are those of the interface:
/// Rankine-Hugoniot of a perfect gas (Toro 2009, chapter 3) against s = rho c (speed - u).
class PistonGas final : public ExactSolution {
 public:
  struct Data {
    PlateMatter steel;
    double density = 1, pressure = 1, gamma = 1.4;  // of the gas at rest [kg/m3], [Pa], [-]
    double speed = 1;                               // of the piston towards low x [m/s]
    double interface = 0;                           // of gas and moving piston at t = 0 [m]
    double gas_length = 1, piston_length = 1;       // [m]
    double frame = 0;  // velocity along x of everything, beside its own [m/s]
  };
  explicit PistonGas(const Data& data);
  explicit PistonGas(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  double interface_speed() const { return u_; }  // towards low x [m/s]
  double plateau() const { return p_; }          // pressure behind the shock [Pa]
  double shock_speed() const { return shock_; }  // towards low x [m/s]

  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
  double u_ = 0, p_ = 0, shock_ = 0;
  // Places in the frame of the gas at rest [m].
  double shock_at(double t) const { return data_.interface - shock_ * t; }
  double interface_at(double t) const { return data_.interface - u_ * t; }
  double wave_at(double t) const {
    return data_.interface + (data_.steel.wave_speed() - data_.speed) * t;
  }
};

}  // namespace brisance
