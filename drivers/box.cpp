#include "drivers/box.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/bins.hpp"

namespace brisance {
namespace {

std::vector<std::size_t> rows_of(const ParticleTable& table, int material) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table.material[k] == material) rows.push_back(k);
  return rows;
}

/// Zero at the centre itself.
double radial_velocity(const ParticleTable& table, std::size_t k,
                       const std::array<double, 3>& centre) {
  const auto at = table.place(k), v = table.motion(k);
  const double x = at[0] - centre[0], y = at[1] - centre[1], r = std::hypot(x, y);
  return r > 0 ? (x * v[0] + y * v[1]) / r : 0;
}

/// Whether the centre is a corner of the grid, which then holds a quarter of the box.
bool quarter(const ParticleTable& table, const std::array<double, 3>& centre) {
  for (int d = 0; d < 2; ++d) {
    const double cells = (centre[d] - table.origin[d]) / table.cell_size;
    if (std::min(std::abs(cells), std::abs(cells - table.cells[d])) > 1e-6) return false;
  }
  return true;
}

/// Values at the nodes of a lattice about a centre.
class CentredLattice {
 public:
  explicit CentredLattice(long reach)
      : reach_(reach), values_(static_cast<std::size_t>((2 * reach + 1) * (2 * reach + 1))) {}
  double& at(long i, long j) { return values_[(j + reach_) * (2 * reach_ + 1) + i + reach_]; }

  /// Difference from the images over the sum of both.
  double asymmetry(bool quarter) {
    double difference = 0, scale = 0;
    for (long j = -reach_; j <= reach_; ++j)
      for (long i = -reach_; i <= reach_; ++i) {
        const double value = at(i, j);
        const auto compare = [&](double image) {
          difference += std::abs(value - image);
          scale += std::abs(value) + std::abs(image);
        };
        compare(at(j, i));
        if (quarter) continue;
        for (const double image :
             {at(-i, j), at(i, -j), at(-i, -j), at(-j, i), at(j, -i), at(-j, -i)})
          compare(image);
      }
    return relative(difference, scale);
  }

 private:
  long reach_;
  std::vector<double> values_;
};

}  // namespace

double outward_velocity(const ParticleTable& table, int material,
                        const std::array<double, 3>& centre) {
  double mass = 0, momentum = 0;
  for (const std::size_t k : rows_of(table, material)) {
    mass += table.mass[k];
    momentum += table.mass[k] * radial_velocity(table, k, centre);
  }
  return mass > 0 ? momentum / mass : std::nan("");
}

double four_fold_asymmetry(const ParticleTable& table, const std::array<double, 3>& centre) {
  const double h = table.cell_size;
  double farthest = 0;
  for (std::size_t k = 0; k < table.size(); ++k)
    for (int d = 0; d < 2; ++d)
      farthest = std::max(farthest, std::abs(table.place(k)[d] - centre[d]) / h);
  const long reach = std::lround(std::floor(farthest)) + 1;
  CentredLattice mass(reach), momentum(reach);
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto x = table.place(k);
    const double m = table.mass[k], p = m * radial_velocity(table, k, centre);
    double low[2], share[2];
    for (int d = 0; d < 2; ++d) {
      const double at = (x[d] - centre[d]) / h;
      low[d] = std::floor(at);
      share[d] = at - low[d];
    }
    for (const int j : {0, 1})
      for (const int i : {0, 1}) {
        const double w = (i ? share[0] : 1 - share[0]) * (j ? share[1] : 1 - share[1]);
        const long a = std::lround(low[0]) + i, b = std::lround(low[1]) + j;
        mass.at(a, b) += w * m;
        momentum.at(a, b) += w * p;
      }
  }
  const bool part = quarter(table, centre);
  return std::max(mass.asymmetry(part), momentum.asymmetry(part));
}

