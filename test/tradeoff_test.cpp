// Settings of a scene, the front among them, and which one is taken; without a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "drivers/files.hpp"
#include "drivers/input.hpp"
#include "drivers/locations.hpp"
#include "drivers/tradeoff_choice.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string input(const std::string& name) {
  return (data_folder() / "inputs" / (name + ".xml")).string();
}

TradeoffPoint point(const std::string& preset, double resolution, double error, double cost,
                    const std::string& scene = "tube") {
  return {scene,
          "fluid on a line",
          {preset, resolution, "3", 0.8, "linear"},
          true,
          "finished",
          error,
          cost,
          0,
          "abc"};
}

TEST(TradeoffScene, RefinesCellsAndTheirSizeTogether) {
  const TradeoffScene line(input("sod")), plane(input("sedov_table1"));
  EXPECT_THAT(line.assignments(line.preset_alone("fast", 2)),
              ElementsAre("grid/cells={400}", "grid/cell size=0.0025"));
  EXPECT_THAT(plane.assignments(plane.preset_alone("fast", 2)),
              ElementsAre("grid/cells={240, 240}", "grid/cell size=0.0025"));
  EXPECT_THAT(line.assignments(line.preset_alone("fast", 1)), IsEmpty());
}

TEST(TradeoffScene, SetsParticlesInAllBodies) {
  const TradeoffScene scene(input("piston_gas"));
  Setting setting = scene.preset_alone("balanced", 1);
  EXPECT_EQ(setting.particles, "1");
  setting.particles = "2";
  EXPECT_THAT(scene.assignments(setting), ElementsAre("bodies/resting piston/particles per cell=2",
                                                      "bodies/gas/particles per cell=2",
                                                      "bodies/moving piston/particles per cell=2"));
  EXPECT_EQ(TradeoffScene(input("sedov_table1")).preset_alone("fast", 1).particles, "own");
}

TEST(TradeoffScene, AShapeBringsWhatItNeeds) {
  const TradeoffScene gas(input("sod")), solid(input("elastic_bar"));
  Setting setting = gas.preset_alone("balanced", 1);
  setting.shape = "quadratic";
  EXPECT_THAT(gas.assignments(setting),
              ElementsAre("scheme/shape=quadratic", "scheme/quadrature=particle"));
  setting = gas.preset_alone("accurate", 1);
  setting.shape = "linear";
  EXPECT_THAT(gas.assignments(setting), ElementsAre("scheme/shape=linear", "scheme/transfer=FLIP"));
  setting = solid.preset_alone("balanced", 1);
  setting.shape = "GIMP";
  EXPECT_THAT(solid.assignments(setting),
              ElementsAre("scheme/solids/shape=GIMP", "scheme/solids/transfer=FLIP"));
}

TEST(TradeoffScene, KnowsWhichScenesAreAlike) {
  EXPECT_EQ(TradeoffScene(input("sod")).family(), "fluid on a line");
  EXPECT_EQ(TradeoffScene(input("detonation_1d")).family(), "explosive on a line");
  EXPECT_EQ(TradeoffScene(input("piston_gas")).family(), "fluid and solid on a line");
  EXPECT_EQ(TradeoffScene(input("sedov_table1")).family(), "fluid in the plane");
}

/// Names of all settings, each of which must make a valid run.
std::vector<std::string> runs_of(const TradeoffScene& scene, bool quick) {
  std::vector<std::string> names;
  for (const auto& setting : scene.settings(quick))
    EXPECT_NO_THROW(names.push_back(scene.planned(setting).name)) << setting.name();
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end()) << scene.name();
  return names;
}

TEST(TradeoffScene, EverySettingIsAValidRun) {
  // Alone at 4 resolutions and 4 presets; 3 particles with 3, 2, 2, 2 CFL numbers, and 1 shape.
  EXPECT_EQ(runs_of(TradeoffScene(input("sod")), false).size(), 4u * (3 * (3 + 2 + 2 + 2) + 4));
  // ... and 3 shapes.
  EXPECT_EQ(runs_of(TradeoffScene(input("elastic_bar")), false).size(),
            4u * (3 * (3 + 2 + 2 + 2) + 12));
}

