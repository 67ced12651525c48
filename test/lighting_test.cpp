// Lighting times against the burn time problems of Kenamond, HE Burn Table Verification Problems
// (2011), and other exact ways.
#include "drivers/lighting.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/measure.hpp"

namespace brisance {
namespace {

using Doubles = Teuchos::Array<double>;
Doubles array_of(const std::vector<double>& values) { return Doubles(values); }
using Speed = std::function<double(const Place&)>;

double apart(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

List through() {
  List list;
  return list.set("path", "through explosive");
}

List& source(List& list, const std::string& name, double delay) {
  return list.sublist("sources").sublist(name).set("delay", delay);
}
void add_point(List& list, const std::string& name, double x, double y, double delay = 0) {
  source(list, name, delay).set("point", array_of({x, y}));
}
void add_obstacle(List& list, const std::string& name, double x, double y, double radius) {
  list.sublist("obstacles").sublist(name).set("centre", array_of({x, y})).set("radius", radius);
}

/// On the square from -size to size, of n x n cells.
LightingTimes times(const List& given, double size, int n, const Speed& speed) {
  const List checked = check(given, valid_ignition(given, 2));
  check_ignition(checked);
  return {checked, {{-size, -size}, 2 * size / n, {n, n}}, speed};
}

/// The greatest error at four places in each cell; at those where the answer is negative there is
/// none.
template <class F>
double worst(const LightingTimes& times, double size, int n, const F& exact) {
  double error = 0;
  for (int j = 0; j < 2 * n; ++j)
    for (int i = 0; i < 2 * n; ++i) {
      const Place x{{-size + (i + 0.5) * size / n, -size + (j + 0.5) * size / n, 0}};
      const double t = exact(x);
      if (t >= 0) error = std::max(error, std::fabs(times.at(x) - t));
    }
  return error;
}

// Problem 1: one explosive, one point. The way of a ray over edges with cubic times is wrong by
// its fifth power over the distance, in all by some thousandth of what a cell takes.
TEST(Lighting, OfOneExplosiveFromOnePointIsByDistance) {
  const Place from{{0.37, -1.21, 0}};
  const auto exact = [&](const Place& x) { return 0.5 + apart(x, from) / 2; };
  const Speed speed = [](const Place&) { return 2; };
  List given;
  add_point(given, "detonator", from[0], from[1], 0.5);
  EXPECT_LT(worst(times(given, 10, 20, speed), 10, 20, exact), 1e-14);
  given.set("path", "through explosive");
  for (const int n : {20, 50, 100})
    EXPECT_LT(worst(times(given, 10, n, speed), 10, n, exact), 3e-3 * 20 / n / 2) << n;
}

// Problem 2: a disc of radius 3 with D = 2 in an explosive with D = 1, lit in its middle and at
// four points outside, later. Radial rays are not bent where they leave the disc.
double of_problem_2(const Place& x) {
  const double r = std::hypot(x[0], x[1]);
  double t = r < 3 ? r / 2 : 1.5 + (r - 3);
  for (const double y : {-10, -5, 5, 10})
    t = std::min(t, apart(x, {{0, y, 0}}) + (std::fabs(y) < 7 ? 1 : 2));
  return t;
}

// The rim, known to parts of a cell only, costs some share of a cell's time.
TEST(Lighting, OfTwoExplosivesFromFivePointsConverges) {
  List given = through();
  add_point(given, "middle", 0, 0);
  for (const int y : {-10, -5, 5, 10})
    add_point(given, "y = " + std::to_string(y), 0, y, std::abs(y) < 7 ? 1 : 2);
  const Speed speed = [](const Place& x) { return std::hypot(x[0], x[1]) < 3 ? 2 : 1; };
  std::vector<double> h, error;
  for (const int n : {50, 100, 200}) {
    h.push_back(20. / n);
    error.push_back(worst(times(given, 10, n, speed), 10, n, of_problem_2));
    EXPECT_LT(error.back(), 0.25 * h.back());
    RecordProperty("error at " + std::to_string(n), std::to_string(error.back()));
  }
  EXPECT_GT(order(h, error), 0.8);
}

// Problem 3: an inert disc of radius 3 about 0 in an explosive with D = 2, lit at (0, 5): by
// distance where the detonator is seen, else by tangent, arc and tangent. Negative: inside, or
// nearer to the disc than `margin`.
double of_problem_3(const Place& x, double margin) {
  const double r = std::hypot(x[0], x[1]), angle = std::atan2(std::fabs(x[0]), x[1]);
  if (r < 3 + margin) return -1;
  const double arc = angle - std::acos(3. / 5) - std::acos(3 / r);
  if (arc < 0) return apart(x, {{0, 5, 0}}) / 2;
  return (4 + 3 * arc + std::sqrt(r * r - 9)) / 2;
}

const Speed two = [](const Place&) { return 2; };

TEST(Lighting, BehindARoundObstacleIsByTangentAndArc) {
  List given = through();
  add_point(given, "detonator", 0, 5);
  add_obstacle(given, "lead", 0, 0, 3);
  for (const int n : {50, 100, 200}) {
    const double h = 20. / n, e = worst(times(given, 10, n, two), 10, n,
                                        [&](const Place&x) { return of_problem_3(x, 2 * h); });
    EXPECT_LT(e, 0.02 * h / 2) << n;
    RecordProperty("error at " + std::to_string(n), std::to_string(e));
  }
}

// The same with a hole in the explosive that is known by its cells alone: corners of its steps
// stand out by half the diagonal of a cell at most, round which the way turns by pi - acos(3 / 5)
// = 2.214.
TEST(Lighting, BehindAnInertBodyConverges) {
  List given = through();
  add_point(given, "detonator", 0, 5);
  const Speed speed = [](const Place& x) { return std::hypot(x[0], x[1]) < 3 ? 0 : 2; };
  std::vector<double> h, error;
  for (const int n : {100, 200, 400}) {
    h.push_back(20. / n);
    error.push_back(worst(times(given, 10, n, speed), 10, n,
                          [&](const Place& x) { return of_problem_3(x, 2 * h.back()); }));
    EXPECT_LT(error.back(), 2.214 * std::sqrt(0.5) * h.back() / 2);
    RecordProperty("error at " + std::to_string(n), std::to_string(error.back()));
  }
  EXPECT_GT(order(h, error), 0.8);
}

// Two discs of radius 1 at (-3, 0) and (3, 0), lit at (-8, 0): along y = 1 from one to the other.
TEST(Lighting, BehindTwoObstaclesIsByTheBeltAboutThem) {
  List given = through();
  add_point(given, "detonator", -8, 0);
  add_obstacle(given, "first", -3, 0, 1);
  add_obstacle(given, "second", 3, 0, 1);
  const double tangent = std::sqrt(24.), arc = std::asin(1. / 5);
  const double exact = 2 * tangent + 2 * arc + 6;
  for (const int n : {100, 200})
    EXPECT_NEAR(times(given, 10, n, two).at({{8, 0, 0}}), exact / 2, 2 * (20. / n) / 2) << n;
}

// A wall from x = -1 to 1 below y = 2; from its corner on the front is a circle about it.
TEST(Lighting, BehindAWallIsByItsCorner) {
  List given = through();
  add_point(given, "detonator", -5, 0);
  const Speed speed = [](const Place& x) { return std::fabs(x[0]) < 1 && x[1] < 2 ? 0 : 2; };
  const auto exact = [&](const Place& x) {
    if (x[0] < 2 || x[1] > 2) return -1.;
    return (std::hypot(4, 2) + 2 + apart(x, {{1, 2, 0}})) / 2;
  };
  for (const int n : {20, 40, 80})
    EXPECT_LT(worst(times(given, 10, n, speed), 10, n, exact), 0.3 * (20. / n) / 2) << n;
}

// Two layers that meet in y = 0, lit there: in the slower one above, the front in the faster one
// below sends a straight one ahead of the circle.
TEST(Lighting, OfASlowLayerIsByTheWaveFromTheFastOne) {
  List given = through();
  add_point(given, "detonator", 0, 0);
  const Speed speed = [](const Place& x) { return x[1] < 0 ? 2 : 1; };
  const auto exact = [](const Place& x) {
    const double r = std::hypot(x[0], x[1]);
    if (x[1] < 0) return r / 2;
    const double ahead = std::fabs(x[0]) / 2 + x[1] * std::sqrt(1 - 0.25);
    return x[1] < std::fabs(x[0]) * std::sqrt(3.) ? std::min(r, ahead) : r;
  };
  for (const int n : {20, 40, 80})
    EXPECT_LT(worst(times(given, 10, n, speed), 10, n, exact), 0.2 * (20. / n)) << n;
}

// Waves leave lines and planes at right angles, and planes on the face of what they light.
TEST(Lighting, FromLinesAndPlanesIsByDistanceToThem) {
  const Speed block = [](const Place& x) { return std::fabs(x[1]) < 3 ? 2 : 0; };
  for (const char* path : {"straight", "through explosive"}) {
    List line, plane;
    for (List* list : {&line, &plane}) list->set("path", path);
    source(line, "line", 0)
        .sublist("line")
        .set("from", array_of({-2, 1}))
        .set("to", array_of({2, 1}));
    source(plane, "plane", 0)
        .sublist("plane")
        .set("point", array_of({7, 3}))
        .set("normal", array_of({0, 5}));
    const auto to_line = [](const Place& x) {
      if (std::fabs(x[1]) > 3) return -1.;
      return apart(x, {{std::clamp(x[0], -2., 2.), 1, 0}}) / 2;
    };
    const auto to_plane = [](const Place& x) { return x[1] > -3 ? (3 - x[1]) / 2 : -1; };
    EXPECT_LT(worst(times(line, 10, 40, block), 10, 40, to_line), 2e-3 * 0.5 / 2) << path;
    EXPECT_LT(worst(times(plane, 10, 40, block), 10, 40,
                    [&](const Place& x) { return x[1] > 3 ? -1 : to_plane(x); }),
              1e-12)
        << path;
  }
}

TEST(Lighting, OnALineIsByDistance) {
  List given = through();
  given.sublist("sources").sublist("left").set("point", Doubles(1, 0.25)).set("delay", 1.);
  given.sublist("sources").sublist("right").set("point", Doubles(1, 9.75)).set("delay", 2.);
  const List checked = check(given, valid_ignition(given, 1));
  const LightingTimes times(checked, {{0, 0}, 0.5, {20, 1}}, two);
  for (const double x : {0., 0.25, 0.3, 1.7, 5., 6.2, 9.9, 10.})
    EXPECT_NEAR(times.at({{x, 0, 0}}),
                std::min(1 + std::fabs(x - 0.25) / 2, 2 + std::fabs(x - 9.75) / 2), 1e-13)
        << x;
}

TEST(Lighting, ReachesNothingBehindAGap) {
  List given = through();
  add_point(given, "detonator", -5, 0);
  const Speed speed = [](const Place& x) { return std::fabs(x[0]) < 2 ? 0 : 2; };
  const auto t = times(given, 10, 40, speed);
  EXPECT_EQ(t.at({{5, 0, 0}}), never);
  EXPECT_LT(t.at({{-9, 9, 0}}), 10);
  given.set("path", "straight");
  EXPECT_DOUBLE_EQ(times(given, 10, 40, speed).at({{5, 0, 0}}), 5);
  EXPECT_EQ(times(given, 10, 40, speed).at({{0, 0, 0}}), never);
}

TEST(Lighting, OnARefinedGridIsThatOfAFinerOne) {
  List given = through();
  add_point(given, "detonator", 0, 5);
  const Speed speed = [](const Place& x) { return std::hypot(x[0], x[1]) < 3 ? 0 : 2; };
  const auto fine = times(given, 10, 60, speed);
  given.set("refinement", 3);
  const auto refined = times(given, 10, 20, speed);
  for (const double y : {-3.5, -6., -9.})
    EXPECT_DOUBLE_EQ(refined.at({{1, y, 0}}), fine.at({{1, y, 0}}));
}

std::string wrong(const List& given, const Speed& speed = two) {
  try {
    times(given, 10, 20, speed);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Lighting, RefusesWhatLightsNothing) {
  List given = through();
  EXPECT_NE(wrong(given).find("must name a source"), std::string::npos);
  add_point(given, "detonator", 0, 5);
  EXPECT_EQ(wrong(given), "");
  EXPECT_NE(wrong(given, [](const Place& x) { return x[1] < 0 ? 2 : 0; }).find("lights nothing"),
            std::string::npos);
  List& one = given.sublist("sources").sublist("detonator");
  one.sublist("plane").set("point", array_of({0, 0})).set("normal", array_of({0, 0}));
  EXPECT_NE(wrong(given).find("more than one"), std::string::npos);
  one.remove("point");
  EXPECT_NE(wrong(given).find("direction"), std::string::npos);
  one.remove("plane");
  EXPECT_NE(wrong(given).find("point"), std::string::npos);
  List straight;
  add_point(straight, "detonator", 0, 5);
  add_obstacle(straight, "lead", 0, 0, 3);
  EXPECT_NE(wrong(straight).find("through explosive"), std::string::npos);
}

}  // namespace
}  // namespace brisance