Overlap overlap_of(const ParticleTable& table, const std::vector<bool>& fluid) {
  std::vector<std::size_t> fluids, solids;
  double mean = 0;
  for (std::size_t k = 0; k < table.size(); ++k)
    (fluid[table.material[k]] ? fluids : solids).push_back(k);
  Overlap overlap;
  if (fluids.empty() || solids.empty()) return overlap;
  for (const std::size_t k : solids)
    mean += point_size(table, k) / static_cast<double>(solids.size());
  const Bins bins(table, fluids, mean);
  std::vector<double> filled(table.size());
  for (const std::size_t k : solids) {
    const double size = point_size(table, k);
    const auto x = table.place(k);
    bins.each_near(x, size, [&](std::size_t other, const Bins::Place& y) {
      double tent = 1, distance = 0;
      for (int d = 0; d < table.dim; ++d) {
        tent *= std::max(0., 1 - std::abs(x[d] - y[d]) / size);
        distance = std::hypot(distance, x[d] - y[d]);
      }
      filled[other] += tent;
      if (distance >= size) return;
      const double touching = 0.5 * (size + std::min(size, point_size(table, other)));
      overlap.greatest = std::max(overlap.greatest, 1 - distance / touching);
    });
  }
  double mass = 0, inside = 0;
  for (const std::size_t k : fluids) {
    mass += table.mass[k];
    if (filled[k] > 0.9) inside += table.mass[k];
  }
  overlap.share = relative(inside, mass);
  return overlap;
}

bool within(const ParticleTable& table, int material, int other, double distance) {
  const Bins bins(table, rows_of(table, other), distance);
  bool found = false;
  for (const std::size_t k : rows_of(table, material)) {
    if (found) break;
    const auto x = table.place(k);
    bins.each_near(x, distance, [&](std::size_t, const Bins::Place& y) {
      found = found || std::hypot(x[0] - y[0], x[1] - y[1]) < distance;
    });
  }
  return found;
}

WallDamage wall_damage(const ParticleTable& table, int wall, const std::array<double, 3>& centre,
                       double inner) {
  constexpr int parts = 16;  // of a face
  const auto *damage = table.field("damage"), *decohesion = table.field("decohesion");
  struct Part {
    double mass = 0, failed = 0;
    bool harmed = false;
  };
  std::array<Part, 4 * parts> along{};
  double mass = 0, harmed = 0, failed = 0, near = 0;
  for (const std::size_t k : rows_of(table, wall)) {
    const double sound = (damage ? 1 - (*damage)[k] : 1) * (decohesion ? 1 - (*decohesion)[k] : 1);
    const double m = table.mass[k], of_it = m * (1 - sound);
    mass += m;
    failed += of_it;
    if (1 - sound > 0.1) harmed += m;
    const auto x = table.place(k);
    const double dx = x[0] - centre[0], dy = x[1] - centre[1];
    const bool beside = std::abs(dx) > std::abs(dy);  // of a face across x
    const double off = beside ? dy : dx;              // from the middle of the face
    if (std::abs(off) < 0.5 * inner) near += of_it;
    if (std::abs(off) >= inner) continue;  // a corner of the box belongs to no face
    const int face = beside ? (dx < 0) : 2 + (dy < 0);
    const int part = std::min(parts - 1, static_cast<int>((off / inner + 1) * 0.5 * parts));
    Part& here = along[face * parts + part];
    here.mass += m;
    here.failed += of_it;
    here.harmed = here.harmed || 1 - sound > 0.1;
  }
  double count = 0, sum = 0, squares = 0, length = 0;
  for (const Part& p : along) {
    if (!(p.mass > 0)) continue;
    const double mean = p.failed / p.mass;
    ++count;
    sum += mean;
    squares += mean * mean;
    length += p.harmed;
  }
  WallDamage of_wall;
  of_wall.near_middle = failed > 0 ? near / failed : std::nan("");
  of_wall.share = relative(harmed, mass);
  of_wall.spread = squares > 0 ? sum * sum / (count * squares) : std::nan("");
  of_wall.length = relative(length, count);
  return of_wall;
}

}  // namespace brisance