TEST(TradeoffScene, QuickAreThePresetsOfEverySceneThatIsMeasured) {
  int measured = 0;
  for (const auto& entry : fs::directory_iterator(data_folder() / "inputs")) {
    if (entry.path().extension() != ".xml") continue;
    const TradeoffScene scene(entry.path().string());
    if (!scene.measured()) continue;
    ++measured;
    EXPECT_EQ(runs_of(scene, true).size(), 8u);
    for (const auto& setting : scene.settings(true))
      EXPECT_EQ(setting, scene.preset_alone(setting.preset, setting.resolution));
  }
  EXPECT_GE(measured, 7);
}

TEST(TradeoffScene, ErrorIsTheMeanOfItsMeasures) {
  const TradeoffScene scene(input("elastic_bar"));
  Record run, fine;
  run.measures = {{"wave speed error", -0.01}, {"amplitude error", 0.03}};
  EXPECT_DOUBLE_EQ(scene.error(run, nullptr), 0.02);
  fine.measures = {{"wave speed error", -0.02}, {"amplitude error", 0.02}};
  EXPECT_DOUBLE_EQ(scene.error(run, &fine), 0.5);
  run.measures.erase("amplitude error");
  EXPECT_TRUE(std::isnan(scene.error(run, nullptr)));
}

