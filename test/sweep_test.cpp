// A scene and what is varied in it, as runs with names; and what is wrong with a sweep, told in one
// line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>

#include "drivers/batch_plan.hpp"
#include "drivers/files.hpp"
#include "drivers/input.hpp"
#include "drivers/locations.hpp"
#include "drivers/sweep.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using testing::ElementsAre;
using testing::HasSubstr;

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name='" + name + "' type='" + type + "' value='" + value + "'/>\n";
}

std::string axis(const std::string& name, const std::string& path, const std::string& rest) {
  return "<ParameterList name='" + name + "'>\n" + parameter("parameter", "string", path) + rest +
         "</ParameterList>\n";
}

std::string values(const std::string& text) { return parameter("values", "string", text); }

/// A sweep of sod.xml with that inside its list "vary" and beside it.
std::string sweep(const std::string& vary, const std::string& more = "") {
  return "<ParameterList name='sweep'>\n" +
         parameter("base", "string", (data_folder() / "inputs/sod.xml").string()) + more +
         "<ParameterList name='vary'>\n" + vary + "</ParameterList>\n</ParameterList>\n";
}

class Sweep : public testing::Test {
 protected:
  BatchPlan plan(const std::string& text) {
    write_file(file, text);
    return expand_sweep(file.string());
  }
  std::vector<std::string> names(const std::string& text) {
    std::vector<std::string> all;
    for (const auto& run : plan(text).runs) all.push_back(run.name);
    return all;
  }
  /// The message, which must stand on one line and name the file.
  std::string refused(const std::string& text) {
    try {
      plan(text);
    } catch (const InputError& error) {
      const std::string line = error.what();
      EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 0) << line;
      EXPECT_THAT(line, HasSubstr("tube.xml")) << line;
      return line;
    }
    return "";
  }

  Folder folder{"sweep"};
  fs::path file = folder.path / "tube.xml";
};

TEST_F(Sweep, IsAGridWhoseLastParameterVariesFastest) {
  const std::string two = axis("CFL", "time/CFL", values("0.3; 0.4")) +
                          axis("how", "preset", values("fast; balanced; paper"));
  EXPECT_THAT(names(sweep(two)),
              ElementsAre("CFL_0.3,how_fast", "CFL_0.3,how_balanced", "CFL_0.3,how_paper",
                          "CFL_0.4,how_fast", "CFL_0.4,how_balanced", "CFL_0.4,how_paper"));
}

TEST_F(Sweep, OrPairsItsValues) {
  const std::string two =
      axis("cells", "grid/cells", values("{50}; {100}")) +
      axis("size", "grid/cell size", parameter("values", "Array(double)", "{0.02, 0.01}"));
  EXPECT_THAT(names(sweep(two, parameter("combine", "string", "zip"))),
              ElementsAre("cells_50,size_0.02", "cells_100,size_0.01"));
}

TEST_F(Sweep, RangesHoldBothEnds) {
  const auto range = [](const char* from, const char* to, const char* count) {
    return parameter("from", "double", from) + parameter("to", "double", to) +
           parameter("count", "int", count);
  };
  EXPECT_THAT(names(sweep(axis("end", "time/end", range("0.1", "0.2", "3")))),
              ElementsAre("end_0.1", "end_0.15", "end_0.2"));
  EXPECT_THAT(
      names(sweep(axis("end", "time/end",
                       range("0.002", "0.2", "3") + parameter("spacing", "string", "geometric")))),
      ElementsAre("end_0.002", "end_0.02", "end_0.2"));
}

TEST_F(Sweep, EachRunHasItsCompleteScene) {
  const BatchPlan p =
      plan(sweep(axis("CFL", "time/CFL", values("0.3; 0.4")),
                 parameter("changes", "string", "grid/cells={50}; grid/cell size=0.02")));
  for (std::size_t k = 0; k < 2; ++k) {
    const Document scene = parse_input(p.runs[k].input, "run");
    EXPECT_EQ(get<double>(scene.list->sublist("time"), "CFL"), k == 0 ? 0.3 : 0.4);
    EXPECT_EQ(get<std::vector<int>>(scene.list->sublist("grid"), "cells"), std::vector<int>{50});
    EXPECT_EQ(scene.list->name(), p.runs[k].name);
  }
}

