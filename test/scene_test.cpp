#include "drivers/scene.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <functional>

#include "drivers/exact.hpp"
#include "drivers/input.hpp"
#include "drivers/simulation.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using test::scene;

/// What is wrong with a scene after these assignments; empty: nothing.
std::string wrong(int dim, const std::vector<std::string>& assignments) {
  try {
    scene(dim, assignments);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Scene, IsCompletedByThePresetOfItsGeometry) {
  EXPECT_EQ(get<double>(scene(1).sublist("scheme"), "split length"), 0.5);
  EXPECT_EQ(get<double>(scene(2).sublist("scheme"), "split length"), 1.001);
  const List paper = scene(1, {"preset=paper"});
  EXPECT_EQ(get<std::string>(paper.sublist("scheme"), "integration"), "MUSL");
  EXPECT_EQ(get<std::string>(paper.sublist("scheme"), "quadrature"), "particle");
  EXPECT_EQ(get<double>(paper.sublist("scheme").sublist("artificial viscosity"), "quadratic"), 2);
  EXPECT_EQ(get<double>(paper.sublist("scheme").sublist("artificial viscosity"), "linear"), 1);
}

TEST(Scene, CompletedIsCompleteAlready) {
  for (const int dim : {1, 2})
    for (const char* preset : {"paper", "fast", "balanced", "accurate"}) {
      const List once = scene(dim, {std::string("preset=") + preset});
      EXPECT_TRUE(Teuchos::haveSameValues(complete_scene(once), once, true));
    }
}

TEST(Scene, WhatIsGivenStandsAgainstThePreset) {
  const List s = scene(1, {"preset=accurate", "scheme/shape=cubic", "time/CFL=0.3"});
  EXPECT_EQ(get<std::string>(s.sublist("scheme"), "shape"), "cubic");
  EXPECT_EQ(get<std::string>(s.sublist("scheme"), "transfer"), "MLS");
  EXPECT_EQ(get<double>(s.sublist("time"), "CFL"), 0.3);
}

TEST(Scene, DocumentsEveryParameterWithItsUnit) {
  List given = scene(2);
  given.sublist("exact").set("solution", "vortex").set("box length", 1.).set("gamma", 1.4);
  const std::function<void(const List&)> visit = [&](const List& list) {
    for (const auto& name : names(list)) {
      const Described d = described(list, name);
      EXPECT_FALSE(d.doc.empty()) << path_of(list) << "/" << name;
      EXPECT_TRUE(d.type == "list" || !d.unit.empty()) << path_of(list) << "/" << name;
    }
    for (const auto& below : list_names(list)) visit(list.sublist(below));
  };
  visit(valid_scene(given));
}

struct Mistake {
  const char* assignment;
  const char* told;
};

TEST(Scene, RefusesWhatDoesNotFitTogether) {
  const Mistake mistakes[] = {
      {"boundaries/x low=periodic", "'x high'"},
      {"scheme/transfer=APIC", "needs the shape"},
      {"scheme/shape=quadratic", "quadrature 'cell' needs the shape 'linear'"},
      {"scheme/integration=MUSL", "must be 0 with MUSL"},
      {"bodies/first/box/high={-2e9}", "must be above 'low'"},
      {"grid/cells={2000000000}", "fewer than 2e9"},
      {"bodies/first/material=air", "one of"},
      {"time/CFL=1", "<= 0.95"},
      {"grid/origin={0, 0}", "1"},
      {"bodies/first/density=0", "> 0"},
      {"materials/gas/gamma=1", "> 1"},
  };
  for (const auto& [assignment, told] : mistakes) {
    const std::string message = wrong(1, {assignment});
    EXPECT_NE(message.find(told), message.npos) << assignment << ": '" << message << "'";
    EXPECT_EQ(message.find('\n'), message.npos);
  }
  EXPECT_NE(wrong(1, {"scheme/integration=MUSL", "scheme/volume relaxation=0",
                      "scheme/pressure relaxation=0", "scheme/heat conduction=0",
                      "scheme/quadrature=particle", "scheme/shape=cubic", "scheme/transfer=MLS"}),
            "");
  EXPECT_EQ(wrong(1, {}), "");
}

TEST(Scene, NeedsAnExactSolutionForBodiesThatStartFromIt) {
  List s = scene(1);
  List& body = s.sublist("bodies").sublist("first");
  body.set("initial state", "exact");
  for (const char* name : {"density", "pressure", "velocity"}) body.remove(name);
  EXPECT_THROW(complete_scene(s), InputError);
}

TEST(Scene, NeedsMaterialsAndBodiesWithParticles) {
  List s = scene(1);
  s.sublist("bodies").remove("first");
  s.sublist("bodies").remove("rest");
  EXPECT_THROW(complete_scene(s), InputError);
  EXPECT_THROW(scene(1, {"bodies/first/box/low={100}", "bodies/first/box/high={101}"}), InputError);
}

TEST(Bodies, FirstThatHoldsACellsCentreOwnsTheCell) {
  const auto shot =
      make_simulation(scene(1, {"bodies/first/density=3", "bodies/first/box/high={0.96}"}), nullptr)
          ->snapshot();
  ASSERT_EQ(shot.table.size(), 60u);
  // The centre of the cell from 0.9 to 1 is at 0.95: it is the first body's as a whole.
  for (std::size_t p = 0; p < 60; ++p)
    EXPECT_DOUBLE_EQ(shot.table.density[p], shot.table.x[p] < 1 ? 3 : 1);
}

TEST(Bodies, FillTheirCellsEvenlyWithTheirMass) {
  for (const int per_cell : {1, 2, 5}) {
    const std::string n = std::to_string(per_cell);
    const auto t =
        make_simulation(scene(2, {"grid/cells={6, 4}", "bodies/first/particles per cell=" + n,
                                  "bodies/rest/particles per cell=" + n, "bodies/first/pressure=3",
                                  "bodies/rest/pressure=3"}),
                        nullptr)
            ->snapshot()
            .table;
    ASSERT_EQ(t.size(), static_cast<std::size_t>(24 * per_cell * per_cell));
    double mass = 0, x = 0, y = 0;
    for (std::size_t p = 0; p < t.size(); ++p) {
      mass += t.mass[p];
      x += t.mass[p] * t.x[p];
      y += t.mass[p] * t.y[p];
      EXPECT_DOUBLE_EQ(t.pressure[p], 3);
      EXPECT_DOUBLE_EQ(t.energy[p], 3 / 0.4);
    }
    // Sums of up to 600 terms.
    EXPECT_NEAR(mass, 0.24, 2e-14);
    EXPECT_NEAR(x / mass, 0.3, 2e-14);
    EXPECT_NEAR(y / mass, 0.2, 2e-14);
  }
}

TEST(Bodies, TakeEnergyInPlaceOfPressure) {
  List s = scene(1);
  List& body = s.sublist("bodies").sublist("first");
  body.set("specific energy", 7.);
  EXPECT_THROW(complete_scene(s), InputError);  // beside pressure
  body.remove("pressure");
  const auto t = make_simulation(complete_scene(s), nullptr)->snapshot().table;
  EXPECT_DOUBLE_EQ(t.energy.front(), 7);
  EXPECT_DOUBLE_EQ(t.energy.back(), 2.5);
}

TEST(Bodies, OfSeveralMaterialsKeepTheirOwnLaw) {
  List s = scene(1);
  s.sublist("materials").sublist("helium").set("law", "perfect gas").set("gamma", 1.667);
  s.sublist("bodies").sublist("rest").set("material", "helium");
  const auto shot = make_simulation(complete_scene(s), nullptr)->snapshot();
  for (std::size_t p = 0; p < shot.table.size(); ++p)
    EXPECT_NEAR(shot.table.energy[p], shot.table.material[p] == 0 ? 1 / 0.4 : 1 / 0.667, 1e-14);
  EXPECT_EQ(shot.table.material.front(), 0);
  EXPECT_EQ(shot.table.material.back(), 1);
}

TEST(Bodies, ParticlesHaveUniqueIds) {
  auto ids = make_simulation(scene(2, {"grid/cells={6, 4}"}), nullptr)->snapshot().id;
  std::sort(ids.begin(), ids.end());
  for (std::size_t k = 0; k < ids.size(); ++k) EXPECT_EQ(ids[k], static_cast<std::int64_t>(k));
}

}  // namespace
}  // namespace brisance
