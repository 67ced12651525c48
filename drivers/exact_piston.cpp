#include "drivers/exact_piston.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/exact_parameters.hpp"
#include "drivers/ledger.hpp"

namespace brisance {
namespace {

constexpr double pi = 3.14159265358979323846;

}  // namespace

PistonContainer::PistonContainer(const Data& data) : data_(data), frequency_(first_mode()) {}

PistonContainer::PistonContainer(const List& list)
    : PistonContainer(Data{get<double>(list, "stiffness"), get<double>(list, "piston mass"),
                           get<double>(list, "spring mass"), get<double>(list, "length"),
                           get<double>(list, "density"), get<double>(list, "bulk modulus"),
                           get<double>(list, "velocity"), get<std::string>(list, "piston")}) {}

List PistonContainer::valid_parameters() {
  List valid = list_for_solution("piston container");
  declare_required<std::string>(valid, "piston", anything(), "name of the piston's material [-]");
  declare_required<double>(valid, "stiffness", positive(), "of the spring, by area [N/m^3]");
  declare_required<double>(valid, "piston mass", positive(), "by area [kg/m^2]");
  declare(valid, "spring mass", 0.0, at_least_zero(), "by area [kg/m^2]");
  declare_required<double>(valid, "length", positive(), "of the liquid, from x = 0 [m]");
  declare_required<double>(valid, "density", positive(), "that of the liquid [kg/m^3]");
  declare_required<double>(valid, "bulk modulus", positive(), "that of the liquid [Pa]");
  declare_required<double>(valid, "velocity", positive(), "of the piston at first [m/s]");
  return valid;
}

double PistonContainer::sound_speed() const { return std::sqrt(data_.modulus / data_.density); }
double PistonContainer::period() const { return 2 * pi / frequency_; }

/// Inertia beyond what spring and liquid give back; it grows from -infinity to infinity between the
/// poles of the cotangents.
double PistonContainer::excess(double w, bool massless) const {
  const double c = sound_speed(), K = data_.stiffness, ms = data_.spring_mass;
  const double spring = massless ? K : std::sqrt(K * ms) * w / std::tan(w * std::sqrt(ms / K));
  return data_.piston_mass * w * w - spring -
         data_.density * c * w / std::tan(w * data_.length / c);
}

double PistonContainer::root_between(double low, double high, bool massless) const {
  for (int round = 0; round < 200; ++round) {
    const double middle = 0.5 * (low + high);
    (excess(middle, massless) > 0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

double PistonContainer::first_mode() const {
  const double end = pi * sound_speed() / data_.length;
  const double massless = root_between(0, end, true);
  if (!(data_.spring_mass > 0)) return massless;
  const double between = pi * std::sqrt(data_.stiffness / data_.spring_mass);
  const double poles = std::floor(massless / between);
  double nearest = root_between(poles * between, std::min((poles + 1) * between, end), false);
  for (const double n : {poles - 1, poles + 1}) {
    if (n < 0 || n * between >= end) continue;
    const double root = root_between(n * between, std::min((n + 1) * between, end), false);
    if (std::abs(root - massless) < std::abs(nearest - massless)) nearest = root;
  }
  return nearest;
}

MatterState PistonContainer::at(const Place& x, double t) const {
  const double k = frequency_ / sound_speed(), L = data_.length, along = std::min(x[0], L);
  const double u = data_.velocity / frequency_ * std::sin(frequency_ * t),
               strain = u * k * std::cos(k * along) / std::sin(k * L);
  MatterState s;
  s.p = -data_.modulus * strain;
  s.rho = data_.density * std::exp(-strain);
  s.e = 0.5 * data_.modulus / data_.density * strain * strain;
  s.v[0] = data_.velocity * std::cos(frequency_ * t) * std::sin(k * along) / std::sin(k * L);
  return s;
}

std::vector<Measure> PistonContainer::features(double) const {
  return {{"exact period", period(), "s", "of the first mode"},
          {"exact amplitude", data_.velocity / frequency_, "m",
           "of the piston, if all of it moves in the first mode"}};
}

std::vector<MeasureDoc> PistonContainer::possible_measures() {
  return {
      {"period", "s", "of the piston's displacement, fitted to all its passages"},
      {"period error", "-", "the same over the exact one, less 1"},
      {"amplitude", "m", "half the way between the piston's turning points"},
      {"velocity drift", "-",
       "change of the piston's mean square velocity, as a root, from the first to the last five "
       "periods"},
      {"place drift", "-", "change of the piston's mean place, the same, over the amplitude"}};
}

void PistonContainer::record(const Balance& now) {
  for (const auto& m : now.materials)
    if (m.name == data_.piston) motion_.add(now.time, m.totals.momentum[0] / m.totals.mass);
}

void PistonContainer::keep(Archive& archive) {
  const Archive::Part part(archive, "motion");
  motion_.keep(archive);
}

std::vector<Measure> PistonContainer::measures(const ParticleTable&, double) const {
  return with_values(possible_measures(), {{"period", motion_.period()},
                                           {"period error", motion_.period() / period() - 1},
                                           {"amplitude", motion_.amplitude()},
                                           {"velocity drift", motion_.velocity_drift()},
                                           {"place drift", motion_.place_drift()}});
}

}  // namespace brisance
