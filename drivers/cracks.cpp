#include "drivers/cracks.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

constexpr double degrees = 57.29577951308232;

/// The columns that concrete adds.
struct Columns {
  const std::vector<double>&damage, &decohesion, &normal_x, &normal_y, &rate;
  explicit Columns(const ParticleTable& table)
      : damage(find(table, "damage")),
        decohesion(find(table, "decohesion")),
        normal_x(find(table, "normal x")),
        normal_y(find(table, "normal y")),
        rate(find(table, "peak rate")) {}

  /// How far a point is from sound, 1 - (1 - D)(1 - lambda).
  double failure(std::size_t k) const { return 1 - (1 - damage[k]) * (1 - decohesion[k]); }

 private:
  static const std::vector<double>& find(const ParticleTable& table, const std::string& name) {
    if (const auto* values = table.field(name)) return *values;
    throw std::runtime_error("list 'cracks' needs concrete: no material has '" + name + "'");
  }
};

/// A weighted mean of directions that have no sign: the main axis of sum w n n^T.
struct MainAxis {
  double xx = 0, xy = 0, yy = 0;
  void add(double w, double x, double y) {
    xx += w * x * x;
    xy += w * x * y;
    yy += w * y * y;
  }
  /// From x, between -90 and 90. [degree]
  double angle() const { return 0.5 * std::atan2(2 * xy, xx - yy) * degrees; }
};

}  // namespace

CrackPattern::CrackPattern(const List& list)
    : along_(direction_of(list)),
      middle_(get<double>(list, "middle")),
      size_(get<double>(list, "size")) {}

List CrackPattern::valid_parameters(int dim) {
  List valid;
  declare(valid, "direction", "x", dim == 1 ? one_of({"x"}) : one_of({"x", "y"}), "of the hit [-]");
  declare(valid, "middle", 0.0, anything(), "where its line is, along the other direction [m]");
  declare(valid, "size", 1.0, positive(), "of what hits, along the other direction [m]");
  return valid;
}

std::vector<MeasureDoc> CrackPattern::measure_docs() {
  return {
      {"asymmetry", "-",
       "difference of failure, 1 - (1 - damage)(1 - decohesion), between cells and their "
       "mirror images about the line of the hit, over its sum"},
      {"normal at the middle", "degree",
       "angle from the direction of the hit of the main normal, weighted by decohesion, within "
       "a cell of its line"},
      {"failure near the middle", "-",
       "share of failure that lies within three sizes of what hits on either side of the line"},
      {"failed extent", "m", "distance from the line within which nine tenths of the failure lie"},
      {"failed mass", "kg", "of all points, times their failure, per metre or square metre"},
      {"separated mass", "kg", "of points that have come apart wholly"},
      {"largest damage", "-", "of all points"},
      {"largest strain rate", "1/s", "of volume in tension, of all points and times"},
      {"greatest pressure", "Pa", "of all points at the times of output"},
      {"place of failure", "m", "mean coordinate along the hit, weighted by decohesion"},
      {"first decohesion", "s", "time of the first output with some"}};
}

void CrackPattern::observe(const ParticleTable& table, double time) {
  if (onset_ == 0)
    for (const double lambda : Columns(table).decohesion)
      if (lambda > 0) onset_ = time;
  for (const double p : table.pressure) pressure_ = std::max(pressure_, p);
  last_ = pattern_of(table);
}

std::map<std::string, double> CrackPattern::pattern_of(const ParticleTable& table) const {
  const Columns columns(table);
  const int across = 1 - along_;
  const bool plane = table.dim > 1;
  const double h = table.cell_size;
  MainAxis axis;
  double failed = 0, separated = 0, near = 0, largest_damage = 0, largest_rate = 0;
  double place = 0, apart = 0;
  std::vector<std::pair<double, double>> by_distance;
  std::map<std::pair<long, long>, std::array<double, 2>> sides;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const auto x = table.place(k);
    const double off = plane ? x[across] - middle_ : 0, distance = std::abs(off);
    const double mass = table.mass[k], failure = mass * columns.failure(k);
    largest_damage = std::max(largest_damage, columns.damage[k]);
    largest_rate = std::max(largest_rate, columns.rate[k]);
    const double opened = mass * columns.decohesion[k];
    place += opened * x[along_];
    apart += opened;
    if (distance < h) axis.add(opened, columns.normal_x[k], columns.normal_y[k]);
    if (!(failure > 0)) continue;
    failed += failure;
    if (columns.decohesion[k] >= 1) separated += mass;
    if (distance < 3 * size_) near += failure;
    by_distance.emplace_back(distance, failure);
    sides[{std::lround(std::floor(x[along_] / h)), std::lround(std::floor(distance / h))}]
         [off < 0] += failure;
  }
  double difference = 0;
  for (const auto& [cell, side] : sides) difference += std::abs(side[0] - side[1]);
  std::sort(by_distance.begin(), by_distance.end());
  double extent = 0, sum = 0;
  for (const auto& [distance, failure] : by_distance) {
    if (sum >= 0.9 * failed) break;
    extent = distance;
    sum += failure;
  }
  double angle = axis.angle() - (along_ == 1 ? 90 : 0);
  if (angle < -90) angle += 180;
  return {{"asymmetry", plane ? relative(difference, failed) : 0},
          {"normal at the middle", angle},
          {"failure near the middle", relative(near, failed)},
          {"failed extent", extent},
          {"failed mass", failed},
          {"separated mass", separated},
          {"largest damage", largest_damage},
          {"largest strain rate", largest_rate},
          {"place of failure", apart > 0 ? place / apart : std::nan("")}};
}

std::vector<Measure> CrackPattern::measures() const {
  auto values = last_;
  values["greatest pressure"] = pressure_;
  values["first decohesion"] = onset_ > 0 ? onset_ : std::nan("");
  return with_values(measure_docs(), values);
}

// The pattern is that of the last output alone.
void CrackPattern::keep(Archive& archive) {
  const Archive::Part part(archive, "cracks");
  archive.keep("pressure", pressure_);
  archive.keep("onset", onset_);
}

}  // namespace brisance