TEST_F(Sweep, UnitsComeFromTheScene) {
  const std::string plot = "<ParameterList name='plot'>" + parameter("x", "string", "duration") +
                           parameter("y", "string", "shock position; L1 density") +
                           "</ParameterList>";
  const BatchPlan p =
      plan(sweep(axis("duration", "time/end", values("0.1; 0.2")),
                 parameter("results", "string", "mean speed of gas; L1 density") + plot));
  EXPECT_EQ(p.runs[0].varied[0].first.label(), "duration [s]");
  std::vector<std::string> results;
  for (const auto& quantity : p.results) results.push_back(quantity.label());
  EXPECT_THAT(results,
              ElementsAre("mean speed of gas [m/s]", "L1 density", "shock position [cells]"));
  ASSERT_EQ(p.pictures.size(), 1u);
  EXPECT_EQ(p.pictures[0].file, "tube.png");
  EXPECT_EQ(p.pictures[0].x.label(), "duration [s]");
}

TEST_F(Sweep, TellsFileAndLineOfWhatIsWrong) {
  const auto plot = [](const char* x, const char* y) {
    return "<ParameterList name='plot'>" + parameter("x", "string", x) +
           parameter("y", "string", y) + "</ParameterList>";
  };
  const std::string good = axis("CFL", "time/CFL", values("0.3; 0.4")),
                    words = axis("how", "preset", values("fast; paper"));
  const std::pair<std::string, const char*> wrong[] = {
      {sweep(axis("CFL", "time/CLF", values("0.3"))),
       ":5: list 'vary/CFL', parameter 'parameter' = 'time/CLF': 'time/CLF' is unknown; did you "
       "mean "
       "'CFL'?"},
      {sweep(axis("CFL", "tmie/CFL", values("0.3"))), "did you mean 'time'?"},
      {sweep(axis("CFL", "time", values("0.3"))), "is a list"},
      {sweep(axis("CFL", "time/CFL", values("0.3; many"))),
       ":6: list 'vary/CFL', parameter 'values' = 'many': 'time/CFL' must be a number"},
      {sweep(axis("CFL", "time/CFL", values("0.3; 2"))),
       ":6: list 'vary/CFL', parameter 'values' = '2': 'time/CFL' must be > 0 and <= 0.95"},
      {sweep(axis("CFL", "time/CFL", values(" ; "))), "must hold a value"},
      {sweep(axis("CFL", "time/CFL", values("0.3; 0.3"))), "two runs of the name 'CFL_0.3'"},
      {sweep(axis("CFL", "time/CFL", "")), "parameter 'values' is missing"},
      {sweep(axis("CFL", "time/CFL", values("0.3") + parameter("from", "double", "0.1"))),
       "is given beside a range"},
      {sweep(axis("CFL", "time/CFL", parameter("from", "double", "0.1"))), "'to' is missing"},
      {sweep(axis("CFL", "time/CFL",
                  parameter("from", "double", "0") + parameter("to", "double", "0.4") +
                      parameter("count", "int", "3") +
                      parameter("spacing", "string", "geometric"))),
       "none of them 0"},
      {sweep(axis("cells", "grid/cells",
                  parameter("from", "double", "10") + parameter("to", "double", "20") +
                      parameter("count", "int", "2"))),
       "parameter 'from' = '10': 'grid/cells' must be entries in braces"},
      {sweep(""), "must hold a list for a parameter"},
      {sweep(good + axis("end", "time/end", values("0.1")), parameter("combine", "string", "zip")),
       "list 'vary/end' has another number of values than 'CFL', 1 instead of 2"},
      {sweep(good, parameter("changes", "string", "time/end")), "must be list/parameter=value"},
      {sweep(good, parameter("changes", "string", "time/end=-1")),
       ":3: parameter 'changes' = 'time/end=-1': 'time/end' must be > 0"},
      {sweep(good, parameter("results", "string", "L1 densty")), "did you mean 'L1 density'?"},
      {sweep(good, plot("cfl", "L1 density")), "is not varied; did you mean 'CFL'?"},
      {sweep(good, plot("CFL", "L1 densty")), "did you mean 'L1 density'?"},
      {sweep(good + words, plot("how", "L1 density")), "must be varied over numbers"},
      {sweep(good, parameter("bass", "string", "x")), "'bass' is unknown; did you mean 'base'?"},
  };
  for (const auto& [text, message] : wrong) EXPECT_THAT(refused(text), HasSubstr(message)) << text;
}

