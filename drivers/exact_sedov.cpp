#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/exact.hpp"
#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

// With r = R x, u = D x w, rho = rho0 g, p = rho0 D^2 q, D = dR/dt ~ R^(-j/2), the conservation
// laws become equations in l = ln x alone. The energy integral (Landau & Lifshitz, Fluid Mechanics,
// section 106) ties q / g to w and makes the inward integration stable: any error in w dies out as
// w -> 1 / gamma.
struct Slopes {
  double w, log_g, log_p;
};

Slopes slopes(double w, double gamma, int j) {
  const double lag = w - 1;                                                     // < 0
  const double g_by_q = 2 * (gamma * w - 1) / ((gamma - 1) * w * w * (1 - w));  // x^2 g / q
  const double spread = (j - 1) * w;
  const double strain =  // du/dr in units of D / R
      (0.5 * j * w * lag * g_by_q - j + gamma * spread) / (lag * lag * g_by_q - gamma);
  const double log_g = -(strain + spread) / lag;
  return {strain - w, log_g, j / lag + gamma * log_g};
}

double content(double log_g, double log_p, double w, double x, double gamma, int j, bool all) {
  const double u = x * w, kinetic = 0.5 * std::exp(log_g) * u * u;
  return (all ? kinetic + std::exp(log_p) / (gamma - 1) : kinetic) * std::pow(x, j);
}

constexpr double pi = 3.14159265358979323846;
constexpr int intervals = 20000;    // even, for Simpson's rule
constexpr double innermost = 1e-3;  // below it the limits for x -> 0 hold to all digits shown

Sedov::Data data_of(const List& list) {
  Sedov::Data data;
  const std::string symmetry = get<std::string>(list, "symmetry");
  data.symmetry = symmetry == "planar" ? 1 : symmetry == "cylindrical" ? 2 : 3;
  data.energy = get<double>(list, "energy");
  data.density = get<double>(list, "density");
  data.pressure = get<double>(list, "pressure");
  data.gamma = get<double>(list, "gamma");
  data.centre = place_of(list, "centre");
  return data;
}

}  // namespace

List Sedov::valid_parameters() {
  List valid = list_for_solution("sedov");
  declare(valid, "symmetry", "cylindrical", one_of({"planar", "cylindrical", "spherical"}),
          "the shape of the source: a plane, a line, a point [-]");
  declare_required<double>(
      valid, "energy", positive(),
      "energy released in the whole of space: J/m2 of a planar blast, J/m of a "
      "cylindrical, J of a spherical one [J]");
  declare_required<double>(valid, "density", positive(), "density of the gas at rest [kg/m3]");
  declare<double>(valid, "pressure", 0, at_least_zero(),
                  "pressure of the gas at rest, taken as nothing against the blast [Pa]");
  declare_required<double>(valid, "gamma", above(1) && below(7),
                           "ratio of specific heats, that of the material; from 7 on a spherical "
                           "blast is hollow [-]");
  declare_centre(valid, {0, 0});
  return valid;
}

Sedov::Sedov(const List& list) : Sedov(data_of(list)) {}

Sedov::Sedov(const Data& data) : data_(data) {
  if (!(data.gamma > 1 && data.gamma < 7))
    throw InputError("exact", "gamma", "", "must be > 1 and < 7");
  if (!(data.energy > 0)) throw InputError("exact", "energy", "", "must be > 0");
  if (!(data.density > 0)) throw InputError("exact", "density", "", "must be > 0");
  integrate();
}

