#include "drivers/lighting.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

constexpr double pi = 3.141592653589793;

/// Within how many cells of a source or a round obstacle rays are followed one by one: farther off,
/// fronts are smooth enough for the grid.
constexpr double ray_cells = 5;

double apart(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

Place between(const Place& a, const Place& b, double share) {
  return {{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), 0}};
}

Place on_circle(const Place& centre, double radius, double angle) {
  return {{centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), 0}};
}

}  // namespace

LightingTimes::LightingTimes(const List& checked, const Eikonal::Box& box,
                             std::function<double(const Place&)> speed)
    : speed_(std::move(speed)) {
  const List& sources = checked.sublist("sources");
  for (const auto& name : list_names(sources)) {
    const List& list = sources.sublist(name);
    Source source;
    source.delay = get<double>(list, "delay");
    if (const List* line = find_list(list, "line")) {
      source.a = place_of(*line, "from");
      source.b = place_of(*line, "to");
    } else if (const List* plane = find_list(list, "plane")) {
      source.plane = true;
      source.a = source.b = place_of(*plane, "point");
      source.normal = place_of(*plane, "normal");
      const double length = std::hypot(source.normal[0], source.normal[1]);
      for (double& n : source.normal) n /= length;
    } else {
      source.a = source.b = place_of(list, "point");
    }
    sources_.push_back(source);
  }
  if (get<std::string>(checked, "path") == "straight") return;

  if (const List* obstacles = find_list(checked, "obstacles"))
    for (const auto& name : list_names(*obstacles)) {
      const List& list = obstacles->sublist(name);
      discs_.push_back({place_of(list, "centre"), get<double>(list, "radius")});
    }
  box_ = refined(box, get<int>(checked, "refinement"));
  grid_ = std::make_unique<Eikonal>(box_, sampled());
  const auto names = list_names(sources);
  for (std::size_t k = 0; k < sources_.size(); ++k)
    if (!light(sources_[k])) refuse(sources, names[k], "lights nothing: it lies in no explosive");
  grid_->march();
}

