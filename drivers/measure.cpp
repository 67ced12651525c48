#include "drivers/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace brisance {

std::vector<Measure> with_values(const std::vector<MeasureDoc>& docs,
                                 const std::map<std::string, double>& values) {
  std::vector<Measure> measures;
  for (const MeasureDoc& doc : docs)
    measures.push_back({doc.name, values.at(doc.name), doc.unit, doc.doc});
  return measures;
}

namespace {

void require_direction(const ParticleTable& table, int direction) {
  if (direction >= table.dim)
    throw std::runtime_error(
        "there is nothing to measure along a direction that the grid does not resolve");
}

}  // namespace

const std::vector<double>& ParticleTable::position(int direction) const {
  require_direction(*this, direction);
  return direction == 0 ? x : direction == 1 ? y : z;
}

const std::vector<double>& ParticleTable::velocity(int direction) const {
  require_direction(*this, direction);
  return direction == 0 ? vx : direction == 1 ? vy : vz;
}

std::array<double, 3> ParticleTable::place(std::size_t particle) const {
  std::array<double, 3> place{};
  for (int d = 0; d < dim; ++d) place[d] = position(d)[particle];
  return place;
}

std::array<double, 3> ParticleTable::motion(std::size_t particle) const {
  std::array<double, 3> motion{};
  for (int d = 0; d < dim; ++d) motion[d] = velocity(d)[particle];
  return motion;
}

const std::vector<double>* ParticleTable::field(const std::string& name) const {
  for (const Field& f : fields)
    if (f.name == name) return &f.values;
  return nullptr;
}

void Sums::add(const ParticleTable& table, std::size_t particle) {
  const double m = table.mass[particle], v = table.volume[particle];
  mass += m;
  volume += v;
  pressure += v * table.pressure[particle];
  energy += m * table.energy[particle];
  for (int d = 0; d < table.dim; ++d) momentum[d] += m * table.velocity(d)[particle];
}

std::array<double, 3> Sums::mean_velocity() const {
  return {momentum[0] / mass, momentum[1] / mass, momentum[2] / mass};
}

namespace {

int layer_of(const ParticleTable& table, int direction, std::size_t particle) {
  const double cells = table.cells[direction];
  const double at =
      (table.position(direction)[particle] - table.origin[direction]) / table.cell_size;
  return static_cast<int>(std::max(0., std::min(cells - 1, std::floor(at))));
}

}  // namespace

std::vector<Sums> sums_per_cell(const ParticleTable& table) {
  std::vector<Sums> sums(static_cast<std::size_t>(table.cells[0]) * table.cells[1] *
                         table.cells[2]);
  for (std::size_t k = 0; k < table.size(); ++k) {
    std::size_t cell = 0;
    for (int d = table.dim - 1; d >= 0; --d) cell = cell * table.cells[d] + layer_of(table, d, k);
    sums[cell].add(table, k);
  }
  return sums;
}

std::vector<Sums> sums_per_layer(const ParticleTable& table, int direction) {
  std::vector<Sums> sums(table.cells[direction]);
  for (std::size_t k = 0; k < table.size(); ++k) sums[layer_of(table, direction, k)].add(table, k);
  return sums;
}

double last_fall(const Profile& profile, double level, double otherwise) {
  for (std::size_t k = profile.where.size(); k-- > 1;) {
    const double behind = profile.value[k - 1], ahead = profile.value[k];
    if (behind > level && ahead <= level)
      return profile.where[k - 1] +
             (profile.where[k] - profile.where[k - 1]) * (behind - level) / (behind - ahead);
  }
  return otherwise;
}

double relative(double error, double scale) {
  if (scale > 0) return error / scale;
  return error > 0 ? std::numeric_limits<double>::infinity() : 0;
}

double order(const std::vector<double>& h, const std::vector<double>& error) {
  const double n = static_cast<double>(h.size());
  if (n < 2 || error.size() != h.size())
    throw std::runtime_error("an order of convergence needs two or more pairs of h and error");
  double x_mean = 0, y_mean = 0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    if (!(h[k] > 0 && error[k] > 0))
      throw std::runtime_error("an order of convergence needs positive h and errors");
    x_mean += std::log(h[k]) / n;
    y_mean += std::log(error[k]) / n;
  }
  double xx = 0, xy = 0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    const double x = std::log(h[k]) - x_mean;
    xx += x * x;
    xy += x * (std::log(error[k]) - y_mean);
  }
  if (!(xx > 0)) throw std::runtime_error("an order of convergence needs different h");
  return xy / xx;
}

}  // namespace brisance
