#include "drivers/shapes.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <set>

#include "drivers/files.hpp"
#include "drivers/run.hpp"
#include "drivers/scene.hpp"
#include "drivers/simulation.hpp"
#include "test/program.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using Doubles = Teuchos::Array<double>;
Doubles array_of(const std::vector<double>& values) { return Doubles(values); }

List polygon(const std::vector<double>& x, const std::vector<double>& y) {
  List body;
  body.sublist("polygon").set("x", Doubles(x)).set("y", Doubles(y));
  return body;
}
List half_plane(double x, double y, double nx, double ny) {
  List body;
  body.sublist("half-plane").set("point", array_of({x, y})).set("normal", array_of({nx, ny}));
  return body;
}
List box(double x0, double y0, double x1, double y1) {
  List body;
  body.sublist("box").set("low", array_of({x0, y0})).set("high", array_of({x1, y1}));
  return body;
}
List disc(double x, double y, double radius) {
  List body;
  body.sublist("disc").set("centre", array_of({x, y})).set("radius", radius);
  return body;
}
List ring(double x, double y, double inner, double outer) {
  List body;
  body.sublist("ring")
      .set("centre", array_of({x, y}))
      .set("inner radius", inner)
      .set("outer radius", outer);
  return body;
}

/// How many of these bodies hold the places of a lattice that has some on all their edges: the
/// least and the most.
std::pair<int, int> owners(const std::vector<List>& bodies, double x0, double x1, double y0,
                           double y1) {
  std::vector<Shape> shapes;
  for (const List& body : bodies) shapes.emplace_back(body, 1e-12);
  std::pair<int, int> range{99, 0};
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      // In hundredths, with the round-off of a lattice.
      const Place x{{x0 + (x1 - x0) * (0.01 * i), y0 + (y1 - y0) * (0.01 * j), 0}};
      int held = 0;
      for (const Shape& shape : shapes) held += shape.holds(x);
      range = {std::min(range.first, held), std::max(range.second, held)};
    }
  return range;
}

TEST(Shapes, ThatShareEdgesShareNoPlaceAndLeaveNoneOut) {
  const auto one = std::make_pair(1, 1);
  EXPECT_EQ(owners({polygon({0, 1, 1}, {0, 0, 1}), polygon({0, 1, 0}, {0, 1, 1})}, 0, 1, 0, 1),
            one);
  // The same with edges of other slopes, through the place (0.3, 0.7), some run the other way.
  EXPECT_EQ(owners({polygon({0, 1, 0.3}, {0, 0, 0.7}), polygon({1, 1, 0.3}, {1, 0, 0.7}),
                    polygon({1, 0, 0.3}, {1, 1, 0.7}), polygon({0, 0, 0.3}, {0, 1, 0.7})},
                   0, 1, 0, 1),
            one);
  EXPECT_EQ(
      owners({box(0, 0, 0.3, 1), box(0.3, 0, 1, 0.7), polygon({0.3, 1, 1, 0.3}, {0.7, 0.7, 1, 1})},
             0, 1, 0, 1),
      one);
  EXPECT_EQ(owners({disc(0.5, 0.5, 0.25), ring(0.5, 0.5, 0.25, 2)}, 0, 1, 0, 1), one);
  for (const auto& [nx, ny] : {std::pair{1., 0.}, {0., 1.}, {1., 1.}, {1., -1.}, {-2., 1.}})
    EXPECT_EQ(owners({half_plane(0.3, 0.7, nx, ny), half_plane(0.3, 0.7, -nx, -ny)}, 0, 1, 0, 1),
              one);
}

TEST(Shapes, HoldWhatIsInside) {
  const Shape u(polygon({0, 3, 3, 2, 2, 1, 1, 0}, {0, 0, 3, 3, 1, 1, 3, 3}), 1e-12);
  for (const auto& [x, y, held] : {std::tuple{0.5, 2.5, true},
                                   {1.5, 2.5, false},
                                   {2.5, 2.5, true},
                                   {1.5, 0.5, true},
                                   {3.5, 0.5, false},
                                   {-0.5, 2.9, false}})
    EXPECT_EQ(u.holds({{x, y, 0}}), held) << x << " " << y;
  const Shape r(ring(1, 2, 0.5, 1), 1e-12), h(half_plane(0, 0, 3, 4), 1e-12);
  EXPECT_TRUE(r.holds({{1.6, 2.1, 0}}));
  EXPECT_FALSE(r.holds({{1.3, 2.1, 0}}));
  EXPECT_FALSE(r.holds({{1.9, 2.5, 0}}));
  EXPECT_TRUE(h.holds({{3.9, -3, 0}}));
  EXPECT_FALSE(h.holds({{4.1, -3, 0}}));
  EXPECT_TRUE(Shape(List(), 1e-12).holds({{1e9, -1e9, 0}}));
}

/// The scene of the tests with its first body of another shape, on so many cells about 0.
List shaped(const List& shape, int cells, const std::string& edge) {
  List given = test::scene(2);
  given.sublist("grid")
      .set("cells", Teuchos::Array<int>(2, cells))
      .set("origin", Doubles(2, -0.05 * cells));
  List& body = given.sublist("bodies").sublist("first");
  body.remove("box");
  for (const auto& name : list_names(shape)) body.sublist(name) = shape.sublist(name);
  body.set("edge", edge).set("density", 2.);
  given.sublist("bodies").remove("rest");
  return given;
}

