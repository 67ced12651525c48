#include <algorithm>
#include <cmath>

#include "drivers/exact_solid.hpp"

namespace brisance {
namespace {

constexpr double pi = 3.14159265358979323846;

const std::vector<double>& axial_stress(const ParticleTable& table) {
  const auto* stress = table.field("stress xx");
  if (!stress)
    throw std::runtime_error("the exact solution is that of a solid, the scene has none");
  return *stress;
}

/// Mean stress along x per layer of cells, as a profile along x.
Profile stress_profile(const ParticleTable& table) {
  const auto& stress = axial_stress(table);
  ParticleTable copy = table;
  copy.pressure = stress;
  const std::vector<Sums> layers = sums_per_layer(copy, 0);
  Profile profile;
  for (int i = 0; i < table.cells[0]; ++i) {
    if (layers[i].empty()) continue;
    profile.where.push_back(table.layer_centre(0, i));
    profile.value.push_back(layers[i].mean_pressure());
  }
  return profile;
}

struct Errors {
  double velocity = 0, stress = 0;
};

/// Relative L1 over the particles, by volume.
template <class Exact>
Errors particle_errors(const ParticleTable& table, const Exact& exact, double t) {
  const auto& stress = axial_stress(table);
  double v = 0, v_scale = 0, s = 0, s_scale = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double x = table.x[k], volume = table.volume[k];
    const double exact_v = exact.at({x, 0, 0}, t).v[0], exact_s = exact.stress(x, t);
    v += volume * std::abs(table.vx[k] - exact_v);
    v_scale += volume * std::abs(exact_v);
    s += volume * std::abs(stress[k] - exact_s);
    s_scale += volume * std::abs(exact_s);
  }
  return {relative(v, v_scale), relative(s, s_scale)};
}

const std::string by_volume = "error over the particles, weighted by volume, over the exact ";

}  // namespace

std::vector<MeasureDoc> StandingWave::possible_measures() {
  return {{"wave speed error", "-", "phase of the mode over the exact one, less 1"},
          {"amplitude error", "-", "amplitude of the mode over that at the start, less 1"}};
}

// The mode's share in velocity and stress: two numbers that go round a circle once in a period.
std::vector<Measure> StandingWave::measures(const ParticleTable& table, double t) const {
  const auto& stress = axial_stress(table);
  double v = 0, v_norm = 0, s = 0, s_norm = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double along = wave_number() * (table.x[k] - data_.origin);
    v += table.mass[k] * table.vx[k] * std::sin(along);
    v_norm += table.mass[k] * std::sin(along) * std::sin(along);
    s += table.volume[k] * stress[k] * std::cos(along);
    s_norm += table.volume[k] * std::cos(along) * std::cos(along);
  }
  const double c = data_.matter.wave_speed();
  v /= v_norm * data_.velocity;
  s /= s_norm * data_.velocity * c * data_.matter.density;
  const double exact = wave_number() * c * t;
  const double ahead = std::remainder(std::atan2(s, v) - exact, 2 * pi);
  return with_values(possible_measures(), {{"wave speed error", ahead / exact},
                                           {"amplitude error", std::hypot(v, s) - 1}});
}

std::vector<MeasureDoc> PlateImpact::possible_measures() {
  return {{"L1 velocity", "-", by_volume + "velocity"},
          {"L1 stress", "-", by_volume + "stress along x"},
          {"greatest tension", "-", "mean of a layer of cells, over the exact plateau"},
          {"tension front", "cells",
           "how far the side of the tension that lies towards the moving part is ahead of (+) its "
           "place, taken at half the plateau; 0 where there is no tension in the exact solution"}};
}

std::vector<Measure> PlateImpact::measures(const ParticleTable& table, double t) const {
  const Errors error = particle_errors(table, *this, t);
  const Profile profile = stress_profile(table);
  const double top =
      profile.value.empty() ? 0 : *std::max_element(profile.value.begin(), profile.value.end());
  // Towards -x: mirrored, so that the front is where the profile falls last.
  const auto front = [](const Profile& p, double level) {
    Profile outward;
    for (std::size_t k = p.where.size(); k-- > 0;) {
      outward.where.push_back(-p.where[k]);
      outward.value.push_back(p.value[k]);
    }
    return last_fall(outward, level, 0);
  };
  Profile exact;
  const int points = 20 * table.cells[0];
  for (int k = 0; k < points; ++k) {
    exact.where.push_back(table.origin[0] + (k + 0.5) * table.cell_size / 20);
    const double x = exact.where.back();
    exact.value.push_back(x > data_.low && x < data_.high ? stress(x, t) : 0);
  }
  const double level = 0.5 * plateau(), place = front(exact, level);
  const double ahead = place == 0 ? 0 : (front(profile, level) - place) / table.cell_size;
  return with_values(possible_measures(), {{"L1 velocity", error.velocity},
                                           {"L1 stress", error.stress},
                                           {"greatest tension", top / plateau()},
                                           {"tension front", ahead}});
}

std::vector<MeasureDoc> PlasticWave::possible_measures() {
  return {{"L1 velocity", "-", by_volume + "velocity"},
          {"L1 stress", "-", by_volume + "stress along x"},
          {"precursor speed error", "-", "over the exact speed, where half the limit is passed"},
          {"plastic wave speed error", "-",
           "over the exact speed, half-way from the limit to the final stress"},
          {"elastic limit error", "-",
           "mean stress between the fronts, less a tenth at either end, over the exact one, less "
           "1"}};
}

std::vector<Measure> PlasticWave::measures(const ParticleTable& table, double t) const {
  const Errors error = particle_errors(table, *this, t);
  Profile compression = stress_profile(table);
  for (double& value : compression.value) value = -value;
  const double limit = elastic_limit(), elastic = last_fall(compression, 0.5 * limit, 0),
               plastic = last_fall(compression, 0.5 * (limit - final_stress()), 0);
  const auto speed_error = [&](double found, double exact) {
    return (found - exact) / (exact - data_.origin);
  };
  const double low = plastic_front(t), high = precursor(t), margin = 0.1 * (high - low);
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < compression.where.size(); ++k) {
    if (compression.where[k] < low + margin || compression.where[k] > high - margin) continue;
    sum += compression.value[k];
    ++count;
  }
  return with_values(possible_measures(),
                     {{"L1 velocity", error.velocity},
                      {"L1 stress", error.stress},
                      {"precursor speed error", speed_error(elastic, precursor(t))},
                      {"plastic wave speed error", speed_error(plastic, plastic_front(t))},
                      {"elastic limit error", relative(sum, count * limit) - 1}});
}

}  // namespace brisance
