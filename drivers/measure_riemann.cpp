#include <algorithm>
#include <cmath>

#include "drivers/exact.hpp"

namespace brisance {
namespace {

struct Cells {
  double density = 0, velocity = 0, pressure = 0, energy = 0;
};

// What a perfect scheme would have in each layer of cells across the direction: density and
// pressure by volume, velocity and energy by mass, from 20 points in each.
std::vector<MatterState> exact_layers(const Riemann& exact, const ParticleTable& table,
                                      int direction, double t) {
  constexpr int points = 20;
  std::vector<MatterState> layers(table.cells[direction]);
  for (int i = 0; i < table.cells[direction]; ++i) {
    MatterState& mean = layers[i];
    for (int s = 0; s < points; ++s) {
      Place x{};
      x[direction] = table.origin[direction] + (i + (s + 0.5) / points) * table.cell_size;
      const MatterState gas = exact.at(x, t);
      mean.rho += gas.rho / points;
      mean.p += gas.p / points;
      mean.e += gas.rho * gas.e / points;
      mean.v[direction] += gas.rho * gas.v[direction] / points;
    }
    if (!(mean.rho > 0)) continue;
    mean.e /= mean.rho;
    mean.v[direction] /= mean.rho;
  }
  return layers;
}

// The relative L1 errors over the measured cells that hold matter in the exact solution: in vacuum
// velocity and energy have no meaning. A cell without particles counts as wholly wrong.
Cells cell_errors(const ParticleTable& table, const std::vector<MatterState>& layers,
                  const std::vector<char>& measured, int direction) {
  const std::vector<Sums> cells = sums_per_cell(table);
  int stride = 1;
  for (int d = 0; d < direction; ++d) stride *= table.cells[d];
  Cells error, scale;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::size_t layer = c / stride % table.cells[direction];
    const MatterState& exact = layers[layer];
    if (!measured[layer] || !(exact.rho > 0)) continue;
    const double speed = std::abs(exact.v[direction]);
    scale.density += exact.rho;
    scale.velocity += speed;
    scale.pressure += exact.p;
    scale.energy += exact.e;
    if (cells[c].empty()) {
      error.density += exact.rho;
      error.velocity += speed;
      error.pressure += exact.p;
      error.energy += exact.e;
      continue;
    }
    const auto v = cells[c].mean_velocity();
    error.density += std::abs(cells[c].mean_density() - exact.rho);
    error.velocity += std::hypot(v[0] - exact.v[0], v[1] - exact.v[1], v[2] - exact.v[2]);
    error.pressure += std::abs(cells[c].mean_pressure() - exact.p);
    error.energy += std::abs(cells[c].mean_energy() - exact.e);
  }
  return {relative(error.density, scale.density), relative(error.velocity, scale.velocity),
          relative(error.pressure, scale.pressure), relative(error.energy, scale.energy)};
}

// Root mean square of what is left of `deviation` when its running mean over 1.5 cells to either
// side is taken off: the mean is the rounding of the fan's edges, the rest is noise from particle
// to particle.
double roughness(std::vector<std::pair<double, double>> deviation, double half_width) {
  std::sort(deviation.begin(), deviation.end());
  const std::size_t n = deviation.size();
  std::size_t low = 0, high = 0;
  double sum = 0, square = 0;
  for (const auto& [place, value] : deviation) {
    while (high < n && deviation[high].first < place + half_width) sum += deviation[high++].second;
    while (deviation[low].first < place - half_width) sum -= deviation[low++].second;
    const double rest = value - sum / static_cast<double>(high - low);
    square += rest * rest;
  }
  return n > 0 ? std::sqrt(square / static_cast<double>(n)) : 0;
}

}  // namespace

std::vector<MeasureDoc> Riemann::possible_measures() {
  const std::string over =
      "error of the cells' means, summed over the cells with matter, over the "
      "sum of the exact means; an empty cell counts as wholly wrong";
  return {
      {"L1 density", "-", over},
      {"L1 velocity", "-", over + "; means by mass"},
      {"L1 pressure", "-", over},
      {"L1 energy", "-", over + "; means by mass"},
      {"shock position", "cells",
       "how far the shock is ahead of (+) or behind (-) its place, taken where the cells' pressure "
       "passes half its jump; of two shocks the worse"},
      {"fan noise", "-",
       "root mean square velocity noise from particle to particle inside the fan, over the "
       "fan's velocity jump; 0 for a fan narrower than 8 cells; of two fans the worse"},
      {"contact overshoot", "-", "largest pressure around contact and shock over p*, less 1"},
      {"energy overshoot", "-",
       "largest specific energy around contact and shock over the larger exact plateau, less 1"}};
}

