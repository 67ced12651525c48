// What a run tells at its end, on the screen, in log.txt and in summary.json; and what pictures and
// tables do with an output that has not everything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "drivers/files.hpp"
#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;
using testing::HasSubstr;
using testing::StartsWith;

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

Ran run_tube(const fs::path& out, const std::string& more = "") {
  return run_program("run " + in_quotes(test::input("sod")) +
                     " --set 'grid/cells={50}' --set 'grid/cell size=0.02' " + more + " --out " +
                     in_quotes(out));
}

nlohmann::json summary_of(const fs::path& out) {
  return nlohmann::json::parse(read_file(out / "summary.json"));
}

TEST(Report, SaysWhatWasModelledHowItWentAndWhereToLook) {
  const Folder folder("report");
  const Ran ran = run_tube(folder.path, "--set checkpoint/steps=20");
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* part :
       {"sod: Sod's shock tube\n", "model    line, 50 cells of 0.02 m, ", "gas (perfect gas): ",
        "scheme   preset balanced, midpoint; fluids: linear shapes, FLIP, cell quadrature\n",
        "run      finished at t = 0.2 s after ", "kept     mass to ", "time     ", "sort particles",
        "steps, between kernels", "output  ", "checkpoints  ", "wait for the disk", "the rest",
        "checks   ", "L1 density", "files    results in ", "particles.pvd, grid.pvd, history.csv",
        "look     brisance plot '"})
    EXPECT_THAT(ran.out, HasSubstr(part));
  EXPECT_THAT(read_file(folder.path / "log.txt"), HasSubstr(ran.out));
}

TEST(Report, IsInTheSummaryForMachines) {
  const Folder folder("summary");
  ASSERT_EQ(run_tube(folder.path, "--set checkpoint/steps=20").status, 0);
  const auto j = summary_of(folder.path);
  const auto& gas = j["model"]["materials"][0];
  EXPECT_EQ(gas["name"], "gas");
  EXPECT_EQ(gas["law"], "perfect gas");
  EXPECT_EQ(gas["particles"], j["particles"]);
  EXPECT_EQ(j["model"]["cells"], std::vector<int>{50});
  const auto& spent = j["time_spent"];
  std::map<std::string, double> calls;
  double kernels = 0, parts = 0;
  for (const auto& row : spent["kernels"]) {
    kernels += row["share"].get<double>();
    calls[row["name"]] = row["calls"];
  }
  for (const auto& row : spent["parts"]) {
    parts += row["share"].get<double>();
    calls[row["name"]] = row["calls"];
  }
  EXPECT_LE(kernels, 1);
  EXPECT_NEAR(parts, 1, 1e-9);
  EXPECT_EQ(calls["steps"], j["steps"]);
  EXPECT_EQ(calls["fastest strain"], j["steps"]);
  EXPECT_EQ(calls["output"], 11);
  EXPECT_EQ(calls["checkpoints"], j["steps"].get<int>() / 20 + 1);
  EXPECT_FALSE(spent["since_restart"]);
}

TEST(Report, OfARestartCountsFromThere) {
  const Folder folder("again");
  ASSERT_EQ(run_tube(folder.path, "--set checkpoint/steps=20 --set time/end=0.1").status, 0);
  const Ran ran = run_program("restart " + in_quotes(folder.path) + " --until 0.2");
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr(" by the clock since the restart"));
  EXPECT_TRUE(summary_of(folder.path)["time_spent"]["since_restart"]);
}

TEST(Check, SaysWhatTheOutputTakes) {
  const Ran ran = run_program("check " + in_quotes(test::input("sod")));
  EXPECT_THAT(ran.out, HasSubstr("output     about 11 times "));
}

TEST(Export, HasTheColumnsThatThereAre) {
  const Folder folder("export");
  ASSERT_EQ(run_tube(folder.path, "--set 'output/columns={id, density}'").status, 0);
  const fs::path csv = folder.path / "a.csv";
  ASSERT_EQ(run_program("export " + in_quotes(folder.path) + " --csv " + in_quotes(csv)).status, 0);
  const std::string text = read_file(csv);
  EXPECT_THAT(text, StartsWith("id,x,y,z,density\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'),
            1 + summary_of(folder.path)["particles"].get<long>());
}

TEST(Plot, DrawsSinglePrecision) {
  const Folder folder("single");
  ASSERT_EQ(run_tube(folder.path, "--set output/precision=single").status, 0);
  const Ran ran = run_program("plot " + in_quotes(folder.path));
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(fs::exists(folder.path / "pictures/profiles.png"));
}

TEST(Plot, LeavesOutAPictureWhoseColumnsAreNotThereAndSaysSo) {
  const Folder folder("lacking");
  ASSERT_EQ(run_tube(folder.path, "--set 'output/columns={density, velocity}'").status, 0);
  const Ran ran = run_program("plot " + in_quotes(folder.path));
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.err,
            "plot: no picture 'profiles': the output has no column 'mass', 'volume', 'pressure', "
            "'energy' (output/columns)\n");
  EXPECT_FALSE(fs::exists(folder.path / "pictures/profiles.png"));
  EXPECT_TRUE(fs::exists(folder.path / "pictures/history.png"));
}

}  // namespace
}  // namespace brisance
