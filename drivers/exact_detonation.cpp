#include "drivers/exact_detonation.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

constexpr std::array<const char*, 7> constants{"density",       "A", "B", "R1", "R2", "omega",
                                               "energy density"};

}  // namespace

void declare_products(List& valid) {
  const List material = Jwl::valid_parameters();
  for (const char* name : constants) {
    const Described d = described(material, name);
    declare_required<double>(valid, name, positive(), d.doc + " " + d.unit);
  }
}

Jwl products_of(const List& list) {
  List material;
  for (const char* name : constants) material.set(name, get<double>(list, name));
  material.set("detonation speed", 1.);  // no constant of the products
  return Jwl(check(material, Jwl::valid_parameters()));
}

List Detonation::valid_parameters() {
  List valid = list_for_solution("detonation");
  declare_products(valid);
  declare(valid, "wall", 0.0, anything(), "where the slab begins and is lit [m]");
  return valid;
}

Detonation::Detonation(const List& list)
    : Detonation(Data{products_of(list), get<double>(list, "wall")}) {}

// Simpson's rule in ln V; the last point is moved to where the products rest.
Detonation::Detonation(const Data& data)
    : data_(data), cj_(brisance::chapman_jouguet(data.products)) {
  const Jwl& j = data_.products;
  isentrope_ = (cj_.p - j.A * std::exp(-j.R1 * cj_.V) - j.B * std::exp(-j.R2 * cj_.V)) *
               std::pow(cj_.V, 1 + j.omega);
  const double step = 5e-4;
  Point now{cj_.u + sound_speed(cj_.V), cj_.V, cj_.u};
  fan_.push_back(now);
  while (now.u > 0) {
    const auto loss = [&](double share) {
      return share * step / 6 *
             (sound_speed(now.volume) + 4 * sound_speed(now.volume * std::exp(share * step / 2)) +
              sound_speed(now.volume * std::exp(share * step)));
    };
    double share = 1;
    for (int k = 0; k < 8 && loss(1) > now.u; ++k) share *= now.u / loss(share);
    const bool rests = share < 1;
    now.u = rests ? 0 : now.u - loss(share);
    now.volume *= std::exp(share * step);
    now.speed = now.u + sound_speed(now.volume);
    fan_.push_back(now);
  }
}

double Detonation::pressure(double V) const {
  const Jwl& j = data_.products;
  return j.A * std::exp(-j.R1 * V) + j.B * std::exp(-j.R2 * V) +
         isentrope_ * std::pow(V, -1 - j.omega);
}

double Detonation::energy(double V) const {
  const Jwl& j = data_.products;
  return (j.A / j.R1 * std::exp(-j.R1 * V) + j.B / j.R2 * std::exp(-j.R2 * V) +
          isentrope_ / j.omega * std::pow(V, -j.omega)) /
         j.rho0;
}

double Detonation::sound_speed(double V) const {
  return std::sqrt(data_.products.sound_speed2(data_.products.rho0 / V, energy(V)));
}

MatterState Detonation::products_at(const Point& point) const {
  MatterState s;
  s.rho = data_.products.rho0 / point.volume;
  s.p = pressure(point.volume);
  s.e = energy(point.volume);
  s.v[0] = point.u;
  return s;
}

MatterState Detonation::at(const Place& x, double t) const {
  const double way = x[0] - data_.wall;
  if (way >= cj_.D * t) {
    MatterState ahead;
    ahead.rho = data_.products.rho0;
    ahead.e = data_.products.energy0;
    return ahead;
  }
  if (way <= tail_speed() * t) return products_at(fan_.back());
  const double speed = way / t;
  const auto slower = std::find_if(fan_.begin() + 1, fan_.end() - 1,
                                   [&](const Point& p) { return p.speed <= speed; });
  const Point &a = *(slower - 1), &b = *slower;
  const double share = std::max(0., (a.speed - speed) / (a.speed - b.speed));
  return products_at({speed, a.volume + share * (b.volume - a.volume), a.u + share * (b.u - a.u)});
}

std::vector<Measure> Detonation::features(double t) const {
  return {{"detonation speed", cj_.D, "m/s", "of Chapman and Jouguet"},
          {"peak pressure", cj_.p, "Pa", "behind the front"},
          {"plateau", plateau(), "Pa", "pressure of the products at rest"},
          {"front position", data_.wall + cj_.D * t, "m", "of the detonation"},
          {"fan tail position", data_.wall + tail_speed() * t, "m", "where the products rest"}};
}

}  // namespace brisance
