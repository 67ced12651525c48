// Springs between a material and the ground.
#include "drivers/springs.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "drivers/kernels.hpp"
#include "drivers/scene.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

/// The two bodies of test::scene(), each of an elastic material of its own, "first" with velocity
/// 0.01 along the direction of the springs that hold the materials named.
List sprung(int dim, const std::string& direction, const std::vector<std::string>& held,
            const std::vector<std::string>& assignments = {}, double stiffness = 3) {
  List given = test::scene(dim, assignments);
  given.sublist("materials").remove("gas");
  for (const char* name : {"first", "rest"}) {
    given.sublist("materials").sublist(name) = test::elastic_material();
    given.sublist("bodies").sublist(name).set("material", name).set("pressure", 0.);
  }
  Teuchos::Array<double> velocity(dim, 0.);
  velocity[direction == "y"] = 0.01;
  given.sublist("bodies").sublist("first").set("velocity", velocity);
  for (const auto& name : held)
    given.sublist("springs")
        .sublist("on " + name)
        .set("material", name)
        .set("direction", direction)
        .set("stiffness", stiffness);
  return complete_scene(given);
}

/// Of the first body alone, in empty space.
List alone(int dim, const std::string& direction, double stiffness) {
  std::vector<std::string> ends = {"boundaries/x low=free", "boundaries/x high=free"};
  if (dim == 2) ends.insert(ends.end(), {"boundaries/y low=free", "boundaries/y high=free"});
  List given = sprung(dim, direction, {"first"}, ends, stiffness);
  given.sublist("bodies").remove("rest");
  given.sublist("materials").remove("rest");
  List& box = given.sublist("bodies").sublist("first").sublist("box");
  Teuchos::Array<int> cells(dim, 20);
  given.sublist("grid").set("cells", cells);
  Teuchos::Array<double> low(dim, 0.8), high(dim, 1.2);
  box.set("low", low).set("high", high);
  return complete_scene(given);
}

// A body that moves as a whole: each step turns (w u, v) by 2 atan(w dt / 2), whatever dt, as the
// trapezoid rule does. Round-off of 300 steps.
TEST(Spring, SwingsABodyLikeAPointByTheTrapezoidRule) {
  for (const int dim : {1, 2})
    for (const std::string direction : {"x", "y"}) {
      if (dim == 1 && direction == "y") continue;
      const double stiffness = 3, mass = dim == 1 ? 0.4 : 0.16, w = std::sqrt(stiffness / mass);
      const auto simulation = make_simulation(alone(dim, direction, stiffness), nullptr);
      const Ledger ledger(simulation->balance());
      double phase = 0;
      for (int k = 0; k < 300; ++k) {
        simulation->advance(1e9);
        phase += 2 * std::atan(0.5 * w * simulation->dt());
      }
      EXPECT_GT(phase, 20);
      const Balance b = simulation->balance();
      const int d = direction == "y";
      EXPECT_NEAR(b.totals.mass, mass, 1e-14);
      EXPECT_NEAR(b.totals.momentum[d] / (0.01 * mass), std::cos(phase), 1e-12);
      ParticleTable table = simulation->snapshot().table;
      double centre = 0;
      for (std::size_t k = 0; k < table.size(); ++k)
        centre += table.mass[k] * (d == 0 ? table.x[k] : table.y[k]) / mass;
      EXPECT_NEAR((centre - 1) * w / 0.01, std::sin(phase), 1e-10);
      ASSERT_TRUE(b.springs.has_value());
      EXPECT_NEAR(*b.springs / (0.5 * mass * 1e-4), std::pow(std::sin(phase), 2), 1e-12);
      EXPECT_NEAR(ledger.energy_error(b), 0, 1e-12);
      EXPECT_NEAR(ledger.momentum_error(b), 0, 1e-12);
    }
}

// Both materials share nodes, touch walls (that hold nodes and mirror splines) and deform.
// Round-off of 100 steps.
TEST(Spring, KeepsMomentumWithTheGroundAndEnergyWithItsOwn) {
  for (const int dim : {1, 2})
    for (const std::string shape : {"linear", "quadratic"})
      for (const std::string direction : {"x", "y"})
        for (const std::vector<std::string>& held :
             {std::vector<std::string>{"first"}, std::vector<std::string>{"first", "rest"}}) {
          if (dim == 1 && direction == "y") continue;
          SCOPED_TRACE(shape + " " + direction + " " + std::to_string(held.size()));
          std::vector<std::string> ends;
          if (direction == "y") ends = {"boundaries/y low=free", "boundaries/y high=free"};
          List given = sprung(dim, direction, held, ends);
          given.sublist("scheme")
              .sublist("solids")
              .set("shape", shape)
              .set("transfer", shape == "linear" ? "FLIP" : "MLS");
          if (direction == "y") given.sublist("grid").set("cells", Teuchos::Array<int>(2, 20));
          if (direction == "y")
            given.sublist("bodies").sublist("first").sublist("box").set(
                "high", Teuchos::Array<double>(2, 1.));
          const auto simulation = make_simulation(complete_scene(given), nullptr);
          const Ledger ledger(simulation->balance());
          for (int k = 0; k < 100; ++k) simulation->advance(1e9);
          EXPECT_GT(*simulation->balance().springs, 0);
          EXPECT_NEAR(ledger.momentum_error(simulation->balance()), 0, 1e-12);
          EXPECT_NEAR(ledger.energy_error(simulation->balance()), 0, 1e-12);
        }
}

TEST(Spring, HasAColumnInTheHistoryOnlyWhereThereIsOne) {
  const auto head = [](const List& scene) {
    return Ledger(make_simulation(scene, nullptr)->balance()).head();
  };
  EXPECT_NE(head(sprung(1, "x", {"first"})).find(",springs\n"), std::string::npos);
  EXPECT_EQ(head(sprung(1, "x", {})).find("springs"), std::string::npos);
}

TEST(Spring, CostsNoKernelWhereThereIsNone) {
  const auto kernels = [](const std::vector<std::string>& held) {
    const auto simulation = make_simulation(sprung(1, "x", held), nullptr);
    simulation->advance(1);
    return kernels_of([&] { simulation->advance(1); });
  };
  const auto with = kernels({"first"}), without = kernels({});
  for (const char* kernel :
       {"mass on spring", "advance of spring", "compliance of springs", "pull of spring"}) {
    EXPECT_EQ(with.count(kernel), 1u) << kernel;
    EXPECT_EQ(without.count(kernel), 0u) << kernel;
  }
  EXPECT_EQ(without.count("scatter mean"), 0u);
}

std::string refusal(const List& given) {
  try {
    complete_scene(given);
  } catch (const InputError& wrong) {
    return wrong.what();
  }
  return "accepted";
}

TEST(Spring, IsRefusedWhereItCannotBe) {
  List given = sprung(1, "x", {"first"});
  given.sublist("springs").sublist("on first").set("material", "last");
  EXPECT_NE(refusal(given).find("'material' = 'last': must be one of"), std::string::npos);
  given = sprung(1, "x", {"first"});
  given.sublist("springs").sublist("on first").set("stiffness", 0.);
  EXPECT_NE(refusal(given).find("'stiffness' = 0: must be > 0"), std::string::npos);
  given = test::scene(1, {"preset=paper"});
  given.sublist("springs").sublist("a").set("material", "gas").set("stiffness", 1.);
  EXPECT_NE(refusal(given).find("must be 'midpoint' where there are springs"), std::string::npos);
}

}  // namespace
}  // namespace brisance
