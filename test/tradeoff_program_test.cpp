// The command the way people call it, on a small tube with the presets alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "drivers/tradeoff_table.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;
using testing::HasSubstr;

/// Sod's tube on 40 cells, its list "tradeoff" with this in it, too.
void write_tube(const fs::path& file, const std::string& more = "") {
  std::string text = read_file(data_folder() / "inputs/sod.xml");
  const auto change = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  change("{200}", "{40}");
  change("0.005", "0.025");
  change("<Parameter name=\"resolutions\"", more + "<Parameter name=\"resolutions\"");
  write_file(file, text);
}

class TradeoffProgram : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new Folder("tradeoff");
    write_tube(folder->path / "tube.xml");
    first = tradeoff("tube.xml --quick");
  }
  static void TearDownTestSuite() {
    delete folder;
    folder = nullptr;
  }
  static Ran tradeoff(const std::string& words) {
    return run_program("tradeoff " + words + " --out measured", folder->path);
  }

  static Folder* folder;
  static Ran first;
};
Folder* TradeoffProgram::folder = nullptr;
Ran TradeoffProgram::first;

TEST_F(TradeoffProgram, MeasuresThePresetsIntoTableAndPicture) {
  EXPECT_EQ(first.status, 0) << first.err << first.out;
  EXPECT_THAT(first.out, HasSubstr("tube: 8 settings\n"));
  const TradeoffPoints points = read_points(folder->path / "measured/tradeoff.csv");
  ASSERT_EQ(points.size(), 8u);
  for (const auto& point : points) {
    EXPECT_TRUE(point.valid() && point.preset_alone && point.excess >= 1) << point.setting.name();
    EXPECT_GT(point.cost, 0);
  }
  EXPECT_TRUE(fs::exists(folder->path / "measured/tradeoff.png"));
}

TEST_F(TradeoffProgram, DoesNotRepeatWhatIsFinished) {
  const Ran again = tradeoff("tube.xml --quick");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("8 finished before"));
  EXPECT_EQ(again.err.find("starts:"), again.err.npos) << again.err;
}

TEST_F(TradeoffProgram, PrintsACommandThatHasTheErrorItPromises) {
  const Ran told = tradeoff("tube.xml --target-error 7%");
  ASSERT_EQ(told.status, 0) << told.err << told.out;
  const std::string prefix = "brisance run ";
  ASSERT_EQ(told.out.compare(0, prefix.size(), prefix), 0) << told.out;
  const auto words = told.out.substr(9, told.out.find('\n') - 9);
  const Ran ran = run_program(words + " --out chosen", folder->path);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto measures =
      nlohmann::json::parse(read_file(folder->path / "chosen/summary.json")).at("measures");
  double error = 0;
  for (const char* name : {"L1 density", "L1 velocity", "L1 pressure"})
    error += measures.at(name).at("value").get<double>() / 3;
  EXPECT_LE(error, 0.07);
  char expected[40];
  std::snprintf(expected, sizeof expected, "error %.3g %%", 100 * error);
  EXPECT_THAT(told.out, HasSubstr(expected));
}

TEST_F(TradeoffProgram, SaysWhenNothingIsGoodEnough) {
  const Ran told = tradeoff("tube.xml --target-error 0.001%");
  EXPECT_EQ(told.status, 1);
  EXPECT_THAT(told.out, HasSubstr("the nearest:"));
}

TEST_F(TradeoffProgram, ChoosesForASceneThatWasNotMeasured) {
  const std::string toro = (data_folder() / "inputs/toro3.xml").string();
  const Ran told = tradeoff("'" + toro + "' --budget 1h");
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_THAT(told.out, HasSubstr("a cheap run here and the table of tube"));
  EXPECT_THAT(told.err, HasSubstr("toro3/"));
}

TEST_F(TradeoffProgram, RefusesInOneLine) {
  const std::string toro = (data_folder() / "inputs/toro3.xml").string();
  for (const std::string& words : {std::string(), "'" + toro + "'",
                                   std::string("tube.xml --budget 5m"), std::string("none.xml")}) {
    const Ran refused = tradeoff(words);
    EXPECT_EQ(refused.status, 2) << words;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
}

// Its own error would be 0, whatever it is worth.
TEST(TradeoffAgainstTheFinest, LeavesOutTheFinestRun) {
  const Folder folder("tradeoff_finest");
  write_tube(folder.path / "tube.xml", "<Parameter name='against' type='string' value='finest'/>");
  const Ran ran = run_program("tradeoff tube.xml --quick --out measured", folder.path);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const fs::path runs = folder.path / "measured/runs/tube";
  EXPECT_TRUE(fs::exists(runs / "balanced,x4,particles_3,CFL_0.8,linear/summary.json"));
  const TradeoffPoints points = read_points(folder.path / "measured/tradeoff.csv");
  ASSERT_EQ(points.size(), 8u);
  for (const auto& point : points) {
    EXPECT_LE(point.setting.resolution, 1);
    EXPECT_GT(point.error, 0.1);  // L1 errors on 40 cells are some four times those on 160
  }
}

}  // namespace
}  // namespace brisance