using Site = std::pair<long, long>;

/// Where the particles of a scene are, in 1/24 of the cell size of 0.1.
std::set<Site> sites(const List& given) {
  const auto table = make_simulation(complete_scene(given), nullptr)->snapshot().table;
  std::set<Site> found;
  for (std::size_t k = 0; k < table.size(); ++k)
    found.insert({std::lround(240 * table.x[k]), std::lround(240 * table.y[k])});
  EXPECT_EQ(found.size(), table.size());
  return found;
}

// Particles at odd multiples of 1/60 lie on the circles: 0.5^2 = 0.3^2 + 0.4^2, and so do the
// centres of cells, at multiples of 0.1 if their number is odd.
TEST(Bodies, RoundAboutTheMiddleOfTheGridAreSeededSymmetrically) {
  for (const char* edge : {"points", "cells"})
    for (const int cells : {19, 20})
      for (const List& shape : {disc(0, 0, 0.5), ring(0, 0, 0.25, 0.5)}) {
        const auto all = sites(shaped(shape, cells, edge));
        EXPECT_GT(all.size(), 400u);
        for (const auto& [x, y] : all)
          for (const Site& image : {Site{-x, y}, Site{x, -y}, Site{y, x}})
            EXPECT_EQ(all.count(image), 1u) << x << " " << y << " " << edge;
      }
}

TEST(Bodies, OfSeveralFinenessesOwnEveryPlaceOnce) {
  List given = shaped(disc(0, 0, 0.5), 20, "points");
  List& bodies = given.sublist("bodies");
  bodies.sublist("first").set("particles per cell", 2);
  List rest = bodies.sublist("first");
  rest.remove("disc");
  rest.set("particles per cell", 4).set("density", 1.);
  bodies.sublist("rest") = rest;
  const auto table = make_simulation(complete_scene(given), nullptr)->snapshot().table;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const bool inside = std::hypot(table.x[k], table.y[k]) < 0.5;
    EXPECT_EQ(table.density[k], inside ? 2 : 1);
    EXPECT_NEAR(table.volume[k], inside ? 0.01 / 4 : 0.01 / 16, 1e-17);
  }
}

std::string wrong(const List& given) {
  try {
    complete_scene(given);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Shapes, AreRefusedWhereTheyEncloseNothing) {
  const std::pair<List, const char*> mistakes[] = {
      {polygon({0, 1}, {0, 0}), "three corners"},
      {polygon({0, 1, 1}, {0, 0}), "as many entries"},
      {polygon({0, 1, 0, 1}, {0, 0, 1, 1}), "meet"},
      {polygon({0, 1, 1, 0, 0.5}, {0, 0, 1, 1, 0}), "meet"},
      {polygon({0, 1, 0.5, 0}, {0, 0, 0, 1}), "run back"},
      {ring(0, 0, 1, 1), "above 'inner radius'"},
      {half_plane(0, 0, 0, 0), "direction"},
      {box(0, 0, 1, 0), "above 'low'"}};
  for (const auto& [shape, told] : mistakes) {
    const std::string message = wrong(shaped(shape, 10, "points"));
    EXPECT_NE(message.find(told), message.npos) << message;
  }
  List two = disc(0, 0, 1);
  two.sublist("ring") = ring(0, 0, 1, 2).sublist("ring");
  EXPECT_NE(wrong(shaped(two, 10, "points")).find("one shape"), std::string::npos);
  EXPECT_EQ(wrong(shaped(polygon({0, 1, 0}, {0, 0, 1}), 10, "points")), "");
}

TEST(Shapes, OnALineAreBoxesAndHalfPlanes) {
  List given = test::scene(1);
  List& body = given.sublist("bodies").sublist("first");
  body.remove("box");
  body.set("density", 2.);
  body.sublist("half-plane").set("point", Doubles(1, 0.5)).set("normal", Doubles(1, 1.));
  const auto table = make_simulation(complete_scene(given), nullptr)->snapshot().table;
  for (std::size_t k = 0; k < table.size(); ++k)
    EXPECT_EQ(table.density[k], table.x[k] < 0.5 ? 2 : 1);
  body.remove("half-plane");
  body.sublist("disc").set("centre", Doubles(1, 0.)).set("radius", 1.);
  EXPECT_NE(wrong(given).find("on a line a body is a 'box' or a 'half-plane'"), std::string::npos);
}

TEST(FreeEnd, TellsWhatHasLeft) {
  const List scene = test::scene(1, {"boundaries/x high=free", "bodies/rest/velocity={30}",
                                     "bodies/rest/pressure=0.01", "time/end=0.05"});
  const test::Folder folder("left");
  RunOptions options;
  options.folder = folder.path;
  options.quiet = true;
  const Balance end = run(scene, options).end;
  ASSERT_GT(end.left, 20);
  const std::string log = read_file(folder.path / "log.txt"),
                    told = "left the grid: " + std::to_string(end.left) + " particles with ";
  EXPECT_NE(log.find(told), log.npos) << log;
  const auto last = test::columns_of_last_line(read_file(folder.path / "history.csv"));
  EXPECT_EQ(last.at(15), std::to_string(end.left));
  EXPECT_EQ(std::stod(last.at(16)), end.outflow.momentum[0]);
  EXPECT_EQ(std::stod(last.at(19)) + std::stod(last.at(20)), end.outflow.total());
}

}  // namespace
}  // namespace brisance
