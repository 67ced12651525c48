#include "drivers/lagrange.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace brisance {
namespace {

// Of the artificial viscosity, with the square and with the first power of the velocity's jump:
// enough for a shock over three to four cells without ringing.
constexpr double quadratic = 2, linear = 0.3;
constexpr double courant = 0.4, growth = 1.05;
constexpr double burn_cells = 2.5;  // over which an explosive burns

/// p = offset + slope e at a density.
struct Pressure {
  double offset = 0, slope = 0;
};

Pressure pressure_of(const Layer& layer, double burned, double rho) {
  switch (layer.law) {
    case Layer::Law::explosive:
      return {burned * layer.products->offset(rho), burned * layer.products->slope(rho)};
    case Layer::Law::gas:
      return {0, (layer.gamma - 1) * rho};
    default:
      return {layer.steel.bulk() * std::log(rho / layer.density), 0};
  }
}

double sound_speed_of(const Layer& layer, double burned, double rho, double energy) {
  switch (layer.law) {
    case Layer::Law::explosive:
      return std::sqrt(burned * std::max(0., layer.products->sound_speed2(rho, energy)));
    case Layer::Law::gas:
      return std::sqrt(layer.gamma * (layer.gamma - 1) * std::max(0., energy));
    default:
      return std::sqrt(layer.steel.constrained() / rho);
  }
}

/// Strains of a step; along the axis of a cylinder, or across the plane's normal, there is none.
struct Strains {
  double along = 0, hoop = 0;
};

Strains strains_of(bool cylindrical, double low, double high, double volume, double move_low,
                   double move_high) {
  Strains strain;
  strain.along = (move_high - move_low) / (high - low);
  if (cylindrical) strain.hoop = (high * move_high - low * move_low) / volume - strain.along;
  return strain;
}

void shear(const Layer& layer, const Strains& strain, Lagrangian::Cell& cell) {
  const double twice = 2 * layer.steel.shear(), mean = (strain.along + strain.hoop) / 3;
  cell.along += twice * (strain.along - mean);
  cell.hoop += twice * (strain.hoop - mean);
  const double third = cell.along + cell.hoop;
  const double mises =
      std::sqrt(1.5 * (cell.along * cell.along + cell.hoop * cell.hoop + third * third));
  if (!(mises > layer.yield)) return;
  cell.along *= layer.yield / mises;
  cell.hoop *= layer.yield / mises;
}

}  // namespace

Lagrangian::Lagrangian(const Data& data) : data_(data) {
  double fastest = 0, low = data.origin;
  x_.push_back(low);
  for (std::size_t k = 0; k < data.layers.size(); ++k) {
    const Layer& layer = data.layers[k];
    const int count = std::max(1, static_cast<int>(std::lround(layer.thickness / data.cell_size)));
    const double cj_volume =
        layer.law == Layer::Law::explosive ? chapman_jouguet(*layer.products).V : 1;
    for (int i = 0; i < count; ++i) {
      Cell cell;
      cell.layer = static_cast<int>(k);
      x_.push_back(low + layer.thickness * (i + 1) / count);
      cell.volume = volume_between(x_[x_.size() - 2], x_.back());
      cell.mass = layer.density * cell.volume;
      cell.energy = layer.energy;
      if (layer.law == Layer::Law::explosive) {
        cell.burned = 0;
        cell.cj_volume = cj_volume;
        cell.burn_time = burn_cells * layer.thickness / count / layer.detonation_speed;
        cell.lit =
            (low - data.origin + layer.thickness * (i + 0.5) / count) / layer.detonation_speed;
      }
      cell.sound_speed = sound_speed_of(layer, cell.burned, layer.density, layer.energy);
      fastest = std::max(
          {fastest, cell.sound_speed, sound_speed_of(layer, 1, layer.density, layer.energy)});
      cells_.push_back(cell);
    }
    low += layer.thickness;
  }
  u_.resize(x_.size());
  mass_.resize(x_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    mass_[i] += 0.5 * cells_[i].mass;
    mass_[i + 1] += 0.5 * cells_[i].mass;
  }
  half_x_ = mean_u_ = u_;
  push_.resize(cells_.size());
  next_dt_ = 0.1 * courant * data.cell_size / fastest;
  start_energy_ = energy();
}

double Lagrangian::volume_between(double low, double high) const {
  return data_.cylindrical ? 0.5 * (high - low) * (high + low) : high - low;
}