std::vector<MeasureDoc> Riemann::measure_docs() const {
  const auto either = [&](Wave::Kind kind) {
    return wave_[0].kind == kind || wave_[1].kind == kind;
  };
  std::vector<MeasureDoc> docs;
  for (const MeasureDoc& doc : possible_measures()) {
    if (doc.name == "shock position" && !either(Wave::Kind::shock)) continue;
    if (doc.name == "fan noise" && !either(Wave::Kind::fan)) continue;
    if (doc.name.find("overshoot") != std::string::npos && vacuum_) continue;
    docs.push_back(doc);
  }
  return docs;
}

std::vector<Measure> Riemann::measures(const ParticleTable& table, double t) const {
  const std::vector<MatterState> layers = exact_layers(*this, table, data_.direction, t);
  std::vector<char> measured(layers.size());
  for (int i = 0; i < table.cells[data_.direction]; ++i)
    measured[i] = is_measured(table.layer_centre(data_.direction, i));
  const Cells error = cell_errors(table, layers, measured, data_.direction);
  const Excess excess = overshoot(table, t);
  return with_values(measure_docs(), {{"L1 density", error.density},
                                      {"L1 velocity", error.velocity},
                                      {"L1 pressure", error.pressure},
                                      {"L1 energy", error.energy},
                                      {"shock position", shock_position(table, t)},
                                      {"fan noise", fan_noise(table, t)},
                                      {"contact overshoot", excess.pressure},
                                      {"energy overshoot", excess.energy}});
}

// A shock that is nowhere to be found is taken to have stayed at the interface.
double Riemann::shock_position(const ParticleTable& table, double t) const {
  const std::vector<Sums> layers = sums_per_layer(table, data_.direction);
  double worst = 0;
  for (int k = 0; k < 2; ++k) {
    if (wave_[k].kind != Wave::Kind::shock) continue;
    const double sign = k == 0 ? -1 : 1;
    Profile outward;  // with the shock running towards the end of the profile
    const int count = table.cells[data_.direction];
    for (int i = 0; i < count; ++i) {
      const int layer = k == 0 ? count - 1 - i : i;
      const double centre = table.layer_centre(data_.direction, layer);
      if (layers[layer].empty() || !is_measured(centre)) continue;
      outward.where.push_back(sign * centre);
      outward.value.push_back(layers[layer].mean_pressure());
    }
    const double found = last_fall(outward, 0.5 * (p_star_ + side(k).p), sign * data_.interface);
    const double ahead = (found - sign * position(wave_[k].head, t)) / table.cell_size;
    if (std::abs(ahead) > std::abs(worst)) worst = ahead;
  }
  return worst;
}

double Riemann::fan_noise(const ParticleTable& table, double t) const {
  const std::vector<double>& x = table.position(data_.direction);
  const std::vector<double>& u = table.velocity(data_.direction);
  const double edge = 4 * table.cell_size;  // where the corners of the fan are rounded off
  double worst = 0;
  for (int k = 0; k < 2; ++k) {
    if (wave_[k].kind != Wave::Kind::fan) continue;
    const double head = position(wave_[k].head, t), tail = position(wave_[k].tail, t);
    const double low = std::min(head, tail) + edge, high = std::max(head, tail) - edge;
    std::vector<std::pair<double, double>> deviation;
    for (std::size_t i = 0; i < table.size(); ++i)
      if (x[i] > low && x[i] < high)
        deviation.emplace_back(x[i], u[i] - sample((x[i] - data_.interface) / t).u);
    worst = std::max(worst, relative(roughness(deviation, 1.5 * table.cell_size),
                                     std::abs(wave_[k].u - side(k).u)));
  }
  return worst;
}

// From half-way between a fan's tail and the contact, lest the fan's rounded corner, which stands 5
// % above p* at 200 cells, pass for an overshoot; on the side of a shock from the end of the tube.
Riemann::Excess Riemann::overshoot(const ParticleTable& table, double t) const {
  if (vacuum_) return {};
  std::array<double, 2> end{{data_.measured_from, data_.measured_to}};
  std::array<double, 2> plateau{};
  for (int k = 0; k < 2; ++k) {
    if (wave_[k].kind != Wave::Kind::shock) end[k] = position(0.5 * (wave_[k].tail + u_star_), t);
    plateau[k] = p_star_ / ((data_.gamma - 1) * wave_[k].rho);
  }
  const std::vector<double>& x = table.position(data_.direction);
  double pressure = 0, energy = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (x[i] < end[0] || x[i] > end[1]) continue;
    pressure = std::max(pressure, table.pressure[i]);
    energy = std::max(energy, table.energy[i]);
  }
  return {relative(pressure, p_star_) - 1, relative(energy, std::max(plateau[0], plateau[1])) - 1};
}

}  // namespace brisance
