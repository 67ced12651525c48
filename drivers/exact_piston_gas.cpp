#include "drivers/exact_piston_gas.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

// Behind a shock that leaves the gas at rest with velocity u.
double shocked_pressure(const PistonGas::Data& gas, double u) {
  const double strong = 0.25 * (gas.gamma + 1) * gas.density * u * u;
  return gas.pressure + strong +
         std::sqrt(strong * strong + gas.gamma * gas.pressure * gas.density * u * u);
}

}  // namespace

List PistonGas::valid_parameters() {
  List valid = list_for_solution("piston gas");
  declare_plate(valid);
  declare_required<double>(valid, "gas density", positive(), "of the gas at rest [kg/m^3]");
  declare_required<double>(valid, "gas pressure", positive(), "of the gas at rest [Pa]");
  declare_gamma(valid);
  declare_required<double>(valid, "speed", positive(), "of the piston, towards low x [m/s]");
  declare_required<double>(valid, "interface", anything(),
                           "where gas and moving piston meet at the start [m]");
  declare_required<double>(valid, "gas length", positive(), "between the pistons at first [m]");
  declare_required<double>(valid, "piston length", positive(), "of either piston [m]");
  declare(valid, "frame velocity", 0.0, anything(), "along x, of everything, beside its own [m/s]");
  return valid;
}

PistonGas::PistonGas(const List& list)
    : PistonGas(Data{plate_of(list), get<double>(list, "gas density"),
                     get<double>(list, "gas pressure"), get<double>(list, "gamma"),
                     get<double>(list, "speed"), get<double>(list, "interface"),
                     get<double>(list, "gas length"), get<double>(list, "piston length"),
                     get<double>(list, "frame velocity")}) {}

// The steel is free of stress at first, so that all of the gas's pressure loads it.
PistonGas::PistonGas(const Data& data) : data_(data) {
  const double impedance = data.steel.density * data.steel.wave_speed();
  double low = 0, high = data.speed;
  for (int k = 0; k < 100; ++k) {
    u_ = 0.5 * (low + high);
    (shocked_pressure(data, u_) > impedance * (data.speed - u_) ? high : low) = u_;
  }
  p_ = shocked_pressure(data, u_);
  shock_ = (p_ - data.pressure) / (data.density * u_);
  if (!(shocked_pressure(data, high) > data.pressure * (1 + 1e-9)))
    throw InputError("exact", "speed", "", "must be so high that the gas is compressed");
}

MatterState PistonGas::at(const Place& x, double t) const {
  const double place = x[0] - data_.frame * t, gas_begins = data_.interface - data_.gas_length;
  MatterState s;
  if (place < gas_begins - data_.piston_length ||
      place > data_.interface + data_.piston_length - data_.speed * t)
    return s;
  if (place < gas_begins) {
    s = data_.steel.elastic_state(0, 0);
  } else if (place < interface_at(t)) {
    const bool shocked = place > shock_at(t);
    s.rho = shocked ? data_.density * shock_ / (shock_ - u_) : data_.density;
    s.p = shocked ? p_ : data_.pressure;
    s.e = s.p / ((data_.gamma - 1) * s.rho);
    s.v[0] = shocked ? -u_ : 0;
  } else {
    const bool loaded = place < wave_at(t);
    s = data_.steel.elastic_state(loaded ? -p_ : 0, loaded ? -u_ : -data_.speed);
  }
  s.v[0] += data_.frame;
  return s;
}

std::vector<Measure> PistonGas::features(double t) const {
  const double shift = data_.frame * t;
  return {{"plateau", p_, "Pa", "pressure of the gas, stress of the steel"},
          {"interface speed", u_, "m/s", "towards the gas at rest"},
          {"shock speed", shock_, "m/s", "towards the gas at rest"},
          {"shock position", shock_at(t) + shift, "m", "in the gas"},
          {"interface position", interface_at(t) + shift, "m", "of gas and moving piston"},
          {"steel wave position", wave_at(t) + shift, "m", "in the moving piston"}};
}

}  // namespace brisance
