#include <algorithm>
#include <cmath>

#include "drivers/exact_piston_gas.hpp"

namespace brisance {
namespace {

/// Pressure of the gas, compression of the steel per layer of cells; places in the frame of the
/// gas.
struct Profiles {
  Profile gas, steel;
  double foremost_gas = 0, hindmost_steel = 0;  // of the moving piston [m]
  double worst = 0;                             // largest stress of a point there [Pa]
};

Profile profile_of(const ParticleTable& table, double shift) {
  const std::vector<Sums> layers = sums_per_layer(table, 0);
  Profile profile;
  for (int i = 0; i < table.cells[0]; ++i) {
    if (layers[i].empty()) continue;
    profile.where.push_back(table.layer_centre(0, i) - shift);
    profile.value.push_back(layers[i].mean_pressure());
  }
  return profile;
}

/// What lies at the ends is steel; the moving piston is what of it lies beyond `piston`.
Profiles profiles_of(const ParticleTable& table, double piston, double shift) {
  const auto* stress = table.field("stress xx");
  if (!stress)
    throw std::runtime_error("the piston of the exact solution is a solid, here is none");
  const int steel =
      table.material[std::max_element(table.x.begin(), table.x.end()) - table.x.begin()];
  ParticleTable gas = table, solid = table;
  Profiles p;
  p.foremost_gas = -1e300;
  p.hindmost_steel = 1e300;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double x = table.x[k] - shift;
    const bool is_steel = table.material[k] == steel;
    (is_steel ? gas : solid).volume[k] = 0;
    (is_steel ? gas : solid).mass[k] = 0;
    solid.pressure[k] = -(*stress)[k];
    if (!is_steel) {
      p.foremost_gas = std::max(p.foremost_gas, x);
    } else if (x > piston) {
      p.hindmost_steel = std::min(p.hindmost_steel, x);
      p.worst = std::max(p.worst, std::abs((*stress)[k]));
    }
  }
  p.gas = profile_of(gas, shift);
  p.steel = profile_of(solid, shift);
  return p;
}

struct Stretch {
  double mean = 0, error = 0;  // over the exact value [-]
};

Stretch over(const Profile& profile, double from, double to, double exact) {
  double sum = 0, error = 0, count = 0;
  for (std::size_t k = 0; k < profile.where.size(); ++k) {
    if (profile.where[k] <= from || profile.where[k] >= to) continue;
    sum += profile.value[k];
    error += std::abs(profile.value[k] - exact);
    count += 1;
  }
  return {relative(sum, count * exact), relative(error, count * exact)};
}

}  // namespace

std::vector<MeasureDoc> PistonGas::possible_measures() {
  return {
      {"post-shock pressure error", "-",
       "mean pressure of the cells from 4 behind the shock to 3 before the piston, over the "
       "exact one, less 1"},
      {"L1 post-shock pressure", "-", "error of the cells' pressure there, over the exact one"},
      {"shock position", "cells", "where half the pressure is passed, ahead of the exact one"},
      {"overshoot", "-", "largest pressure of a cell of gas over the exact one, less 1"},
      {"steel stress error", "-",
       "error of the cells' stress along x from 3 behind the piston's face to 5 before its "
       "wave, over the exact one"},
      {"worst steel point", "-",
       "largest stress of a particle of the moving piston, over the exact one"},
      {"interface pressure", "-", "of the 3 cells before the piston's face, over the exact one"},
      {"interface stress", "-",
       "compression of the 3 cells behind the piston's face, over the exact one"},
      {"interpenetration", "m",
       "way of the foremost gas beyond the piston's hindmost particle; negative: a gap"}};
}

std::vector<Measure> PistonGas::measures(const ParticleTable& table, double t) const {
  const double h = table.cell_size, shock = shock_at(t), face = interface_at(t);
  const Profiles p = profiles_of(table, 0.5 * (shock + face), data_.frame * t);
  Profile outward;  // mirrored, so that the shock is where the pressure falls last
  for (std::size_t k = p.gas.where.size(); k-- > 0;) {
    outward.where.push_back(-p.gas.where[k]);
    outward.value.push_back(p.gas.value[k]);
  }
  const double top =
      p.gas.value.empty() ? 0 : *std::max_element(p.gas.value.begin(), p.gas.value.end());
  const double found = last_fall(outward, 0.5 * p_, -data_.interface);
  const Stretch post = over(p.gas, shock + 4 * h, face - 3 * h, p_),
                near_gas = over(p.gas, face - 3 * h, face, p_),
                steel = over(p.steel, face + 3 * h, wave_at(t) - 5 * h, p_),
                near_steel = over(p.steel, face, face + 3 * h, p_);
  return with_values(possible_measures(),
                     {{"post-shock pressure error", post.mean - 1},
                      {"L1 post-shock pressure", post.error},
                      {"shock position", (found + shock) / h},
                      {"overshoot", top / p_ - 1},
                      {"steel stress error", steel.error},
                      {"worst steel point", p.worst / p_},
                      {"interface pressure", near_gas.mean},
                      {"interface stress", near_steel.mean},
                      {"interpenetration", p.foremost_gas - p.hindmost_steel}});
}

}  // namespace brisance
