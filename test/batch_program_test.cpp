// Batches the way people run them: a tube at several CFL numbers, stopped, taken up, changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "drivers/child.hpp"
#include "drivers/files.hpp"
#include "drivers/folder_lock.hpp"
#include "drivers/locations.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class BatchProgram : public testing::Test {
 protected:
  /// The tube on so many cells, at these CFL numbers.
  void write_sweep(const std::string& numbers, int cells = 50, const std::string& more = "") {
    const auto n = std::to_string(cells), size = std::to_string(1.0 / cells);
    write_file(sweep,
               "<ParameterList name='tube'>\n"
               "<Parameter name='base' type='string' value='" +
                   (data_folder() / "inputs/sod.xml").string() +
                   "'/>\n<Parameter name='changes' type='string' value='grid/cells={" + n +
                   "}; grid/cell size=" + size +
                   "'/>\n<Parameter name='results' type='string' value='L1 density'/>\n"
                   "<ParameterList name='vary'><ParameterList name='CFL'>\n"
                   "<Parameter name='parameter' type='string' value='time/CFL'/>\n"
                   "<Parameter name='values' type='Array(double)' value='{" +
                   numbers + "}'/>\n</ParameterList></ParameterList>\n" + more +
                   "</ParameterList>\n");
  }
  Ran batch(const std::string& more = "--jobs 2") {
    return run_program("batch " + quoted(sweep) + " --out " + quoted(out) + " " + more);
  }
  std::vector<std::string> table() { return lines_of(read_file(out / "batch.csv")); }

  Folder folder{"batch"};
  fs::path sweep = folder.path / "tube.xml", out = folder.path / "out";
};

TEST_F(BatchProgram, DoesOnlyWhatIsLeftToDo) {
  write_sweep("0.3, 0.4", 200);
  const Ran first = batch();
  ASSERT_EQ(first.status, 0) << first.err << first.out;
  EXPECT_THAT(first.out, HasSubstr("2 of 2 runs finished with all checks passed"));
  ASSERT_EQ(table().size(), 3u);
  EXPECT_EQ(table()[0], "run,status,checks passed,checks failed,wall time [s],CFL,L1 density");
  EXPECT_THAT(table()[1], StartsWith("CFL_0.3,finished,11,0,"));
  EXPECT_TRUE(fs::exists(out / "runs/CFL_0.3/output.log"));

  const auto written = fs::last_write_time(out / "runs/CFL_0.3/history.csv");
  write_sweep("0.3, 0.35", 200);
  EXPECT_EQ(batch("--list").out, "finished  CFL_0.3\nto run    CFL_0.35\n");
  const Ran second = batch();
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_THAT(second.err, HasSubstr("1 finished before, 0 to go on, 1 to run"));
  EXPECT_EQ(fs::last_write_time(out / "runs/CFL_0.3/history.csv"), written);

  write_sweep("0.3, 0.35", 100);  // of the same names, and other runs
  EXPECT_THAT(batch("--list").out, Not(HasSubstr("finished")));
}

// The limits of the tube hold for 200 cells.
TEST_F(BatchProgram, TellsMissedChecksByItsStatus) {
  write_sweep("0.3");
  const Ran ran = batch();
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.out, HasSubstr("0 of 1 runs finished with all checks passed"));
}

TEST_F(BatchProgram, GoesOnAfterAFailure) {
  write_sweep("0.3, 0.35, 0.4", 200);
  {
    const FolderLock busy(out / "runs/CFL_0.3");
    const Ran ran = batch("--jobs 1 --result 'shock position'");
    EXPECT_THAT(table()[0], HasSubstr(",L1 density,shock position [cells]"));
    EXPECT_EQ(ran.status, 1);
    EXPECT_THAT(ran.err, HasSubstr("failed:   CFL_0.3"));
    EXPECT_THAT(ran.err, HasSubstr("is in use by another run"));
    EXPECT_THAT(table()[1], StartsWith("CFL_0.3,failed,"));
    EXPECT_THAT(table()[3], StartsWith("CFL_0.4,finished,"));
  }
  const Ran again = batch();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("2 finished before, 0 to go on, 1 to run"));
}