// The power of a cell's stresses, volume (stress_along rate_along + stress_hoop rate_hoop), is
// linear in the velocities of its ends; the factors are the forces.
Lagrangian::Push Lagrangian::push(std::size_t i) {
  Cell& cell = cells_[i];
  const Layer& layer = data_.layers[cell.layer];
  const double low = half_x_[i], high = half_x_[i + 1], volume = volume_between(low, high);
  const double rho = cell.mass / volume, jump = u_[i + 1] - u_[i];
  const double viscous = jump < 0 ? rho * jump * (quadratic * jump - linear * cell.sound_speed) : 0;

  if (layer.law == Layer::Law::explosive) {
    // By compression only where the front is about to arrive: unlit explosive bears no pressure, so
    // that what lies beside it would light it in no time.
    const double since = time_ + 0.5 * dt_ - cell.lit,
                 squeezed =
                     since > -cell.burn_time ? (1 - layer.density / rho) / (1 - cell.cj_volume) : 0;
    cell.burned = std::min(std::max({since / cell.burn_time, squeezed, cell.burned}), 1.);
  }
  const Pressure p = pressure_of(layer, cell.burned, rho);
  const double growth_of_volume = (volume - cell.volume) / cell.mass;
  const double energy =
      (cell.energy - (p.offset + viscous) * growth_of_volume) / (1 + p.slope * growth_of_volume);
  cell.pressure = p.offset + p.slope * energy;
  cell.sound_speed = sound_speed_of(layer, cell.burned, rho, energy);
  next_dt_ = std::min(next_dt_, courant * (high - low) /
                                    (cell.sound_speed + 2 * quadratic * std::fabs(jump) + 1e-300));

  Cell half = cell;
  if (layer.law == Layer::Law::steel)
    shear(
        layer,
        strains_of(data_.cylindrical, low, high, volume, 0.5 * dt_ * u_[i], 0.5 * dt_ * u_[i + 1]),
        half);
  const double hoop = half.hoop - cell.pressure - viscous,
               part = volume * (half.along - half.hoop) / (high - low);
  return {part + hoop * (data_.cylindrical ? low : 1),
          -part - hoop * (data_.cylindrical ? high : 1)};
}

void Lagrangian::step(double end) {
  const bool last = next_dt_ >= end - time_;
  dt_ = last ? end - time_ : next_dt_;
  if (!last && !(time_ + dt_ > time_))
    throw std::runtime_error("the reference of the exact solution 'layers' has come to a stop");
  next_dt_ *= growth;
  const std::size_t count = x_.size();
  for (std::size_t n = 0; n < count; ++n) half_x_[n] = x_[n] + 0.5 * dt_ * u_[n];
  for (std::size_t i = 0; i < cells_.size(); ++i) push_[i] = push(i);

  for (std::size_t n = 0; n < count; ++n) {
    const bool wall = (n == 0 && data_.low_wall) || (n + 1 == count && data_.high_wall);
    const double force = (n > 0 ? push_[n - 1].high : 0) + (n + 1 < count ? push_[n].low : 0);
    const double after = wall ? 0 : u_[n] + dt_ * force / mass_[n];
    mean_u_[n] = 0.5 * (u_[n] + after);
    u_[n] = after;
    x_[n] = half_x_[n] + 0.5 * dt_ * after;
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Cell& cell = cells_[i];
    const double low = half_x_[i], high = half_x_[i + 1];
    cell.energy -= dt_ * (push_[i].low * mean_u_[i] + push_[i].high * mean_u_[i + 1]) / cell.mass;
    if (data_.layers[cell.layer].law == Layer::Law::steel)
      shear(data_.layers[cell.layer],
            strains_of(data_.cylindrical, low, high, volume_between(low, high), dt_ * mean_u_[i],
                       dt_ * mean_u_[i + 1]),
            cell);
    cell.volume = volume_between(x_[i], x_[i + 1]);
  }
  time_ = last ? end : time_ + dt_;
  ++steps_;
}

double Lagrangian::energy() const {
  double sum = 0;
  for (const Cell& cell : cells_) sum += cell.mass * cell.energy;
  for (std::size_t n = 0; n < x_.size(); ++n) sum += 0.5 * mass_[n] * u_[n] * u_[n];
  return sum;
}

std::pair<double, double> Lagrangian::ends_of(int layer) const {
  const auto is_in = [&](const Cell& cell) { return cell.layer == layer; };
  const auto first = std::find_if(cells_.begin(), cells_.end(), is_in);
  const auto beyond = std::find_if_not(first, cells_.end(), is_in);
  return {x_[first - cells_.begin()], x_[beyond - cells_.begin()]};
}

double Lagrangian::mean_velocity(int layer) const {
  double momentum = 0, mass = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i].layer != layer) continue;
    momentum += 0.5 * cells_[i].mass * (u_[i] + u_[i + 1]);
    mass += cells_[i].mass;
  }
  return momentum / mass;
}

}  // namespace brisance