TEST_F(Sweep, TellsWhatOfItsSceneIsWrong) {
  EXPECT_THAT(refused("<ParameterList name='s'>" + parameter("base", "string", "nowhere.xml") +
                      "<ParameterList name='vary'>" + axis("CFL", "time/CFL", values("0.3")) +
                      "</ParameterList></ParameterList>"),
              HasSubstr("parameter 'base' = 'nowhere.xml': there is no such file"));
  EXPECT_THAT(refused("<ParameterList name='s'>" + parameter("base", "string", "tube.xml") +
                      "<ParameterList name='vary'>" + axis("CFL", "time/CFL", values("0.3")) +
                      "</ParameterList></ParameterList>"),
              HasSubstr("parameter 'base' = 'tube.xml': is a sweep, not a scene"));
  // The error is that of a parameter which is not varied itself.
  EXPECT_THAT(refused(sweep(axis("law", "materials/gas/law", values("jwl")))),
              testing::AllOf(HasSubstr("sod.xml:15: "), HasSubstr("in run 'law_jwl' of ")));
}

TEST(BatchPlan, TakesScenesSweepsAndFolders) {
  const Folder folder("plan");
  const fs::path sod = data_folder() / "inputs/sod.xml", tube = folder.path / "tube.xml";
  fs::copy_file(sod, folder.path / "first.xml");
  write_file(tube, sweep(axis("CFL", "time/CFL", values("0.3; 0.4"))));
  const BatchPlan plan = plan_batch({folder.path.string(), sod.string()}, {"L1 density"});
  std::vector<std::string> names;
  for (const auto& run : plan.runs) names.push_back(run.name);
  EXPECT_THAT(names, ElementsAre("first", "tube/CFL_0.3", "tube/CFL_0.4", "sod"));
  EXPECT_EQ(plan.results.at(0).label(), "L1 density");
  EXPECT_EQ(plan_batch({tube.string()}, {}).name, "tube");
  EXPECT_EQ(plan_batch({folder.path.string() + "/"}, {}).name, folder.path.filename().string());
}

TEST(BatchPlan, RefusesInOneLine) {
  const Folder folder("noplan");
  const std::string sod = (data_folder() / "inputs/sod.xml").string();
  EXPECT_THROW(plan_batch({folder.path.string()}, {}), InputError);  // holds none
  EXPECT_THROW(plan_batch({sod, sod}, {}), InputError);              // into the same folder
  EXPECT_THROW(plan_batch({sod}, {"L1 densty"}), InputError);
  EXPECT_THROW(plan_batch({sod + "l"}, {}), InputError);
}

std::vector<std::string> shipped_sweeps() {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(data_folder() / "inputs/sweeps"))
    files.push_back(entry.path().string());
  return files;
}

class EverySweep : public testing::TestWithParam<std::string> {};

TEST_P(EverySweep, IsNamedLikeItsFileHasATitleAndEndsInAPicture) {
  EXPECT_EQ(read_input(GetParam()).list->name(), fs::path(GetParam()).stem().string());
  const BatchPlan plan = expand_sweep(GetParam());
  EXPECT_GE(plan.runs.size(), 3u);
  ASSERT_EQ(plan.pictures.size(), 1u);
  EXPECT_FALSE(plan.pictures[0].title.empty());
  for (const auto& run : plan.runs) EXPECT_NO_THROW(try_scene(run)) << run.name;
}

INSTANTIATE_TEST_SUITE_P(Sweeps, EverySweep, testing::ValuesIn(shipped_sweeps()));

}  // namespace
}  // namespace brisance
