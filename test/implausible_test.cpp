// Scenes whose values are each allowed and together cannot be meant.
#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <limits>

#include "drivers/budget.hpp"
#include "drivers/input.hpp"
#include "drivers/locations.hpp"
#include "drivers/scene.hpp"
#include "drivers/simulation.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using Doubles = Teuchos::Array<double>;
Doubles array_of(const std::vector<double>& values) { return Doubles(values); }

/// What is told of a scene, when it is completed or when it is set up.
std::string wrong(const List& given) {
  try {
    make_simulation(complete_scene(given), nullptr);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_told(const List& given, const std::string& told) {
  const std::string message = wrong(given);
  EXPECT_NE(message.find(told), message.npos) << message;
}

List body(const std::string& material) {
  List list;
  list.set("material", material).set("edge", "points").set("particles per cell", 2);
  return list;
}
List box(const std::string& material, double x0, double y0, double x1, double y1) {
  List list = body(material);
  list.sublist("box").set("low", array_of({x0, y0})).set("high", array_of({x1, y1}));
  return list;
}
List disc(const std::string& material, double x, double y, double radius) {
  List list = body(material);
  list.sublist("disc").set("centre", array_of({x, y})).set("radius", radius);
  return list;
}

/// A square of 2 m with 20 x 20 cells, two solids, an explosive that is burnt at once, and a gas.
List square(const std::vector<std::pair<std::string, List>>& bodies) {
  List given = test::scene(2);
  given.sublist("grid").set("cells", Teuchos::Array<int>(2, 20));
  List& materials = given.sublist("materials");
  for (const char* name : {"steel", "concrete"}) materials.sublist(name) = test::elastic_material();
  materials.sublist("tnt")
      .set("law", "jwl")
      .set("burn", "at once")
      .set("density", 1630.)
      .set("A", 373.8e9)
      .set("B", 3.747e9)
      .set("R1", 4.15)
      .set("R2", 0.9)
      .set("omega", 0.35)
      .set("energy density", 6e9)
      .set("detonation speed", 6930.);
  given.remove("bodies");
  for (const auto& [name, list] : bodies) {
    List& added = given.sublist("bodies").sublist(name);
    added.setParameters(list);
    if (get<std::string>(list, "material") == "gas") added.set("density", 1.).set("pressure", 1.);
  }
  return given;
}

void set_ends(List& given, const char* kind) {
  for (const char* end : {"x low", "x high", "y low", "y high"})
    given.sublist("boundaries").set(end, kind);
}

TEST(Overlap, OfTwoUnlikeSolidsOrExplosivesIsRefusedUnlessItIsMeant) {
  const std::string told = "list 'bodies/wall' overlaps 'flyer', which does not lie within it";
  for (const char* material : {"steel", "tnt"}) {
    const List flyer = box(material, 0.5, 0.5, 1.0, 1.0);
    List wall = box("concrete", 0.9, 0.2, 1.3, 1.8);
    expect_told(square({{"flyer", flyer}, {"wall", wall}}), told);
    wall.set("may overlap", true);
    EXPECT_EQ(wrong(square({{"flyer", flyer}, {"wall", wall}})), "");
  }
  // A point's width is enough, and what only touches is none.
  const List flyer = disc("steel", 0.5, 1, 0.4);
  expect_told(square({{"flyer", flyer}, {"wall", box("concrete", 0.87, 0, 1.3, 2)}}), told);
  EXPECT_EQ(wrong(square({{"flyer", flyer}, {"wall", box("concrete", 0.9, 0, 1.3, 2)}})), "");
}

TEST(Overlap, IsNoneWhereBodiesAreNestedAlikeOrFluid) {
  const List charge = disc("tnt", 1, 1, 0.3), casing = disc("steel", 1, 1, 0.5),
             air = box("gas", 0.3, 0.3, 1.7, 1.7), wall = box("concrete", 0.1, 0.1, 1.9, 1.9);
  EXPECT_EQ(wrong(square({{"charge", charge}, {"case", casing}, {"air", air}, {"wall", wall}})),
            "");
  // A plate longer than the air that it stands in, a piece that a like one touches, and the rest.
  EXPECT_EQ(wrong(square({{"plate", box("steel", 1, 0, 1.2, 2)}, {"air", air}})), "");
  EXPECT_EQ(wrong(square({{"a", disc("steel", 0.8, 1, 0.4)}, {"b", disc("steel", 1.2, 1, 0.4)}})),
            "");
  EXPECT_EQ(wrong(square({{"a", casing}, {"rest", body("concrete")}})), "");
}

TEST(BodyOutside, OfTheGridIsRefused) {
  for (const auto& [x, y] : {std::pair{2.6, 1.}, {-0.6, 1.}, {1., 2.5}, {1., -9.}})
    expect_told(square({{"a", disc("steel", x, y, 0.5)}, {"rest", body("gas")}}),
                "list 'bodies/a/disc' has no part within the grid, which along ");
}

TEST(BodyOutside, InPartIsRefusedWhereNoWallMakesItWhole) {
  List given = square({{"a", disc("steel", 0, 0, 0.5)}, {"rest", body("gas")}});
  EXPECT_EQ(wrong(given), "");
  for (const char* kind : {"free", "periodic"}) {
    set_ends(given, kind);
    expect_told(given,
                "list 'bodies/a/disc' reaches 0.5 m beyond the end 'x low' of the grid, "
                "which is " +
                    std::string(kind));
  }
  // What fits exactly, what has no end, and what fills the grid from end to end.
  List fits = square({{"a", box("steel", 0, 0, 2, 1)}, {"b", box("gas", -0.1, 1, 2.1, 1e9)}});
  set_ends(fits, "free");
  EXPECT_EQ(wrong(fits), "");
}

TEST(BodyThatIsThin, IsRefusedIfSolidAndThinnerThanItsPointsAreApart) {
  List plate = box("steel", 1, 0, 1.04, 2);
  const List rest = body("gas");
  expect_told(square({{"plate", plate}, {"rest", rest}}),
              "list 'bodies/plate/box' is 0.04 m thin, less than its points are apart, 0.05 m");
  plate.set("particles per cell", 3);
  EXPECT_EQ(wrong(square({{"plate", plate}, {"rest", rest}})), "");
  plate.set("edge", "cells");
  expect_told(square({{"plate", plate}, {"rest", rest}}),
              "is 0.04 m thin, less than a cell, 0.1 m");
  EXPECT_EQ(wrong(square({{"sheet", box("gas", 1, 0, 1.04, 2)}, {"rest", rest}})), "");
}

TEST(BodyWithoutParticles, IsRefusedAndToldWhy) {
  const List inner = disc("steel", 1, 1, 0.3), outer = disc("steel", 1, 1, 0.5);
  expect_told(square({{"outer", outer}, {"inner", inner}}),
              "list 'bodies/inner' holds no particles: earlier bodies own all of its places");
  expect_told(square({{"speck", disc("gas", 1, 1, 0.01)}, {"rest", body("gas")}}),
              "list 'bodies/speck' holds no particles: no place for one lies in it");
  EXPECT_EQ(wrong(square({{"all", box("steel", 0, 0, 2, 2)}, {"rest", body("gas")}})), "");
}

TEST(Steps, WithoutEndAreRefused) {
  List given = test::scene(1);
  given.sublist("time").set("end", 1e7);
  expect_told(given, "list 'time', parameter 'end' = 1e+07: takes about ");
  given.sublist("time").set("end", 1e6);
  EXPECT_EQ(wrong(given), "");
}

TEST(State, ThatIsNotFiniteAtTheStartIsRefused) {
#ifdef BRISANCE_FPE_TRAPS
  GTEST_SKIP() << "such numbers are what traps are for";
#endif
  for (const auto& [name, value] : {std::pair{"density", 1e-320}, {"pressure", 1e307}}) {
    List given = test::scene(1);
    given.sublist("bodies").sublist("first").set(name, value);
    EXPECT_NE(wrong(given), "") << name << " " << value;
  }
}

// The grid of this scene has 23 nodes of 8 (3 + 4) bytes and more, its bodies places for 60 points.
TEST(Memory, IsComparedWithWhatIsFree) {
  const List scene = complete_scene(test::scene(1));
  EXPECT_NO_THROW(check_grid_memory(scene, std::numeric_limits<double>::infinity()));
  EXPECT_NO_THROW(check_grid_memory(scene, 1e6));
  EXPECT_THROW(check_grid_memory(scene, 23 * 8 * 7), InputError);
  EXPECT_NO_THROW(check_particle_memory(scene, 1e6, 60e6));
  EXPECT_THROW(check_particle_memory(scene, 1e6, 59e6), InputError);
  EXPECT_GT(available_memory(), 1e6);
  List huge = test::scene(2);
  huge.sublist("grid").set("cells", Teuchos::Array<int>(2, 40000)).set("cell size", 1e-3);
  if (available_memory() < 100e9) expect_told(huge, "list 'grid', parameter 'cells'");
}

TEST(Grid, WhoseCellsAreLostInTheDigitsOfANumberIsRefused) {
  List given = test::scene(1);
  given.sublist("grid").set("origin", Doubles(1, 1e9));
  expect_told(given, "must be nearer to 0 than 1e9 cells");
  given.sublist("grid").set("origin", Doubles(1, 0.)).set("cell size", 1e200);
  expect_told(given, "must be > 1e-50 and < 1e50");
}

TEST(Checks, WhoseRangeIsEmptyAreRefused) {
  List given = test::scene(1);
  given.sublist("checks").sublist("mass error").set("least", 1e-12).set("most", -1e-12);
  expect_told(given,
              "list 'checks/mass error', parameter 'least' = 1e-12: must not be above 'most'");
  given.sublist("checks").sublist("mass error").set("most", 1e-12);
  EXPECT_EQ(wrong(given), "");
}

TEST(ReferenceOfLayers, OfTooManyCellsIsRefused) {
  List given = *read_input((data_folder() / "inputs/plate_push.xml").string()).list;
  given.sublist("exact").set("cell size", 1e-300);
  expect_told(given, "cuts the layers into more than 1e6 cells");
}

TEST(Interval, MayBeLongerThanTheRunButNotNothing) {
  for (const char* name : {"interval", "history interval"}) {
    List given = test::scene(1);
    given.sublist("output").set(name, 1e9);
    EXPECT_EQ(wrong(given), "");
    given.sublist("output").set(name, 1e-300);
    expect_told(given, "must be 0 or at least a 1e7th of the run");
  }
}

TEST(Source, FarFromTheGridIsRefused) {
  const auto lit = [](double x) {
    List given = square({{"charge", disc("tnt", 1, 1, 0.3)}});
    given.sublist("ignition").sublist("sources").sublist("a").set("point", array_of({x, 1}));
    return given;
  };
  EXPECT_EQ(wrong(lit(-1.9)), "");
  expect_told(lit(-2.1), "list 'ignition/sources/a', parameter 'point' = {-2.1, 1}: is farther");
  List given = lit(0);
  List& source = given.sublist("ignition").sublist("sources").sublist("a");
  source.remove("point");
  source.sublist("line").set("from", array_of({0, 0})).set("to", array_of({0, 1e3}));
  expect_told(given, "parameter 'to' = {0, 1000}: is farther");
}

}  // namespace
}  // namespace brisance
