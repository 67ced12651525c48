// How two runs differ: column by column here, from outside in the second half.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "drivers/compare.hpp"
#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "drivers/vtk.hpp"
#include "drivers/vtk_read.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(ColumnDifference, IsAShareOfTheRangeInA) {
  ColumnDifference column("pressure");
  const auto at = [](const char* place) { return [=] { return std::string(place); }; };
  column.add(1, 1, at("first"));
  column.add(5, 5.5, at("second"));
  column.add(3, 2.9, at("third"));
  EXPECT_EQ(column.largest(), 0.5);
  EXPECT_EQ(column.share(), 0.125);
  EXPECT_EQ(column.where(), "second");
}

TEST(ColumnDifference, OrOfTheMagnitudeWhereAIsConstant) {
  ColumnDifference column("density");
  const auto here = [] { return std::string(); };
  column.add(4, 5, here);
  EXPECT_EQ(column.share(), 0.2);
  ColumnDifference zero("velocity");
  zero.add(0, 0, here);
  EXPECT_EQ(zero.share(), 0);
}

TEST(ColumnDifference, WhatIsNoNumberInOneOnlyIsInfinite) {
  const auto here = [] { return std::string(); };
  ColumnDifference column("arrival");
  column.add(NAN, NAN, here);
  EXPECT_EQ(column.largest(), 0);
  column.add(1, NAN, here);
  EXPECT_TRUE(std::isinf(column.share()));
}

TEST(CompareTables, MatchesRowsByTimeAndColumnsByName) {
  const FileDifference d =
      compare_tables("a.csv", "step,time,x,old\n0,0,1,1\n1,0.1,2,1\n2,0.2,3,1\n",
                     "time,x,step,new\n0,1,0,1\n0.2,3.5,2,1\n0.3,1,3,1\n");
  EXPECT_EQ(d.count, "2 rows");
  EXPECT_THAT(d.apart, ElementsAre("only in A: 1 row, t = 0.1 s", "only in B: 1 row, t = 0.3 s",
                                   "only in A: column 'old'", "only in B: column 'new'"));
  ASSERT_EQ(d.columns.size(), 3u);
  EXPECT_EQ(d.columns[2].name(), "x");
  EXPECT_EQ(d.columns[2].largest(), 0.5);
  EXPECT_EQ(d.columns[2].where(), "t = 0.2 s");
  EXPECT_FALSE(d.within(1));  // for what only one has
}

TEST(CompareTables, KnowsWordsAndTablesWithoutTime) {
  const FileDifference same = compare_tables("a.csv", "name,x\ngas,1\n", "name,x\ngas,1\n");
  EXPECT_TRUE(same.within(0));
  const FileDifference other = compare_tables("a.csv", "name,x\ngas,1\n", "name,x\nair,1\nair,2\n");
  EXPECT_THAT(other.columns[0].where(), HasSubstr("'gas' and 'air'"));
  EXPECT_THAT(other.apart, ElementsAre("A has 1 rows, B 2"));
}

TEST(ReadGrid, ReadsBackWhatWasWritten) {
  const Folder folder("grid");
  vtk::Box box;
  box.cells = {3, 2, 0};
  const std::vector<double> values = {1, 2, 3, 4, 5, 6};
  vtk::write_vti(folder.path / "grid.vti", box, {}, {vtk::Column("density", values)});
  const vtk::ReadGrid grid = vtk::read_vti(folder.path / "grid.vti");
  EXPECT_THAT(grid.cells, ElementsAre(3, 2, 0));
  ASSERT_EQ(grid.columns.size(), 1u);
  EXPECT_EQ(grid.columns[0].values, values);
  write_file(folder.path / "bad.vti", "nothing");
  EXPECT_THROW(vtk::read_vti(folder.path / "bad.vti"), std::runtime_error);
}

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

std::string tube(const fs::path& out, const std::string& more = "") {
  return "run " + quoted(data_folder() / "inputs/gauges.xml") + " --threads 1 " + more + " --out " +
         quoted(out);
}

class CompareProgram : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new Folder("compare");
    ASSERT_EQ(run_program(tube(run("whole"))).status, 0);
  }
  static void TearDownTestSuite() {
    delete folder;
    folder = nullptr;
  }
  static fs::path run(const char* name) { return folder->path / name; }
  static Ran compare(const char* a, const char* b, const std::string& more = "") {
    return run_program("compare " + quoted(run(a)) + " " + quoted(run(b)) + " " + more);
  }
  static Folder* folder;
};
Folder* CompareProgram::folder = nullptr;

TEST_F(CompareProgram, ARunThatWasCutAndTakenUpIsTheSame) {
  ASSERT_EQ(run_program(tube(run("parts"), "--wall-limit 0.02")).status, 75);
  ASSERT_EQ(run_program("restart " + quoted(run("parts"))).status, 0);
  const Ran ran = compare("whole", "parts");
  EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
  for (const char* part : {"particles: 11 times", "grid: 11 times", "history.csv: 11 rows",
                           "gauges.csv: ", "summary.json: ", "the same: "})
    EXPECT_THAT(ran.out, HasSubstr(part));
}

TEST_F(CompareProgram, ARunOfItsOwnInputIsTheSame) {
  const std::string again = "run " + quoted(run("whole") / "input.xml") + " --threads 1 --out ";
  ASSERT_EQ(run_program(again + quoted(run("again"))).status, 0);
  const Ran ran = compare("whole", "again");
  EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
}

// Four materials, bodies of points, burning, gauges and watches.
TEST_F(CompareProgram, ABombOfItsOwnInputIsTheSame) {
  const fs::path first = data_folder() / "inputs/bomb_cased.xml";
  const std::string rest = " --set time/end=3e-5 --threads 1 --out ";
  ASSERT_EQ(run_program("run " + quoted(first) + rest + quoted(run("bomb"))).status, 0);
  ASSERT_EQ(
      run_program("run " + quoted(run("bomb") / "input.xml") + rest + quoted(run("bomb again")))
          .status,
      0);
  const Ran ran = compare("bomb", "bomb again");
  EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
}

TEST_F(CompareProgram, TellsTheLargestDifferenceAndHoldsItAgainstTheTolerance) {
  ASSERT_EQ(run_program(tube(run("other"), "--set scheme/damping=0.5")).status, 0);
  const Ran ran = compare("whole", "other", "--tolerance 1e-6");
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.out, HasSubstr("differs by"));
  EXPECT_THAT(ran.out, HasSubstr("different: largest difference"));
}

TEST_F(CompareProgram, TellsWhatOnlyOneHas) {
  fs::copy(run("whole"), run("fewer"));
  fs::remove(run("fewer") / "gauges.csv");
  const Ran ran = compare("whole", "fewer");
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.out, HasSubstr("gauges.csv: not compared"));
  EXPECT_THAT(ran.out, HasSubstr("only in A"));
}

TEST_F(CompareProgram, RefusesWhatIsNoRun) {
  fs::create_directories(run("empty"));
  for (const char* none : {"nowhere", "empty"}) {
    const Ran ran = compare("whole", none);
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
  EXPECT_EQ(compare("whole", "whole", "--tolerance -1").status, 2);
}

}  // namespace
}  // namespace brisance