class Stopped : public BatchProgram, public testing::WithParamInterface<int> {};

TEST_P(Stopped, GoesOnFromItsCheckpointsToTheSameNumbers) {
  write_sweep("0.4, 0.45, 0.5", 600);
  const Ran stopped =
      test::interrupt_program({"batch", sweep.string(), "--jobs", "2", "--out", out.string()},
                              out / "runs/CFL_0.4/history.csv", GetParam());
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.err, HasSubstr("asked to write a checkpoint"));
  EXPECT_THAT(stopped.out, HasSubstr("stopped; the same command goes on"));
  EXPECT_THAT(table()[1], StartsWith("CFL_0.4,interrupted,"));
  EXPECT_THAT(table()[3], StartsWith("CFL_0.5,not run,"));
  EXPECT_THAT(batch("--list").out, StartsWith("to go on  CFL_0.4\n"));
  const Ran rest = batch();
  EXPECT_EQ(rest.status, 0) << rest.err << rest.out;
  EXPECT_THAT(rest.err, HasSubstr("goes on:  CFL_0.4"));
  const fs::path whole = folder.path / "whole";
  const std::string threads = std::to_string(std::max(1, usable_cores() / 2));
  ASSERT_EQ(run_program("run " + quoted(out / "scenes/CFL_0.4.xml") + " --threads " + threads +
                        " --out " + quoted(whole))
                .status,
            0);
  const Ran compared = run_program("compare " + quoted(whole) + " " + quoted(out / "runs/CFL_0.4"));
  EXPECT_EQ(compared.status, 0) << compared.out;
}

INSTANTIATE_TEST_SUITE_P(Signals, Stopped, testing::Values(SIGINT, SIGTERM));

TEST_F(BatchProgram, RefusesBadInputBeforeAnythingRuns) {
  write_sweep("0.3, 7");
  const Ran ran = batch();
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(lines_of(ran.err).size(), 1u) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("tube.xml:7: list 'vary/CFL', parameter 'values' = '7'"));
  EXPECT_FALSE(fs::exists(out));
  const Ran as_scene = run_program("run " + quoted(sweep));
  EXPECT_EQ(as_scene.status, 2);
  EXPECT_THAT(as_scene.err, HasSubstr("is a sweep, not a scene"));
  EXPECT_EQ(run_program("batch " + quoted(folder.path / "none.xml")).status, 2);
  EXPECT_EQ(batch("--result 'L1 densty'").status, 2);
  EXPECT_EQ(batch("--jobs 0").status, 2);
}

// How long a step is shows only where particles are placed.
TEST_F(BatchProgram, RefusesWhatOnlySettingUpShows) {
  write_sweep("0.1, 1e9");
  std::string text = read_file(sweep);
  text.replace(text.find("time/CFL"), 8, "time/end");
  write_file(sweep, text);
  const Ran ran = batch();
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.err, HasSubstr("in run 'CFL_1e+09'")) << ran.err;
  EXPECT_FALSE(fs::exists(out / "runs"));
}

TEST_F(BatchProgram, EndsInAPicture) {
  write_sweep("0.3, 0.4", 50,
              "<ParameterList name='plot'><Parameter name='x' type='string' value='CFL'/>\n"
              "<Parameter name='y' type='string' value='L1 density'/></ParameterList>\n");
  const Ran ran = batch();
  EXPECT_THAT(ran.out, HasSubstr("tube.png")) << ran.err;
  EXPECT_EQ(read_file(out / "tube.png").substr(1, 3), "PNG");
}

TEST_F(BatchProgram, IsDescribed) {
  const Ran any = run_program("describe sweep");
  EXPECT_EQ(any.status, 0);
  EXPECT_THAT(any.out, HasSubstr("combine"));
  write_sweep("0.3");
  EXPECT_THAT(run_program("describe " + quoted(sweep)).out, HasSubstr("CFL: a parameter"));
}

}  // namespace
}  // namespace brisance
