#include "drivers/shapes.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <string>

#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

using Doubles = std::vector<double>;

constexpr double lowest = std::numeric_limits<double>::lowest(),
                 greatest = std::numeric_limits<double>::max();

const std::array<const char*, 5> forms = {"box", "half-plane", "disc", "ring", "polygon"};

/// The coordinates of a list, those it lacks at `otherwise`.
Place corner(const List& list, const std::string& name, double otherwise) {
  Place x{{otherwise, otherwise, otherwise}};
  const auto given = get<Doubles>(list, name);
  std::copy(given.begin(), given.end(), x.begin());
  return x;
}

struct Corner {
  double x, y;
};

/// Twice the area of a triangle, positive if it runs counter-clockwise. [m^2]
double turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool within(const Corner& a, const Corner& b, const Corner& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  const auto apart = [](double u, double v) { return (u > 0 && v < 0) || (u < 0 && v > 0); };
  if (apart(abc, abd) && apart(cda, cdb)) return true;
  return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) ||
         (cda == 0 && within(c, d, a)) || (cdb == 0 && within(c, d, b));
}

std::vector<Corner> corners_of(const List& polygon) {
  const auto x = get<Doubles>(polygon, "x"), y = get<Doubles>(polygon, "y");
  std::vector<Corner> corners;
  for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) corners.push_back({x[k], y[k]});
  return corners;
}

void check_polygon(const List& polygon) {
  const std::size_t count = get<Doubles>(polygon, "x").size();
  if (count != get<Doubles>(polygon, "y").size())
    refuse(polygon, "y", "must have as many entries as 'x'");
  if (count < 3) refuse(polygon, "x", "must have three corners or more");
  const auto c = corners_of(polygon);
  for (std::size_t i = 0; i < count; ++i) {
    const Corner &a = c[i], &b = c[(i + 1) % count], &after = c[(i + 2) % count];
    const bool back = turn(a, b, after) == 0 &&
                      (after.x - b.x) * (b.x - a.x) + (after.y - b.y) * (b.y - a.y) <= 0;
    if (back) refuse(polygon, "x", "must not name a corner twice, nor run back on an edge");
    for (std::size_t j = i + 2; j < count && j + 1 < count + i; ++j)
      if (meet(a, b, c[j], c[(j + 1) % count]))
        refuse(polygon, "x", "must be the corners in turn: the edges meet each other");
  }
}

}  // namespace

Shape::Shape(const List& body, double same) : same_(same) {
  if (const List* box = find_list(body, "box")) {
    form_ = Box{corner(*box, "low", lowest), corner(*box, "high", greatest)};
  } else if (const List* half = find_list(body, "half-plane")) {
    const Place point = place_of(*half, "point"), normal = place_of(*half, "normal");
    const double length = std::hypot(normal[0], normal[1]);
    const Place unit{{normal[0] / length, normal[1] / length, 0}};
    form_ = HalfPlane{unit, unit[0] * point[0] + unit[1] * point[1]};
  } else if (const List* disc = find_list(body, "disc")) {
    form_ = Ring{place_of(*disc, "centre"), 0, std::pow(get<double>(*disc, "radius") - same, 2)};
  } else if (const List* ring = find_list(body, "ring")) {
    form_ = Ring{place_of(*ring, "centre"), std::pow(get<double>(*ring, "inner radius") - same, 2),
                 std::pow(get<double>(*ring, "outer radius") - same, 2)};
  } else if (const List* polygon = find_list(body, "polygon")) {
    form_ = polygon_of(*polygon);
  }
}

// What is on an edge counts as a hair above and to the right of it. The golden ratio keeps that
// hair off the directions of edges that people draw.
bool Shape::holds(const Place& x) const {
  const Place lifted{{x[0] + same_, x[1] + 0.6180339887498949 * same_, 0}};
  return std::visit(
      [&](const auto& form) {
        return has(form, std::is_same_v<std::decay_t<decltype(form)>, Ring> ? x : lifted);
      },
      form_);
}

bool Shape::has(const Box& box, const Place& x) {
  return x[0] >= box.low[0] && x[0] < box.high[0] && x[1] >= box.low[1] && x[1] < box.high[1];
}

bool Shape::has(const HalfPlane& half, const Place& x) {
  return half.normal[0] * x[0] + half.normal[1] * x[1] < half.offset;
}

