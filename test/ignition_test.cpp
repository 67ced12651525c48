// From a scene to the lighting times of its particles.
#include "drivers/ignition.hpp"

#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "core/geometry.hpp"
#include "drivers/scene.hpp"
#include "drivers/simulation.hpp"
#include "test/explosive.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using Doubles = Teuchos::Array<double>;
Doubles array_of(const std::vector<double>& values) { return Doubles(values); }

/// A group that is nothing but its particles and the names of two state variables.
class Names final : public Group<PlaneStrain> {
 public:
  std::vector<FieldName> fields;

  Stress stress() const override { return Stress::pressure; }
  bool fluid() const override { return true; }
  std::vector<FieldName> history_fields() const override { return fields; }
  void allocate(int capacity, ColumnNeeds needs) override {
    needs.history = 2;
    particles = Particles<PlaneStrain>(capacity, needs);
  }
  void initialise(int, bool) override {}
  void start() override {}
  void find_signals(Sweep<2>&) override {}
  Signals signals() const override { return {}; }
  void set_signals(const Lattice<2>&, const Signals&) override {}
  void half_step(Sweep<2>&, const Grid<PlaneStrain>&, double) override {}
  void finish(Sweep<2>&, const Grid<PlaneStrain>&, double) override {}
  void update(Sweep<2>&, const Grid<PlaneStrain>&, double) override {}
  Totals totals(int, int, double) const override { return {}; }
  void report(const Array<double>&, const Array<double>&) const override {}
};

/// 20 x 20 cells of 0.1: "explosive" with D = 2 in a box at x < 1, "inert" in the rest.
List two_materials() {
  List given = test::scene(2, {"grid/cells={20, 20}"});
  given.sublist("materials").sublist("inert") = given.sublist("materials").sublist("gas");
  given.sublist("bodies").sublist("rest").set("material", "inert");
  given.sublist("ignition")
      .set("path", "through explosive")
      .sublist("sources")
      .sublist("one")
      .set("point", array_of({0, 0.5}));
  List scene = complete_scene(given);
  // As a law with this parameter would have it.
  scene.sublist("materials").sublist("gas").set("detonation speed", 2.);
  return scene;
}

State<PlaneStrain> state_with(const std::string& second_field) {
  const double origin[] = {0, 0};
  const int cells[] = {20, 20};
  State<PlaneStrain> state(
      Grid<PlaneStrain>(Lattice<2>(origin, cells, 0.1), Boundaries<2>(), GridNeeds()),
      StepScheme());
  for (const char* label : {"gas", "inert"}) {
    auto group = std::make_unique<Names>();
    group->label = label;
    group->fields = {{"energy", "J/kg"}, {second_field, "s"}};
    group->allocate(50, {});
    Particles<PlaneStrain>& p = group->particles;
    for (p.count = 0; p.count < 50; ++p.count) {
      p.position(p.count, 0) = 0.01 + 0.019 * p.count;
      p.position(p.count, 1) = 0.03 + 0.037 * p.count;
    }
    state.groups.push_back(std::move(group));
  }
  return state;
}

TEST(Ignition, SetsTheLightingTimesOfExplosivesAlone) {
  auto state = state_with("lighting time");
  set_lighting_times(state, two_materials());
  const auto& p = state.groups[0]->particles;
  for (int k = 0; k < p.count; ++k) {
    const double away = std::hypot(p.position(k, 0), p.position(k, 1) - 0.5);
    EXPECT_NEAR(p.history(k, 1), away / 2, 2e-3 * 0.1 / 2);
    EXPECT_EQ(p.history(k, 0), 0);
    EXPECT_EQ(state.groups[1]->particles.history(k, 1), 0);
  }
}

TEST(Ignition, LeavesStatesWithoutLightingTimesAlone) {
  auto state = state_with("damage");
  set_lighting_times(state, two_materials());
  for (int k = 0; k < 50; ++k) EXPECT_EQ(state.groups[0]->particles.history(k, 1), 0);
}

std::string wrong(const List& scene) {
  auto state = state_with("lighting time");
  try {
    set_lighting_times(state, scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Ignition, RefusesAnExplosiveThatNothingLights) {
  List scene = two_materials();
  EXPECT_EQ(wrong(scene), "");
  scene.remove("ignition");
  EXPECT_NE(wrong(scene).find("needs a list 'ignition'"), std::string::npos);
  // Two explosives, and a gap of something else between them.
  List apart = two_materials();
  List& bodies = apart.sublist("bodies");
  bodies.sublist("first").sublist("box").set("high", array_of({0.5, 1e9}));
  List other = bodies.sublist("rest");
  other.sublist("box").set("low", array_of({0.7, -1e9})).set("high", array_of({2, 1e9}));
  bodies.sublist("rest") = other;
  apart.sublist("materials").sublist("inert").set("detonation speed", 2.);
  EXPECT_EQ(wrong(apart), "");
  auto state = state_with("lighting time");
  for (int k = 0; k < 50; ++k) state.groups[1]->particles.position(k, 0) += 1;
  try {
    set_lighting_times(state, apart);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("leaves 'inert' unlit"), std::string::npos);
  }
}

/// 20 cells of 0.1 along a line, TNT at x < 1, gas in the rest.
List line_of_tnt(const std::string& burn) {
  List given = test::scene(1);
  List tnt = test::tnt();
  tnt.set("law", "jwl").set("burn", burn);
  given.sublist("materials").sublist("tnt") = tnt;
  List& body = given.sublist("bodies").sublist("first");
  body.set("material", "tnt").set("density", 1630.);
  body.remove("pressure");
  body.set("specific energy", 6e9 / 1630);
  return given;
}

TEST(Ignition, LightsABarOfTnt) {
  List given = line_of_tnt("program");
  EXPECT_THROW(make_simulation(complete_scene(given), nullptr), InputError);
  List& left = given.sublist("ignition").sublist("sources").sublist("left");
  left.set("point", array_of({0})).set("delay", 1e-5);
  const auto table = make_simulation(complete_scene(given), nullptr)->snapshot().table;
  const auto* lit = table.field("lighting time");
  ASSERT_NE(lit, nullptr);
  for (std::size_t k = 0; k < table.size(); ++k)
    EXPECT_NEAR((*lit)[k], table.x[k] < 1 ? 1e-5 + table.x[k] / 6930 : 0, 1e-18);
}

TEST(Ignition, IsNothingToProductsFromTheStart) {
  EXPECT_NO_THROW(make_simulation(complete_scene(line_of_tnt("at once")), nullptr));
}

TEST(Ignition, BelongsToTheSceneAndIsCheckedThere) {
  List given = test::scene(2);
  given.sublist("ignition");
  EXPECT_THROW(complete_scene(given), InputError);
  given.sublist("ignition").sublist("sources").sublist("one").set("point", array_of({0, 0}));
  const List scene = complete_scene(given);
  EXPECT_EQ(get<std::string>(scene.sublist("ignition"), "path"), "straight");
  EXPECT_TRUE(Teuchos::haveSameValues(complete_scene(scene), scene, true));
}

}  // namespace
}  // namespace brisance