void Sedov::integrate() {
  const double g = data_.gamma;
  const int j = data_.symmetry;
  step_ = std::log(innermost) / intervals;
  double w = 2 / (g + 1), log_g = std::log((g + 1) / (g - 1)), log_p = std::log(2 / (g + 1));
  double all = 0, kinetic = 0;
  for (int i = 0; i <= intervals; ++i) {
    log_g_.push_back(log_g);
    slope_.push_back(w);
    log_p_.push_back(log_p);
    const double x = std::exp(i * step_);
    const double simpson = (i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2) * -step_ / 3;
    all += simpson * content(log_g, log_p, w, x, g, j, true);
    kinetic += simpson * content(log_g, log_p, w, x, g, j, false);
    // Runge-Kutta of fourth order; only w feeds back.
    const Slopes a = slopes(w, g, j), b = slopes(w + 0.5 * step_ * a.w, g, j),
                 c = slopes(w + 0.5 * step_ * b.w, g, j), d = slopes(w + step_ * c.w, g, j);
    w += step_ / 6 * (a.w + 2 * b.w + 2 * c.w + d.w);
    log_g += step_ / 6 * (a.log_g + 2 * b.log_g + 2 * c.log_g + d.log_g);
    log_p += step_ / 6 * (a.log_p + 2 * b.log_p + 2 * c.log_p + d.log_p);
  }
  all +=
      std::exp(log_p_.back()) / (g - 1) * std::pow(innermost, j) / j;  // the core is all pressure
  const double around = j == 1 ? 2 : j == 2 ? 2 * pi : 4 * pi;
  alpha_ = around * all * 4 / ((j + 2.) * (j + 2.));  // D = 2 / (j + 2) R / t
  kinetic_share_ = kinetic / all;
}

Sedov::Fractions Sedov::profile(double fraction_of_radius) const {
  const double x = fraction_of_radius, g = data_.gamma, w2 = 2 / (g + 1);
  if (x <= innermost) {  // rho ~ x^(j / (gamma - 1)), u = r D / (gamma R), p constant
    const double rho = std::exp(log_g_.back() - log_g_.front()) *
                       std::pow(std::max(0., x) / innermost, data_.symmetry / (g - 1));
    return {rho, x / g / w2, std::exp(log_p_.back() - log_p_.front())};
  }
  const double at = std::max(0., std::log(x) / step_);
  const int i = std::min(static_cast<int>(at), intervals - 1);
  const auto between = [&](const std::vector<double>& table) {
    return table[i] + (at - i) * (table[i + 1] - table[i]);
  };
  return {std::exp(between(log_g_) - log_g_.front()), x * between(slope_) / w2,
          std::exp(between(log_p_) - log_p_.front())};
}

double Sedov::radius(double t) const {
  return std::pow(data_.energy * t * t / (alpha_ * data_.density), 1. / (data_.symmetry + 2));
}

double Sedov::front_speed(double t) const { return 2. / (data_.symmetry + 2) * radius(t) / t; }

double Sedov::peak_pressure(double t) const {
  const double d = front_speed(t);
  return 2 / (data_.gamma + 1) * data_.density * d * d;
}

double Sedov::central_pressure(double t) const { return peak_pressure(t) * profile(0).p; }

double Sedov::distance(const Place& x) const {
  double square = 0;
  for (int d = 0; d < data_.symmetry; ++d)
    square += (x[d] - data_.centre[d]) * (x[d] - data_.centre[d]);
  return std::sqrt(square);
}

MatterState Sedov::at(const Place& x, double t) const {
  MatterState gas;
  const double r = distance(x), g = data_.gamma, front = t > 0 ? radius(t) : 0;
  if (r >= front) {
    gas.rho = data_.density;
    gas.p = data_.pressure;
    gas.e = gas.p / ((g - 1) * gas.rho);
    return gas;
  }
  const Fractions f = profile(r / front);
  gas.rho = f.rho * (g + 1) / (g - 1) * data_.density;
  gas.p = f.p * peak_pressure(t);
  gas.e = gas.p / ((g - 1) * std::max(gas.rho, 1e-30 * data_.density));
  const double speed = f.u * 2 / (g + 1) * front_speed(t);
  for (int d = 0; d < data_.symmetry && r > 0; ++d) gas.v[d] = speed * (x[d] - data_.centre[d]) / r;
  return gas;
}

std::vector<Measure> Sedov::features(double t) const {
  const double g = data_.gamma;
  return {{"alpha", alpha_, "-", "energy time^2 / (density radius^(j + 2))"},
          {"front radius", radius(t), "m", "where the shock is"},
          {"front speed", front_speed(t), "m/s", "of the shock"},
          {"peak pressure", peak_pressure(t), "Pa", "just behind the shock"},
          {"peak density", (g + 1) / (g - 1) * data_.density, "kg/m3", "just behind the shock"},
          {"peak velocity", 2 / (g + 1) * front_speed(t), "m/s", "just behind the shock"},
          {"central pressure", central_pressure(t), "Pa", "the plateau around the centre"},
          {"kinetic share", kinetic_share_, "-", "of the energy"}};
}

}  // namespace brisance