bool Shape::has(const Ring& ring, const Place& x) {
  const double dx = x[0] - ring.centre[0], dy = x[1] - ring.centre[1], r2 = dx * dx + dy * dy;
  return r2 >= ring.inner2 && r2 < ring.outer2;
}

// A ray to the right crosses the edges of what holds its start an odd number of times.
bool Shape::has(const Polygon& polygon, const Place& x) {
  if (x[0] < polygon.low[0] || x[0] > polygon.high[0] || x[1] < polygon.low[1] ||
      x[1] > polygon.high[1])
    return false;
  bool inside = false;
  for (const auto& e : polygon.edges) {
    const double up = x[1] - e.y;
    if (up >= 0 && up < e.dy && (x[0] - e.x) * e.dy < up * e.dx) inside = !inside;
  }
  return inside;
}

Shape::Polygon Shape::polygon_of(const List& list) {
  Polygon polygon{{}, {{greatest, greatest, 0}}, {{lowest, lowest, 0}}};
  const auto corners = corners_of(list);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Corner a = corners[k], b = corners[(k + 1) % corners.size()];
    polygon.low = {{std::min(polygon.low[0], a.x), std::min(polygon.low[1], a.y), 0}};
    polygon.high = {{std::max(polygon.high[0], a.x), std::max(polygon.high[1], a.y), 0}};
    if (a.y == b.y) continue;
    if (a.y > b.y) std::swap(a, b);
    polygon.edges.push_back({a.x, a.y, b.x - a.x, b.y - a.y});
  }
  return polygon;
}

void declare_shapes(List& valid, const List& given, int dim) {
  const auto point = [&](List& list, const char* name, const char* doc) {
    declare_required<Doubles>(list, name, anything() && entries(dim), doc);
  };
  List& box = declare_optional_list(valid, "box", "the body is a box");
  point(box, "low", "low corner [m]");
  point(box, "high", "high corner [m]");
  List& half = declare_optional_list(valid, "half-plane", "the body is all on one side of an edge");
  point(half, "point", "a place on the edge [m]");
  point(half, "normal", "direction out of the matter, of any length [-]");
  if (dim == 1) {
    for (const char* form : {"disc", "ring", "polygon"})
      if (find_list(given, form))
        refuse(*find_list(given, form), "",
               "needs a plane: on a line a body is a 'box' or a 'half-plane'");
    return;
  }
  List& disc = declare_optional_list(valid, "disc", "the body is a disc");
  point(disc, "centre", "centre [m]");
  declare_required<double>(disc, "radius", positive(), "radius [m]");
  List& ring = declare_optional_list(valid, "ring", "the body lies between two circles");
  point(ring, "centre", "centre [m]");
  declare_required<double>(ring, "inner radius", positive(), "radius of the hole [m]");
  declare_required<double>(ring, "outer radius", positive(), "radius [m]");
  List& polygon =
      declare_optional_list(valid, "polygon", "the body has straight edges from corner to corner");
  declare_required<Doubles>(polygon, "x", anything(), "x of the corners in turn, either way [m]");
  declare_required<Doubles>(polygon, "y", anything(), "y of the corners [m]");
}

void check_shape(const List& body) {
  const List* shape = nullptr;
  std::string name;
  for (const char* form : forms) {
    const List* list = find_list(body, form);
    if (!list) continue;
    if (shape) refuse(*list, "", "stands beside '" + name + "': a body has one shape");
    shape = list;
    name = form;
  }
  if (name == "box") {
    const auto low = get<Doubles>(*shape, "low"), high = get<Doubles>(*shape, "high");
    for (std::size_t d = 0; d < low.size(); ++d)
      if (!(low[d] < high[d])) refuse(*shape, "high", "must be above 'low' along each direction");
  } else if (name == "half-plane") {
    const Place normal = place_of(*shape, "normal");
    if (normal[0] == 0 && normal[1] == 0) refuse(*shape, "normal", "must have a direction");
  } else if (name == "ring") {
    if (!(get<double>(*shape, "inner radius") < get<double>(*shape, "outer radius")))
      refuse(*shape, "outer radius", "must be above 'inner radius'");
  } else if (name == "polygon") {
    check_polygon(*shape);
  }
}

}  // namespace brisance
