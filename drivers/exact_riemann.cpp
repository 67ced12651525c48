#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/exact.hpp"
#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

// The velocity that a side loses when brought to pressure p, and its slope. Toro (4.6), (4.7) and
// (4.37), with a cold side (p_k = 0) as the limit.
struct Change {
  double value, slope;
};

Change change_to(double p, const Riemann::Side& side, double sound, double gamma) {
  if (p > side.p) {
    const double a = 2 / ((gamma + 1) * side.rho), b = (gamma - 1) / (gamma + 1) * side.p;
    const double q = std::sqrt(a / (p + b));
    return {(p - side.p) * q, q * (1 - (p - side.p) / (2 * (b + p)))};
  }
  const double ratio = p / side.p;
  return {2 * sound / (gamma - 1) * (std::pow(ratio, (gamma - 1) / (2 * gamma)) - 1),
          std::pow(ratio, -(gamma + 1) / (2 * gamma)) / (side.rho * sound)};
}

// The sum of both changes is increasing and concave in p (Toro 4.3.1), so Newton's method comes
// from the left without overshooting; a step from the right may land below 0 and is then cut short.
double star_pressure_of(const Riemann::Data& d, const std::array<double, 2>& sound) {
  const double du = d.right.u - d.left.u;
  const double highest = std::max(d.left.p, d.right.p);
  double p = highest + std::max(d.left.rho, d.right.rho) * du * du;
  for (int step = 0; step < 400; ++step) {
    const Change l = change_to(p, d.left, sound[0], d.gamma);
    const Change r = change_to(p, d.right, sound[1], d.gamma);
    const double next = std::max(p - (l.value + r.value + du) / (l.slope + r.slope), 1e-3 * p);
    const bool settled = std::abs(next - p) <= 1e-15 * p;
    p = next;
    if (settled) break;
  }
  return p;
}

// Both sides expand: closed form, exact however near to vacuum. Toro (4.46).
double two_fan_pressure(const Riemann::Data& d, const std::array<double, 2>& sound) {
  const double z = (d.gamma - 1) / (2 * d.gamma);
  const double spare = sound[0] + sound[1] - (d.gamma - 1) / 2 * (d.right.u - d.left.u);
  return std::pow(spare / (sound[0] / std::pow(d.left.p, z) + sound[1] / std::pow(d.right.p, z)),
                  1 / z);
}

void require_gas(const Riemann::Side& side, const std::string& name) {
  if (!(side.rho >= 0)) throw InputError("exact", name + " density", "", "must be >= 0");
  if (!(side.p >= 0)) throw InputError("exact", name + " pressure", "", "must be >= 0");
  if (side.rho == 0 && side.p > 0)
    throw InputError("exact", name + " pressure", "", "must be 0 where the density is 0");
}

Riemann::Data data_of(const List& list) {
  const auto side = [&](const std::string& name) {
    return Riemann::Side{get<double>(list, name + " density"),
                         get<double>(list, name + " velocity"),
                         get<double>(list, name + " pressure")};
  };
  Riemann::Data data{side("left"), side("right")};
  data.gamma = get<double>(list, "gamma");
  data.interface = get<double>(list, "interface");
  data.direction = direction_of(list);
  const auto region = get<std::vector<double>>(list, "measured region");
  if (!region.empty()) {
    if (region.size() != 2 || !(region[0] < region[1]))
      refuse(list, "measured region", "must be empty or low and high, low < high");
    data.measured_from = region[0];
    data.measured_to = region[1];
  }
  return data;
}

}  // namespace

List Riemann::valid_parameters() {
  List valid = list_for_solution("riemann");
  for (const std::string side : {"left", "right"}) {
    declare_required<double>(valid, side + " density", at_least_zero(),
                             "density on the " + side + "; 0: vacuum [kg/m3]");
    declare<double>(valid, side + " velocity", 0, anything(), "velocity on the " + side + " [m/s]");
    declare_required<double>(valid, side + " pressure", at_least_zero(),
                             "pressure on the " + side + "; 0: cold [Pa]");
  }
  declare_gamma(valid);
  declare_required<double>(valid, "interface", anything(),
                           "where the two states meet at the start [m]");
  declare_direction(valid);
  declare<std::vector<double>>(valid, "measured region", {}, anything(),
                               "low and high end of where errors are measured, for bodies that end "
                               "inside the grid; empty: the whole grid [m]");
  return valid;
}

Riemann::Riemann(const List& list) : Riemann(data_of(list)) {}

Riemann::Riemann(const Data& data) : data_(data) {
  if (!(data.gamma > 1)) throw InputError("exact", "gamma", "", "must be > 1");
  require_gas(data.left, "left");
  require_gas(data.right, "right");
  if (data.left.rho == 0 && data.right.rho == 0)
    throw InputError("exact", "left density", "0", "must be > 0 when there is vacuum on the right");
  for (int k = 0; k < 2; ++k)
    sound_[k] = side(k).rho > 0 ? std::sqrt(data.gamma * side(k).p / side(k).rho) : 0;
  find_star();
  for (int k = 0; k < 2; ++k) find_wave(k);
}