class TradeoffList : public testing::Test {
 protected:
  /// The message for the tube with this in its list.
  std::string refused(const std::string& parameters) {
    std::string text = read_file(input("sod"));
    const auto from = text.find("<Parameter name=\"measures\"");
    text.replace(from, text.find("</ParameterList>", from) - from, parameters);
    const fs::path file = folder.path / "tube.xml";
    write_file(file, text);
    try {
      const TradeoffScene scene(file.string());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  static std::string measures(const std::string& value) {
    return "<Parameter name='measures' type='Array(string)' value='" + value + "'/>";
  }
  static std::string resolutions(const std::string& value) {
    return measures("{L1 density}") + "<Parameter name='resolutions' type='Array(double)' value='" +
           value + "'/>";
  }
  Folder folder{"tradeoff_list"};
};

TEST_F(TradeoffList, IsRefusedInOneLine) {
  EXPECT_THAT(refused(measures("{L1 densty}")), HasSubstr("L1 density"));
  EXPECT_THAT(refused(measures("{}")), HasSubstr("must name a measure"));
  EXPECT_THAT(refused(resolutions("{1, 0.5}")), HasSubstr("must be ascending"));
  EXPECT_THAT(refused(resolutions("{0.333, 1}")), HasSubstr("0.333 does not"));
  EXPECT_EQ(refused(resolutions("{0.5, 1}")), "");
}

TEST(TradeoffFront, IsWhatNothingCheaperIsAsGoodAs) {
  const double none = std::nan("");
  TradeoffPoints points = {point("fast", 1, 0.02, 1), point("balanced", 1, 0.01, 3),
                           point("accurate", 1, 0.02, 4), point("paper", 1, none, 2),
                           point("fast", 1, 0.001, 0.1, "other")};
  compare_with_front(points);
  EXPECT_EQ(points[0].excess, 1);
  EXPECT_EQ(points[1].excess, 1);
  EXPECT_EQ(points[2].excess, 4);
  EXPECT_TRUE(std::isnan(points[3].excess));
  EXPECT_EQ(points[4].excess, 1);
  const std::string table = front_table(points, "tube");
  EXPECT_LT(table.find("balanced"), table.find("fast"));
  EXPECT_LT(table.find("beside the front"), table.find("accurate"));
  EXPECT_THAT(table, HasSubstr("4 settings, 1 of them without a result"));
}

TEST(TradeoffFront, FileKeepsThePoints) {
  const Folder folder("tradeoff_file");
  const fs::path csv = folder.path / "tradeoff.csv";
  TradeoffPoints points = {point("fast", 0.5, 0.02, 1), point("paper", 1, std::nan(""), 2)};
  points[1].preset_alone = false;
  points[1].status = "failed";
  compare_with_front(points);
  write_points(csv, points);
  const TradeoffPoints again = read_points(csv);
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again[0].setting, points[0].setting);
  EXPECT_EQ(again[0].family, "fluid on a line");
  EXPECT_EQ(again[0].error, 0.02);
  EXPECT_TRUE(again[0].preset_alone);
  EXPECT_FALSE(again[1].preset_alone);
  EXPECT_FALSE(again[1].valid());
  EXPECT_EQ(again[1].commit, "abc");

  write_file(csv, "run,status\n");
  EXPECT_THROW(read_points(csv), InputError);
}

TEST(TradeoffChoice, IsTheCheapestThatIsGoodEnoughOrTheBestThatIsCheapEnough) {
  const TradeoffPoints points = {point("fast", 1, 0.02, 1), point("balanced", 1, 0.01, 3),
                                 point("accurate", 1, 0.015, 4)};
  EXPECT_EQ(choose(points, {0.03, {}})->setting.preset, "fast");
  EXPECT_EQ(choose(points, {0.016, {}})->setting.preset, "balanced");
  EXPECT_EQ(choose(points, {{}, 2})->setting.preset, "fast");
  EXPECT_EQ(choose(points, {{}, 60})->setting.preset, "balanced");
  const auto nearest = choose(points, {0.001, {}});
  EXPECT_FALSE(nearest->fulfils);
  EXPECT_EQ(nearest->setting.preset, "balanced");
  EXPECT_FALSE(choose({point("fast", 1, std::nan(""), 1)}, {0.1, {}}));
}

TEST(TradeoffChoice, ForAnotherSceneTakesTheWorstOfItsFamily) {
  const TradeoffPoints points = {
      point("fast", 1, 0.02, 1, "a"),        point("fast", 1, 0.03, 2, "b"),
      point("balanced", 1, 0.01, 3, "a"),    point("balanced", 1, 0.015, 8, "b"),
      point("accurate", 1, 0.001, 9, "a"),                                            // not in b
      point("fast", 0.013, 0.001, 0.1, "a"), point("fast", 0.013, 0.001, 0.1, "b")};  // no cells
  const TradeoffScene scene(input("toro3"));
  const FamilyFit fit(points, scene.family(), scene);
  EXPECT_THAT(fit.scenes(), ElementsAre("a", "b"));
  EXPECT_EQ(fit.probe()->preset, "fast");
  const auto choice = fit.choose(0.5, {0.015, {}});
  EXPECT_EQ(choice->setting.preset, "balanced");
  EXPECT_EQ(choice->error, 0.015);
  EXPECT_EQ(choice->least_error, 0.01);
  EXPECT_DOUBLE_EQ(choice->cost, 0.5 * 4);  // 3 / 1 in a, 8 / 2 in b
  EXPECT_FALSE(fit.choose(0.5, {0.001, {}})->fulfils);
  EXPECT_FALSE(FamilyFit(points, "solid on a line", scene).probe());
}

TEST(TradeoffChoice, ForAnotherScenePrefersAPresetThatIsAboutAsCheap) {
  TradeoffPoints points = {point("fast", 1, 0.01, 1, "a"), point("balanced", 1, 0.01, 1.4, "a"),
                           point("accurate", 1, 0.004, 9, "a")};
  points[0].preset_alone = false;
  const TradeoffScene scene(input("toro3"));
  const auto chosen = [&](double error) {
    return FamilyFit(points, scene.family(), scene).choose(1, {error, {}})->setting.preset;
  };
  EXPECT_EQ(chosen(0.01), "balanced");
  points[1].cost = 1.6;
  EXPECT_EQ(chosen(0.01), "fast");
  EXPECT_EQ(chosen(0.005), "accurate");
}

TEST(TradeoffChoice, ProbesWithARunThatIsMoreThanTheStartOfTheProgram) {
  const TradeoffPoints points = {point("paper", 1, 0.05, 0.01, "a"),
                                 point("fast", 1, 0.02, 0.2, "a"),
                                 point("balanced", 1, 0.01, 0.6, "a")};
  const TradeoffScene scene(input("toro3"));
  const FamilyFit fit(points, scene.family(), scene);
  EXPECT_EQ(fit.probe()->preset, "fast");
  EXPECT_DOUBLE_EQ(fit.choose(1, {0.01, {}})->cost, 3);
  EXPECT_EQ(FamilyFit({points[0]}, scene.family(), scene).probe()->preset, "paper");
}

TEST(TradeoffChoice, ReadsErrorsAndTimes) {
  EXPECT_DOUBLE_EQ(error_from("2%"), 0.02);
  EXPECT_DOUBLE_EQ(error_from("0.02"), 0.02);
  EXPECT_DOUBLE_EQ(budget_from("60"), 60);
  EXPECT_DOUBLE_EQ(budget_from("1.5min"), 90);
  EXPECT_DOUBLE_EQ(budget_from("2h"), 7200);
  for (const char* wrong : {"", "0%", "-1", "2 %", "nan", "inf", "1e999", "2s"})
    EXPECT_THROW(error_from(wrong), InputError) << wrong;
  for (const char* wrong : {"", "0", "2%", "5m"})
    EXPECT_THROW(budget_from(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace brisance