Place LightingTimes::Source::nearest(const Place& x) const {
  if (plane) {
    const double off = (x[0] - a[0]) * normal[0] + (x[1] - a[1]) * normal[1];
    return {{x[0] - off * normal[0], x[1] - off * normal[1], 0}};
  }
  if (point()) return a;
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double share = ((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / (dx * dx + dy * dy);
  return between(a, b, std::clamp(share, 0., 1.));
}

double LightingTimes::at(const Place& x) const {
  double earliest = never;
  if (!grid_) {
    const double speed = speed_(x);
    if (speed > 0)
      for (const Source& source : sources_)
        earliest = std::min(earliest, source.delay + apart(source.nearest(x), x) / speed);
    return earliest;
  }
  earliest = grid_->at(x[0], x[1]);
  for (const Source& source : sources_)
    if (apart(source.nearest(x), x) <= ray_cells * box_.h)
      earliest = std::min(earliest, straight(source, x).time);
  return earliest;
}

Eikonal::Box LightingTimes::refined(const Eikonal::Box& box, int refinement) const {
  Eikonal::Box fine = box;
  fine.h /= refinement;
  for (int& cells : fine.cells) cells *= refinement;
  return fine;
}

/// The cells of the grid, closed where they touch a disc: no way on the grid cuts through one. A
/// cell is explosive if most of it is, with the mean of the slowness there.
std::vector<double> LightingTimes::sampled() {
  constexpr int samples = 3;
  std::vector<double> open;
  for (int j = 0; j < box_.cells[1]; ++j)
    for (int i = 0; i < box_.cells[0]; ++i) {
      double sum = 0;
      int explosive = 0;
      const Place low{{box_.low[0] + i * box_.h, box_.low[1] + j * box_.h, 0}};
      for (int k = 0; k < samples * samples; ++k) {
        const double speed = speed_({{low[0] + (k % samples + 0.5) / samples * box_.h,
                                      low[1] + (k / samples + 0.5) / samples * box_.h, 0}});
        if (!(speed > 0)) continue;
        sum += 1 / speed;
        ++explosive;
      }
      matter_.push_back(2 * explosive > samples * samples ? sum / explosive : 0);
      bool touched = false;
      for (const Disc& disc : discs_) {
        const Place nearest{{std::clamp(disc.centre[0], low[0], low[0] + box_.h),
                             std::clamp(disc.centre[1], low[1], low[1] + box_.h), 0}};
        touched = touched || apart(nearest, disc.centre) < disc.radius;
      }
      open.push_back(touched ? 0 : matter_.back());
    }
  return open;
}

/// Cells that a disc cuts are not asked: what counts is the matter that a ray along it runs
/// through.
Place LightingTimes::off_discs(const Place& x) const {
  for (const Disc& disc : discs_) {
    const double r = apart(x, disc.centre), clear = disc.radius + box_.h;
    if (r < clear && r > 0) return between(disc.centre, x, clear / r);
  }
  return x;
}

/// On a face between cells that of the faster one, along which a ray may run.
double LightingTimes::slowness(const Place& x) const {
  const Place at = off_discs(x);
  int first[2], last[2];
  for (int d = 0; d < 2; ++d) {
    const double in_cells = (at[d] - box_.low[d]) / box_.h;
    first[d] = std::max(static_cast<int>(std::floor(in_cells - 1e-9)), 0);
    last[d] = std::min(static_cast<int>(std::floor(in_cells + 1e-9)), box_.cells[d] - 1);
  }
  double least = 0;
  for (int j = first[1]; j <= last[1]; ++j)
    for (int i = first[0]; i <= last[0]; ++i) {
      const double s = matter_[i + static_cast<std::size_t>(box_.cells[0]) * j];
      if (s > 0 && (least == 0 || s < least)) least = s;
    }
  return least;
}

bool LightingTimes::blocked(const Place& from, const Place& to) const {
  const double dx = to[0] - from[0], dy = to[1] - from[1], length2 = dx * dx + dy * dy;
  for (const Disc& disc : discs_) {
    const double along = (disc.centre[0] - from[0]) * dx + (disc.centre[1] - from[1]) * dy;
    const double share = length2 > 0 ? std::clamp(along / length2, 0., 1.) : 0;
    // Tangents touch and are free.
    if (apart(between(from, to, share), disc.centre) < disc.radius * (1 - 1e-9)) return true;
  }
  return false;
}

/// Time along a straight way; `never` if something inert is on it. [s]
double LightingTimes::along(const Place& from, const Place& to) const {
  if (blocked(from, to)) return never;
  const double length = apart(from, to);
  const int pieces = 1 + static_cast<int>(4 * length / box_.h);
  double time = 0;
  for (int k = 0; k < pieces; ++k) {
    const double s = slowness(between(from, to, (k + 0.5) / pieces));
    if (!(s > 0)) return never;
    time += s * length / pieces;
  }
  return time;
}

/// The same along the rim of a disc, for an angle that may be negative.
double LightingTimes::along_arc(const Disc& disc, double from, double angle) const {
  const double length = disc.radius * std::fabs(angle);
  const int pieces = 1 + static_cast<int>(4 * length / box_.h);
  double time = 0;
  for (int k = 0; k < pieces; ++k) {
    const Place x = on_circle(disc.centre, disc.radius, from + angle * (k + 0.5) / pieces);
    const double s = slowness(x);
    if (!(s > 0)) return never;
    for (const Disc& other : discs_)
      if (&other != &disc && apart(x, other.centre) < other.radius) return never;
    time += s * length / pieces;
  }
  return time;
}

LightingTimes::Arrival LightingTimes::straight(const Source& source, const Place& x) const {
  const Place from = source.nearest(x);
  const double time = along(from, x);
  if (!(time < never)) return {};
  const double length = apart(from, x), s = slowness(x);
  if (!(length > 0)) return {source.delay, 0, 0};
  return {source.delay + time, s * (x[0] - from[0]) / length, s * (x[1] - from[1]) / length};
}

/// The shortest way round a disc: a tangent, an arc, a tangent, on either side.
LightingTimes::Arrival LightingTimes::around(const Source& source, const Disc& disc,
                                             const Place& x) const {
  const double from = apart(source.a, disc.centre), to = apart(x, disc.centre);
  if (!(from > disc.radius) || !(to > disc.radius)) return {};
  const auto angle = [&](const Place& p) {
    return std::atan2(p[1] - disc.centre[1], p[0] - disc.centre[0]);
  };
  Arrival best;
  for (const int side : {1, -1}) {
    const double first = angle(source.a) + side * std::acos(disc.radius / from),
                 last = angle(x) - side * std::acos(disc.radius / to);
    double arc = side * (last - first);
    arc -= 2 * pi * std::floor(arc / (2 * pi));
    if (arc > 1.5 * pi) continue;
    const Place on = on_circle(disc.centre, disc.radius, first),
                off = on_circle(disc.centre, disc.radius, last);
    const double time =
        source.delay + along(source.a, on) + along_arc(disc, first, side * arc) + along(off, x);
    if (!(time < best.time)) continue;
    const double s = slowness(x), length = apart(off, x);
    best = {time, s * (x[0] - off[0]) / length, s * (x[1] - off[1]) / length};
  }
  return best;
}

/// Starts the front near a source, and near discs where it runs round them, at the nodes that rays
/// reach. Returns whether there are any.
bool LightingTimes::light(const Source& source) {
  bool any = false;
  for (int j = 0; j < grid_->nodes(1); ++j)
    for (int i = 0; i < grid_->nodes(0); ++i) {
      const Place x{{grid_->coordinate(0, i), grid_->coordinate(1, j), 0}};
      bool near = apart(source.nearest(x), x) <= ray_cells * box_.h;
      Arrival first;
      for (const Disc& disc : discs_) {
        const double off = apart(x, disc.centre) - disc.radius;
        if (off < 0 || off > ray_cells * box_.h) continue;
        near = true;
        if (!source.point()) continue;
        const Arrival a = around(source, disc, x);
        if (a.time < first.time) first = a;
      }
      if (!near || !grid_->open(i, j)) continue;
      const Arrival a = straight(source, x);
      if (a.time < first.time) first = a;
      if (!(first.time < never)) continue;
      grid_->start(i, j, first.time, first.gx, first.gy);
      any = true;
    }
  return any;
}

}  // namespace brisance