void Riemann::find_star() {
  const Side &l = data_.left, &r = data_.right;
  const double reach =
      2 / (data_.gamma - 1);  // a fan into vacuum reaches speed u +- reach a: Toro (4.76)
  vacuum_ = l.rho == 0 || r.rho == 0 || r.u - l.u >= reach * (sound_[0] + sound_[1]);
  if (vacuum_) {
    const double from_left = l.u + reach * sound_[0], from_right = r.u - reach * sound_[1];
    u_star_ = l.rho == 0 ? from_right : r.rho == 0 ? from_left : 0.5 * (from_left + from_right);
    return;
  }
  const double lowest = std::min(l.p, r.p);
  const auto lost = [&](int k, double p) {
    return change_to(p, side(k), sound_[k], data_.gamma).value;
  };
  const bool both_expand = lowest > 0 && lost(0, lowest) + lost(1, lowest) + r.u - l.u > 0;
  p_star_ = both_expand ? two_fan_pressure(data_, sound_) : star_pressure_of(data_, sound_);
  u_star_ = 0.5 * (l.u + r.u) + 0.5 * (lost(1, p_star_) - lost(0, p_star_));
}

void Riemann::find_wave(int k) {
  const Side& s = side(k);
  Wave& w = wave_[k];
  if (s.rho == 0) {
    w.head = w.tail = w.u = u_star_;
    return;
  }
  const double sign = k == 0 ? -1 : 1, g = data_.gamma;
  w.head = w.tail = s.u + sign * sound_[k];
  w.u = s.u;
  w.rho = s.rho;
  if (!vacuum_ && std::abs(p_star_ - s.p) <= 1e-12 * s.p) return;  // rounding, not a wave
  if (p_star_ > s.p) {  // Toro (4.50) to (4.52), (4.57) to (4.59), through the mass flux
    w.kind = Wave::Kind::shock;
    w.head = w.tail = s.u + sign * std::sqrt(((g + 1) * p_star_ + (g - 1) * s.p) / (2 * s.rho));
    w.rho = s.rho * ((g + 1) * p_star_ + (g - 1) * s.p) / ((g - 1) * p_star_ + (g + 1) * s.p);
    w.u = u_star_;
  } else if (s.p > 0) {
    w.kind = Wave::Kind::fan;
    w.u = vacuum_ ? s.u - sign * 2 / (g - 1) * sound_[k] : u_star_;
    w.tail =
        vacuum_ ? w.u : u_star_ + sign * sound_[k] * std::pow(p_star_ / s.p, (g - 1) / (2 * g));
    w.rho = vacuum_ ? 0 : s.rho * std::pow(p_star_ / s.p, 1 / g);
  }
}

Riemann::Side Riemann::sample(double speed) const {
  if (vacuum_) {  // Toro 4.6: the vacuum lies between the two tails
    const bool left = data_.left.rho > 0 && speed < wave_[0].tail;
    const bool right = data_.right.rho > 0 && speed > wave_[1].tail;
    if (!left && !right) return {0, 0, 0};
    return sample_side(left ? 0 : 1, speed);
  }
  return sample_side(speed <= u_star_ ? 0 : 1, speed);
}

Riemann::Side Riemann::sample_side(int k, double speed) const {
  const Side& s = side(k);
  const Wave& w = wave_[k];
  const double sign = k == 0 ? -1 : 1, g = data_.gamma;
  if (sign * speed >= sign * w.head) return s;
  if (w.kind != Wave::Kind::fan || sign * speed <= sign * w.tail)
    return w.kind == Wave::Kind::nothing ? s : Side{w.rho, w.u, p_star_};
  // Toro (4.56), (4.63)
  const double u = 2 / (g + 1) * (-sign * sound_[k] + (g - 1) / 2 * s.u + speed);
  const double sound = 2 / (g + 1) * (sound_[k] - sign * (g - 1) / 2 * (s.u - speed));
  const double ratio = std::max(0., sound / sound_[k]);
  return {s.rho * std::pow(ratio, 2 / (g - 1)), u, s.p * std::pow(ratio, 2 * g / (g - 1))};
}

MatterState Riemann::at(const Place& x, double t) const {
  const double from_interface = x[data_.direction] - data_.interface;
  const Side s = t > 0 ? sample(from_interface / t) : from_interface < 0 ? data_.left : data_.right;
  MatterState gas;
  if (!(s.rho > 0)) return gas;
  gas.rho = s.rho;
  gas.p = s.p;
  gas.e = s.p / ((data_.gamma - 1) * s.rho);
  gas.v[data_.direction] = s.u;
  return gas;
}

std::vector<Measure> Riemann::features(double t) const {
  std::vector<Measure> list;
  if (!vacuum_) {
    list.push_back({"star pressure", p_star_, "Pa", "between the waves"});
    list.push_back({"star velocity", u_star_, "m/s", "between the waves"});
    list.push_back({"left star density", wave_[0].rho, "kg/m3", "left of the contact"});
    list.push_back({"right star density", wave_[1].rho, "kg/m3", "right of the contact"});
    list.push_back({"contact position", position(u_star_, t), "m", "where the two gases meet"});
  }
  for (int k = 0; k < 2; ++k) {
    const std::string name = k == 0 ? "left" : "right";
    const Wave& w = wave_[k];
    if (w.kind == Wave::Kind::shock) {
      list.push_back({name + " shock speed", w.head, "m/s", "in the frame of the tube"});
      list.push_back({name + " shock position", position(w.head, t), "m", "where the shock is"});
      if (sound_[k] > 0)
        list.push_back({name + " shock Mach number", std::abs(w.head - side(k).u) / sound_[k], "-",
                        "relative to the gas ahead"});
    } else if (w.kind == Wave::Kind::fan) {
      list.push_back(
          {name + " fan head position", position(w.head, t), "m", "outer edge of the fan"});
      list.push_back(
          {name + " fan tail position", position(w.tail, t), "m",
           vacuum_ ? "inner edge of the fan, where vacuum begins" : "inner edge of the fan"});
    }
  }
  return list;
}

}  // namespace brisance
