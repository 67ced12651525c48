#include "drivers/exact_solid.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

double PlateMatter::wave_speed() const { return std::sqrt(constrained() / density); }
double PlateMatter::plastic_speed() const { return std::sqrt(bulk() / density); }

MatterState PlateMatter::elastic_state(double stress, double velocity) const {
  MatterState s;
  s.rho = density * (1 - stress / constrained());
  s.p = -stress * bulk() / constrained();
  s.e = 0.5 * stress * stress / (constrained() * density);
  s.v[0] = velocity;
  return s;
}

void declare_plate(List& valid) {
  declare_required<double>(valid, "density", positive(), "that of the material [kg/m^3]");
  declare_required<double>(valid, "Young's modulus", positive(), "that of the material [Pa]");
  declare_required<double>(valid, "Poisson's ratio", above(-1) && below(0.5),
                           "that of the material [-]");
}

PlateMatter plate_of(const List& list) {
  return {get<double>(list, "density"), get<double>(list, "Young's modulus"),
          get<double>(list, "Poisson's ratio")};
}

List StandingWave::valid_parameters() {
  List valid = list_for_solution("standing wave");
  declare_plate(valid);
  declare(valid, "origin", 0.0, anything(), "where the wall is [m]");
  declare_required<double>(valid, "length", positive(), "from the wall to the free end [m]");
  declare_required<double>(valid, "velocity", positive(), "of the free end at first [m/s]");
  return valid;
}

StandingWave::StandingWave(const List& list)
    : data_{plate_of(list), get<double>(list, "origin"), get<double>(list, "length"),
            get<double>(list, "velocity")} {}

double StandingWave::wave_number() const { return pi / (2 * data_.length); }
double StandingWave::period() const { return 2 * pi / (wave_number() * data_.matter.wave_speed()); }

MatterState StandingWave::at(const Place& x, double t) const {
  const double c = data_.matter.wave_speed(), along = wave_number() * (x[0] - data_.origin),
               phase = wave_number() * c * t;
  const double stress =
      data_.matter.density * c * data_.velocity * std::cos(along) * std::sin(phase);
  return data_.matter.elastic_state(stress, data_.velocity * std::sin(along) * std::cos(phase));
}

std::vector<Measure> StandingWave::features(double) const {
  return {{"period", period(), "s", "after which everything is as it was"},
          {"wave speed", data_.matter.wave_speed(), "m/s", "of elastic waves"}};
}

List PlateImpact::valid_parameters() {
  List valid = list_for_solution("plate impact");
  declare_plate(valid);
  declare_required<double>(valid, "low", anything(), "lower end of the plate [m]");
  declare_required<double>(valid, "high", anything(), "upper end of the plate [m]");
  declare_required<double>(valid, "moving from", anything(), "where the moving part begins [m]");
  declare_required<double>(valid, "moving to", anything(), "where it ends [m]");
  declare_required<double>(valid, "velocity", positive(), "of the moving part at first [m/s]");
  return valid;
}

PlateImpact::PlateImpact(const List& list)
    : data_{plate_of(list),
            get<double>(list, "low"),
            get<double>(list, "high"),
            get<double>(list, "moving from"),
            get<double>(list, "moving to"),
            get<double>(list, "velocity")} {
  if (!(data_.low < data_.high)) refuse(list, "high", "must be above 'low'");
}

// Free ends mirror velocities: even about both, with twice the length as period.
double PlateImpact::initial_velocity(double x) const {
  const double length = data_.high - data_.low;
  double from_low = std::fabs(std::remainder(x - data_.low, 2 * length));
  const double place = data_.low + from_low;
  return place >= data_.moving_from && place < data_.moving_to ? data_.velocity : 0;
}

double PlateImpact::plateau() const {
  return 0.5 * data_.matter.density * data_.matter.wave_speed() * data_.velocity;
}

double PlateImpact::stress(double x, double t) const {
  const double way = data_.matter.wave_speed() * t;
  return plateau() / data_.velocity * (initial_velocity(x + way) - initial_velocity(x - way));
}

MatterState PlateImpact::at(const Place& x, double t) const {
  const double way = data_.matter.wave_speed() * t;
  const double v = 0.5 * (initial_velocity(x[0] + way) + initial_velocity(x[0] - way));
  return data_.matter.elastic_state(stress(x[0], t), v);
}

std::vector<Measure> PlateImpact::features(double) const {
  return {{"wave speed", data_.matter.wave_speed(), "m/s", "of elastic waves"},
          {"plateau", plateau(), "Pa", "stress of the waves, compression and tension"}};
}

List PlasticWave::valid_parameters() {
  List valid = list_for_solution("plastic wave");
  declare_plate(valid);
  declare_required<double>(valid, "yield stress", positive(), "that of the material [Pa]");
  declare_required<double>(valid, "velocity", positive(), "towards the wall [m/s]");
  declare(valid, "origin", 0.0, anything(), "where the wall is [m]");
  return valid;
}

PlasticWave::PlasticWave(const Data& data) : data_(data) {
  if (!(data_.velocity > elastic_jump()))
    throw InputError("exact", "velocity", "", "must be so high that the plate yields");
}
PlasticWave::PlasticWave(const List& list)
    : PlasticWave({plate_of(list), get<double>(list, "yield stress"), get<double>(list, "velocity"),
                   get<double>(list, "origin")}) {}

double PlasticWave::elastic_limit() const {
  const double nu = data_.matter.poisson;
  return data_.yield * (1 - nu) / (1 - 2 * nu);
}
double PlasticWave::elastic_jump() const {
  return elastic_limit() / (data_.matter.density * data_.matter.wave_speed());
}
double PlasticWave::final_stress() const {
  return -elastic_limit() -
         data_.matter.density * data_.matter.plastic_speed() * (data_.velocity - elastic_jump());
}
double PlasticWave::precursor(double t) const {
  return data_.origin + (data_.matter.wave_speed() - data_.velocity) * t;
}
double PlasticWave::plastic_front(double t) const {
  const double strain = elastic_jump() / data_.matter.wave_speed() +
                        (data_.velocity - elastic_jump()) / data_.matter.plastic_speed();
  return data_.origin + data_.matter.plastic_speed() * (1 - strain) * t;
}

double PlasticWave::stress(double x, double t) const {
  if (x >= precursor(t)) return 0;
  return x >= plastic_front(t) ? -elastic_limit() : final_stress();
}

MatterState PlasticWave::at(const Place& x, double t) const {
  if (x[0] >= precursor(t)) return data_.matter.elastic_state(0, -data_.velocity);
  MatterState s = data_.matter.elastic_state(-elastic_limit(), -(data_.velocity - elastic_jump()));
  if (x[0] >= plastic_front(t)) return s;
  const double more = (data_.velocity - elastic_jump()) / data_.matter.plastic_speed();
  s.rho += data_.matter.density * more;
  s.p += data_.matter.bulk() * more;
  s.e = 0.5 * data_.velocity * data_.velocity;  // all that the matter had as it ran
  s.v[0] = 0;
  return s;
}

std::vector<Measure> PlasticWave::features(double) const {
  return {{"elastic limit", elastic_limit(), "Pa", "stress of the precursor"},
          {"final stress", -final_stress(), "Pa", "compression behind the plastic wave"},
          {"precursor speed", data_.matter.wave_speed(), "m/s", "of elastic waves"},
          {"plastic wave speed", data_.matter.plastic_speed(), "m/s", "of plastic waves"}};
}

}  // namespace brisance
