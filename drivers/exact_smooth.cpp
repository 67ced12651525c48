// The answers without a shock: acoustic wave, isentropic vortex, and a gas where nothing happens.
#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "drivers/exact.hpp"
#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

constexpr double pi = 3.14159265358979323846;

void declare_gas(List& valid, const std::string& where) {
  declare<double>(valid, "density", 1, positive(), "density " + where + " [kg/m3]");
  declare<double>(valid, "pressure", 1, positive(), "pressure " + where + " [Pa]");
  declare_gamma(valid);
}

AcousticWave::Data acoustic_data(const List& list) {
  AcousticWave::Data data;
  data.amplitude = get<double>(list, "amplitude");
  data.wavelength = get<double>(list, "wavelength");
  data.density = get<double>(list, "density");
  data.pressure = get<double>(list, "pressure");
  data.velocity = get<double>(list, "velocity");
  data.gamma = get<double>(list, "gamma");
  data.direction = direction_of(list);
  return data;
}

Vortex::Data vortex_data(const List& list) {
  Vortex::Data data;
  data.strength = get<double>(list, "strength");
  data.radius = get<double>(list, "radius");
  data.box_length = get<double>(list, "box length");
  data.density = get<double>(list, "density");
  data.pressure = get<double>(list, "pressure");
  data.gamma = get<double>(list, "gamma");
  data.centre = place_of(list, "centre");
  data.velocity = place_of(list, "velocity");
  return data;
}

Uniform::Data uniform_data(const List& list) {
  Uniform::Data data;
  data.density = get<double>(list, "density");
  data.pressure = get<double>(list, "pressure");
  data.gamma = get<double>(list, "gamma");
  data.velocity = place_of(list, "velocity");
  return data;
}

// The deepest the temperature of a vortex falls, as a fraction of that far away.
double deficit(const Vortex::Data& d) {
  return (d.gamma - 1) * d.strength * d.strength / (8 * d.gamma * pi * pi);
}

}  // namespace

List AcousticWave::valid_parameters() {
  List valid = list_for_solution("acoustic wave");
  declare<double>(valid, "amplitude", 1e-4, above(0) && below(1),
                  "of the density, as a fraction of the mean [-]");
  declare<double>(valid, "wavelength", 1, positive(),
                  "length of one wave; the periodic box holds a whole number of them [m]");
  declare_gas(valid, "of the undisturbed gas");
  declare<double>(valid, "velocity", 0, anything(), "of the undisturbed gas [m/s]");
  declare_direction(valid);
  return valid;
}

AcousticWave::AcousticWave(const List& list) : AcousticWave(acoustic_data(list)) {}

double AcousticWave::sound_speed() const {
  return std::sqrt(data_.gamma * data_.pressure / data_.density);
}

MatterState AcousticWave::at(const Place& x, double t) const {
  const double c = sound_speed();
  const double from_crest = x[data_.direction] - (data_.velocity + c) * t;
  const double s = data_.amplitude * std::sin(2 * pi * from_crest / data_.wavelength);
  MatterState gas;
  gas.rho = data_.density * (1 + s);
  gas.p = data_.pressure * std::pow(1 + s, data_.gamma);
  gas.e = gas.p / ((data_.gamma - 1) * gas.rho);
  gas.v[data_.direction] = data_.velocity + c * s;
  return gas;
}

std::vector<Measure> AcousticWave::features(double) const {
  const double c = sound_speed();
  return {{"sound speed", c, "m/s", "of the undisturbed gas"},
          {"period", data_.wavelength / std::abs(data_.velocity + c), "s",
           "after which everything is as it was"},
          {"velocity amplitude", c * data_.amplitude, "m/s", "of the wave"}};
}

List Vortex::valid_parameters() {
  List valid = list_for_solution("vortex");
  declare<double>(valid, "strength", 5, anything(),
                  "swirl at the radius times 2 pi, in units of sqrt(pressure / density) [-]");
  declare<double>(valid, "radius", 1, positive(), "where the gas turns fastest [m]");
  declare<double>(valid, "box length", 10, positive(), "period in both directions [m]");
  declare_gas(valid, "far away");
  declare_centre(valid, {5, 5});
  declare<std::vector<double>>(valid, "velocity", {0, 0}, anything(), "far away [m/s]");
  return valid;
}

Vortex::Vortex(const List& list) : Vortex(vortex_data(list)) {}

Vortex::Vortex(const Data& data) : data_(data) {
  if (!(deficit(data) * std::exp(1.) < 1))
    throw InputError("exact", "strength", "",
                     "must be so small that a pressure is left at the centre");
}

MatterState Vortex::at(const Place& x, double t) const {
  std::array<double, 2> from{};  // the nearest image of the centre, in radii
  for (int d = 0; d < 2; ++d) {
    const double r = x[d] - data_.centre[d] - data_.velocity[d] * t;
    from[d] = (r - data_.box_length * std::round(r / data_.box_length)) / data_.radius;
  }
  const double rest = 1 - from[0] * from[0] - from[1] * from[1];
  const double unit = std::sqrt(data_.pressure / data_.density);
  const double turn = unit * data_.strength / (2 * pi) * std::exp(0.5 * rest);
  const double temperature = 1 - deficit(data_) * std::exp(rest);
  MatterState gas;
  gas.rho = data_.density * std::pow(temperature, 1 / (data_.gamma - 1));
  gas.p = data_.pressure * std::pow(temperature, data_.gamma / (data_.gamma - 1));
  gas.e = gas.p / ((data_.gamma - 1) * gas.rho);
  gas.v = data_.velocity;
  gas.v[0] -= turn * from[1];
  gas.v[1] += turn * from[0];
  return gas;
}

std::vector<Measure> Vortex::features(double) const {
  const double unit = std::sqrt(data_.pressure / data_.density);
  const double coldest = 1 - deficit(data_) * std::exp(1.);
  return {{"largest swirl", unit * std::abs(data_.strength) / (2 * pi), "m/s", "at the radius"},
          {"central density", data_.density * std::pow(coldest, 1 / (data_.gamma - 1)), "kg/m3",
           "the lowest"},
          {"central pressure", data_.pressure * std::pow(coldest, data_.gamma / (data_.gamma - 1)),
           "Pa", "the lowest"}};
}

List Uniform::valid_parameters() {
  List valid = list_for_solution("uniform");
  declare_gas(valid, "everywhere");
  declare<std::vector<double>>(valid, "velocity", {0}, anything(), "everywhere [m/s]");
  return valid;
}

Uniform::Uniform(const List& list) : Uniform(uniform_data(list)) {}

MatterState Uniform::at(const Place&, double) const {
  return {data_.density, data_.pressure, data_.pressure / ((data_.gamma - 1) * data_.density),
          data_.velocity};
}

std::vector<Measure> Uniform::features(double) const {
  return {{"sound speed", std::sqrt(data_.gamma * data_.pressure / data_.density), "m/s",
           "everywhere"}};
}

}  // namespace brisance
