#include "drivers/fragments.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "drivers/bins.hpp"

namespace brisance {
namespace {

/// Sets that grow together; each is named by its first member.
class Unions {
 public:
  explicit Unions(std::size_t count) : parent_(count) {
    for (std::size_t k = 0; k < count; ++k) parent_[k] = k;
  }
  std::size_t first(std::size_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void unite(std::size_t a, std::size_t b) {
    a = first(a);
    b = first(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

double squared(const std::array<double, 3>& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

void add(MotionSums& sums, const ParticleTable& table, std::size_t k) {
  const double m = table.mass[k];
  const auto v = table.motion(k);
  ++sums.points;
  sums.mass += m;
  sums.kinetic += 0.5 * m * squared(v);
  for (int d = 0; d < 3; ++d) sums.momentum[d] += m * v[d];
}

/// Whether a point has lost all strength.
class Lost {
 public:
  explicit Lost(const ParticleTable& table) {
    for (const char* name : {"decohesion", "damage", "failed"})
      if (const auto* values = table.field(name)) fields_.push_back(values);
  }
  bool operator()(std::size_t k) const {
    return std::any_of(fields_.begin(), fields_.end(), [&](auto* f) { return (*f)[k] >= 1; });
  }

 private:
  std::vector<const std::vector<double>*> fields_;
};

/// Rows of points that hang together, for each piece.
std::vector<std::vector<std::size_t>> connected(const ParticleTable& table,
                                                const std::vector<std::size_t>& rows,
                                                double reach) {
  if (rows.empty()) return {};
  std::vector<double> size(table.size());
  double mean = 0;
  for (const std::size_t k : rows) {
    size[k] = point_size(table, k);
    mean += size[k] / static_cast<double>(rows.size());
  }
  const Bins bins(table, rows, reach * mean);
  Unions unions(table.size());
  for (const std::size_t k : rows) {
    const auto x = table.place(k);
    // The larger of a pair finds the smaller, so that a few large points cost no more than theirs.
    bins.each_near(x, reach * size[k], [&](std::size_t other, const Bins::Place& y) {
      if (size[other] > size[k] || (size[other] == size[k] && other <= k)) return;
      const double near = reach * 0.5 * (size[k] + size[other]);
      if (squared({x[0] - y[0], x[1] - y[1], x[2] - y[2]}) < near * near) unions.unite(k, other);
    });
  }
  std::vector<std::vector<std::size_t>> pieces;
  std::vector<std::size_t> number(table.size());
  for (const std::size_t k : rows) {
    const std::size_t first = unions.first(k);
    if (first == k) {
      number[k] = pieces.size();
      pieces.emplace_back();
    }
    pieces[number[first]].push_back(k);
  }
  return pieces;
}

/// Second moments of a piece about its centre [kg m^2], angular momentum [kg m^2/s].
struct Moments {
  double xx = 0, xy = 0, yy = 0, angular = 0, own = 0;
};

Fragment measured(const ParticleTable& table, const std::vector<std::size_t>& rows) {
  Fragment f;
  MotionSums sums;
  for (const std::size_t k : rows) {
    add(sums, table, k);
    f.volume += table.volume[k];
    const auto x = table.place(k);
    for (int d = 0; d < 3; ++d) f.centre[d] += table.mass[k] * x[d];
  }
  f.points = sums.points;
  f.mass = sums.mass;
  for (int d = 0; d < 3; ++d) {
    f.centre[d] /= f.mass;
    f.velocity[d] = sums.momentum[d] / f.mass;
  }
  Moments moment;
  const auto relative_to = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::array<double, 3>{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  for (const std::size_t k : rows) {
    const double m = table.mass[k], size = point_size(table, k);
    const auto r = relative_to(table.place(k), f.centre);
    const auto v = relative_to(table.motion(k), f.velocity);
    moment.xx += m * r[0] * r[0];
    moment.xy += m * r[0] * r[1];
    moment.yy += m * r[1] * r[1];
    moment.own += m * size * size / 12;
    moment.angular += m * (r[0] * v[1] - r[1] * v[0]);
  }
  // Without the points' own inertia: then a rigid turn leaves no rest, and no motion a negative
  // one.
  const double inertia = moment.xx + moment.yy;
  f.spin = inertia > 0 ? moment.angular / inertia : 0;
  f.translation = 0.5 * f.mass * squared(f.velocity);
  f.rotation = 0.5 * inertia * f.spin * f.spin;
  for (const std::size_t k : rows) {
    const auto r = relative_to(table.place(k), f.centre);
    auto v = relative_to(table.motion(k), f.velocity);
    v[0] += f.spin * r[1];
    v[1] -= f.spin * r[0];
    f.rest += 0.5 * table.mass[k] * squared(v);
  }
  // With the points' own moments a bar of n points is n points long; a rectangle has L^2 / 12.
  const double middle = 0.5 * (moment.xx + moment.yy),
               apart = std::hypot(0.5 * (moment.xx - moment.yy), moment.xy);
  const auto edge = [&](double m) {
    return std::sqrt(12 * (std::max(0., m) + moment.own) / f.mass);
  };
  f.length = edge(middle + apart);
  f.width = table.dim > 1 ? edge(middle - apart) : 0;
  f.size = table.dim > 1 ? std::pow(f.volume, 1. / table.dim) : f.volume;
  return f;
}

}  // namespace

double Fragment::speed() const { return std::sqrt(squared(velocity)); }

double Fragments::mass_error() const {
  double sum = dust.mass;
  for (const Fragment& f : pieces) sum += f.mass;
  return relative(std::abs(sum - all.mass), all.mass);
}

double Fragments::momentum_error() const {
  auto sum = dust.momentum;
  for (const Fragment& f : pieces)
    for (int d = 0; d < 3; ++d) sum[d] += f.mass * f.velocity[d];
  for (int d = 0; d < 3; ++d) sum[d] -= all.momentum[d];
  return relative(std::sqrt(squared(sum)), std::sqrt(2 * all.mass * all.kinetic));
}

double Fragments::energy_error() const {
  double sum = dust.kinetic;
  for (const Fragment& f : pieces) sum += f.translation + f.rotation + f.rest;
  return relative(std::abs(sum - all.kinetic), all.kinetic);
}

Fragments find_fragments(const ParticleTable& table, int material, double reach, bool dust) {
  Fragments found;
  const Lost lost(table);
  std::vector<std::size_t> sound;
  for (std::size_t k = 0; k < table.size(); ++k) {
    if (table.material[k] != material) continue;
    add(found.all, table, k);
    if (dust && lost(k))
      add(found.dust, table, k);
    else
      sound.push_back(k);
  }
  for (const auto& rows : connected(table, sound, reach))
    found.pieces.push_back(measured(table, rows));
  std::sort(found.pieces.begin(), found.pieces.end(), [](const Fragment& a, const Fragment& b) {
    return std::tie(b.mass, a.centre) < std::tie(a.mass, b.centre);
  });
  return found;
}

}  // namespace brisance
