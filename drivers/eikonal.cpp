#include "drivers/eikonal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace brisance {

Eikonal::Eikonal(const Box& box, std::vector<double> slowness)
    : box_(box),
      slowness_(std::move(slowness)),
      nodes_(static_cast<std::size_t>(nodes(0)) * nodes(1)) {}

double Eikonal::slowness(int i, int j) const {
  if (i < 0 || j < 0 || i >= box_.cells[0] || j >= box_.cells[1]) return 0;
  return slowness_[i + static_cast<std::size_t>(box_.cells[0]) * j];
}

bool Eikonal::open(int i, int j) const {
  return slowness(i, j) > 0 || slowness(i - 1, j) > 0 || slowness(i, j - 1) > 0 ||
         slowness(i - 1, j - 1) > 0;
}

void Eikonal::start(int i, int j, double time, double gx, double gy) {
  propose(node(i, j), time, gx, gy);
}

void Eikonal::propose(int n, double time, double gx, double gy) {
  Node& at = nodes_[n];
  if (!(time < at.t)) return;
  at.t = time;
  at.gx = gx;
  at.gy = gy;
  heap_.emplace_back(time, n);
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

void Eikonal::march() {
  while (!heap_.empty()) {
    const int n = heap_.front().second;
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
    if (nodes_[n].settled) continue;
    nodes_[n].settled = true;
    spread(n % nodes(0), n / nodes(0));
  }
}

// In each cell around a settled node: a and b are its neighbours along x and y, d is across.
void Eikonal::spread(int i, int j) {
  const int p = node(i, j);
  for (const int right : {0, 1})
    for (const int up : {0, 1}) {
      const double s = slowness(i - 1 + right, j - 1 + up);
      if (!(s > 0)) continue;
      const int a = node(i - 1 + 2 * right, j), b = node(i, j - 1 + 2 * up),
                d = node(i - 1 + 2 * right, j - 1 + 2 * up);
      from_edge(a, p, b, s);
      from_edge(b, p, a, s);
      from_edge(d, p, a, s);
      from_edge(d, p, b, s);
    }
}

void Eikonal::from_edge(int to, int p, int q, double s) {
  if (nodes_[to].settled) return;
  const auto x = [&](int n) { return box_.h * (n % nodes(0) - to % nodes(0)); };
  const auto y = [&](int n) { return box_.h * (n / nodes(0) - to / nodes(0)); };
  if (!nodes_[q].settled) q = p;
  const Ray ray = best_ray(nodes_[p], x(p), y(p), nodes_[q], x(q), y(q), s);
  const double length = std::hypot(ray.x, ray.y);
  propose(to, ray.t, -s * ray.x / length, -s * ray.y / length);
}

Eikonal::Ray Eikonal::best_ray(const Node& p, double px, double py, const Node& q, double qx,
                               double qy, double s) {
  const double ex = qx - px, ey = qy - py, rise = q.t - p.t;
  double from_p = p.gx * ex + p.gy * ey, from_q = q.gx * ex + q.gy * ey;
  // Where rays from different sides meet, or at a corner of matter, the gradients do not belong to
  // one smooth front: t is taken as linear.
  const double least = 0.25 * s * std::hypot(ex, ey);
  if (std::fabs(from_p - rise) > least || std::fabs(from_q - rise) > least) from_p = from_q = rise;
  const double c2 = 3 * rise - 2 * from_p - from_q, c3 = from_p + from_q - 2 * rise;
  const auto ray = [&](double k) {
    const double x = px + k * ex, y = py + k * ey;
    return Ray{p.t + k * (from_p + k * (c2 + k * c3)) + s * std::hypot(x, y), x, y};
  };
  const auto slope = [&](double k) {
    const double x = px + k * ex, y = py + k * ey, length = std::hypot(x, y);
    return from_p + k * (2 * c2 + k * 3 * c3) + (length > 0 ? s * (x * ex + y * ey) / length : 0);
  };
  double low = 0, high = 1, at_low = slope(0), at_high = slope(1);
  if (at_low >= 0) return ray(0);
  if (at_high <= 0) return ray(1);
  // The root of the slope by the Illinois form of false position; an error of 1e-7 in the place is
  // one of 1e-14 in time.
  for (int k = 0; k < 30 && high - low > 1e-7; ++k) {
    const double middle = low + (high - low) * at_low / (at_low - at_high), there = slope(middle);
    if (there == 0) return ray(middle);
    if (there < 0) {
      low = middle;
      at_low = there;
      at_high *= 0.5;
    } else {
      high = middle;
      at_high = there;
      at_low *= 0.5;
    }
  }
  return ray(low + (high - low) * at_low / (at_low - at_high));
}

double Eikonal::at(double x, double y) const {
  const int i = static_cast<int>(std::floor((x - box_.low[0]) / box_.h)),
            j = static_cast<int>(std::floor((y - box_.low[1]) / box_.h));
  const double s = slowness(i, j);
  if (!(s > 0)) return beside(x, y);
  double earliest = never;
  const int corners[] = {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
  for (int k = 0; k < 4; ++k) {
    const int p = corners[k], q = corners[(k + 1) % 4];
    if (!nodes_[p].settled || !nodes_[q].settled) continue;
    const auto dx = [&](int n) { return coordinate(0, n % nodes(0)) - x; };
    const auto dy = [&](int n) { return coordinate(1, n / nodes(0)) - y; };
    earliest = std::min(earliest, best_ray(nodes_[p], dx(p), dy(p), nodes_[q], dx(q), dy(q), s).t);
  }
  return earliest;
}

double Eikonal::beside(double x, double y) const {
  const int i = static_cast<int>(std::lround((x - box_.low[0]) / box_.h)),
            j = static_cast<int>(std::lround((y - box_.low[1]) / box_.h));
  double nearest = 2.5 * box_.h, time = never;
  for (int b = std::max(j - 2, 0); b <= std::min(j + 2, box_.cells[1]); ++b)
    for (int a = std::max(i - 2, 0); a <= std::min(i + 2, box_.cells[0]); ++a) {
      const Node& n = nodes_[node(a, b)];
      const double dx = x - coordinate(0, a), dy = y - coordinate(1, b);
      const double away = std::hypot(dx, dy);
      if (!n.settled || away >= nearest) continue;
      nearest = away;
      time = n.t + n.gx * dx + n.gy * dy;
    }
  return time;
}

}  // namespace brisance
