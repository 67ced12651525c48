// The program from outside: what people type, what they get, and what they are told.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "drivers/files.hpp"
#include "drivers/input.hpp"
#include "drivers/ledger.hpp"
#include "drivers/locations.hpp"
#include "drivers/scene.hpp"
#include "drivers/vtk_read.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;

std::string input(const std::string& name) {
  return (data_folder() / "inputs" / (name + ".xml")).string();
}
const char* const small = " --set 'grid/cells={50}' --set 'grid/cell size=0.02' ";

nlohmann::json summary_of(const fs::path& out) {
  return nlohmann::json::parse(read_file(out / "summary.json"));
}

long lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(Program, TellsHowItIsUsedAndWhatItIs) {
  const Ran help = run_program("--help");
  EXPECT_EQ(help.status, 0);
  for (const char* command : {"run", "verify", "check", "describe", "export", "plot"})
    EXPECT_NE(help.out.find(command), help.out.npos) << command;
  EXPECT_EQ(help.err, "");
  const Ran version = run_program("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.compare(0, 9, "brisance "), 0);
  for (const char* part : {"Kokkos", "HDF5", "MPI"})
    EXPECT_NE(version.out.find(part), version.out.npos);
  EXPECT_EQ(run_program("run --help").status, 0);
}

TEST(Program, ChecksAScene) {
  const Ran ran = run_program("check '" + input("riemann") + "'");
  EXPECT_EQ(ran.status, 0) << ran.err;
  for (const char* part :
       {"cells      200\n", "particles  600\n", "steps", "position", "sorting", "scatter momentum"})
    EXPECT_NE(ran.out.find(part), ran.out.npos) << part;
}

TEST(Program, DescribesListsLawsSolutionsAndScenes) {
  const std::pair<const char*, const char*> asked[] = {{"'perfect gas'", "gamma"},
                                                       {"riemann", "left density"},
                                                       {"time", "CFL"},
                                                       {"'artificial viscosity'", "Kurapatenko"},
                                                       {"", "materials"}};
  for (const auto& [name, part] : asked) {
    const Ran ran = run_program(std::string("describe ") + name);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.out.find(part), ran.out.npos) << name;
  }
  EXPECT_EQ(run_program("describe '" + input("sod") + "'").status, 0);
  const Ran unknown = run_program("describe tmie");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("did you mean 'time'"), unknown.err.npos) << unknown.err;
}

class AfterARun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new Folder("run");
    out = folder->path / "deep/er";
    ran = run_program("run '" + input("sod") + "'" + small + "--out '" + out.string() + "'");
  }
  static void TearDownTestSuite() {
    delete folder;
    folder = nullptr;
  }
  static Folder* folder;
  static fs::path out;
  static Ran ran;
};
Folder* AfterARun::folder = nullptr;
fs::path AfterARun::out;
Ran AfterARun::ran;

TEST_F(AfterARun, AllFilesAreThere) {
  ASSERT_EQ(ran.status, 0) << ran.err;
  for (const char* file : {"input.xml", "history.csv", "summary.json", "exact.csv", "log.txt",
                           "particles.pvd", "grid.pvd", "particles_000000.vtp",
                           "particles_000010.vtp", "grid_000000.vti", "grid_000010.vti"})
    EXPECT_TRUE(fs::exists(out / file)) << file;
  for (const auto& entry : fs::directory_iterator(out))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(AfterARun, HistoryHasALineForEachOutput) {
  const std::string history = read_file(out / "history.csv");
  std::string head = Ledger(Balance{}).head();  // of no material
  head.pop_back();
  EXPECT_EQ(history.compare(0, head.size(), head), 0);
  EXPECT_EQ(lines_of(history), 12);  // head, start, nine between, end
  EXPECT_EQ(test::columns_of_last_line(history).at(1), "0.20000000000000001");
}

TEST_F(AfterARun, SummaryHasItsKeys) {
  const auto j = summary_of(out);
  for (const char* key : {"scene",
                          "title",
                          "geometry",
                          "cell_size",
                          "version",
                          "commit",
                          "status",
                          "steps",
                          "time",
                          "particles",
                          "wall_seconds",
                          "cpu_seconds",
                          "particle_steps_per_second",
                          "mass_error",
                          "momentum_error",
                          "energy_error",
                          "floors",
                          "outflow_mass",
                          "measures",
                          "checks"})
    EXPECT_TRUE(j.contains(key)) << key;
  EXPECT_EQ(j["status"], "finished");
  EXPECT_EQ(j["time"], 0.2);
  EXPECT_EQ(j["measures"]["L1 density"]["unit"], "-");
}

TEST_F(AfterARun, ItsInputIsCompleteAndCanBeRunAgain) {
  const Document document = read_input((out / "input.xml").string());
  const List scene = complete_scene(*document.list);
  EXPECT_TRUE(Teuchos::haveSameValues(scene, *document.list));
  EXPECT_EQ(get<std::vector<int>>(scene.sublist("grid"), "cells"), std::vector<int>{50});
}

TEST_F(AfterARun, ExportHasItsHeadAndAllParticles) {
  const fs::path csv = out / "table.csv";
  const Ran ended = run_program("export '" + out.string() + "' --csv '" + csv.string() + "'");
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string text = read_file(csv);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "material,id,x,y,z,vx,vy,vz,mass,volume,density,pressure,energy");
  EXPECT_EQ(lines_of(text), 1 + summary_of(out)["particles"].get<long>());
  EXPECT_EQ(text.substr(text.find('\n') + 1, 4), "gas,");
  const fs::path start = out / "start.csv";
  ASSERT_EQ(
      run_program("export '" + out.string() + "' --time 0 --csv '" + start.string() + "'").status,
      0);
  EXPECT_EQ(lines_of(read_file(start)), 1 + 150);
}

TEST_F(AfterARun, RunningAgainReplacesTheResults) {
  const Ran again =
      run_program("run '" + input("sod") + "'" + small + "--out '" + out.string() + "'");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(lines_of(read_file(out / "history.csv")), 12);
}

TEST(Program, WithoutOutWritesBesideItself) {
  const Folder folder("default");
  const Ran ran = run_program("run '" + input("sod") + "'" + small, folder.path);
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(fs::exists(folder.path / "out/sod/summary.json"));
}

TEST(Program, WritesWhatIsAskedForOnly) {
  const Folder folder("sparse");
  const Ran ran = run_program("run '" + input("sod") + "'" + small +
                              "--set output/particles=false --set output/interval=0.05 --out '" +
                              folder.path.string() + "'");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_FALSE(fs::exists(folder.path / "particles.pvd"));
  EXPECT_TRUE(fs::exists(folder.path / "grid_000004.vti"));
  EXPECT_FALSE(fs::exists(folder.path / "grid_000005.vti"));
  const Ran none = run_program("export '" + folder.path.string() + "' --csv '" +
                               folder.path.string() + "/a.csv'");
  EXPECT_EQ(none.status, 1);
  EXPECT_EQ(lines_of(none.err), 1) << none.err;
}

// Sod's tube to 0.2 with lines every 0.01: head, start, 19 between, end; pictures stay where they
// were.
TEST(Program, WritesMoreHistoryThanPicturesWhenAsked) {
  const Folder folder("history");
  const Ran ran =
      run_program("run '" + input("sod") + "'" + small +
                  "--set 'output/history interval=0.01' --out '" + folder.path.string() + "'");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(lines_of(read_file(folder.path / "history.csv")), 22);
  EXPECT_TRUE(fs::exists(folder.path / "grid_000010.vti"));
  EXPECT_FALSE(fs::exists(folder.path / "grid_000011.vti"));
}

TEST(Program, WritesWhatGaugesSee) {
  const Folder folder("gauges");
  const Ran ran = run_program("run '" + input("gauges") + "' --set gauges/interval=0.02 --out '" +
                              folder.path.string() + "'");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(lines_of(read_file(folder.path / "gauges.csv")), 12);
  EXPECT_EQ(summary_of(folder.path)["measures"]["ahead arrival"]["unit"], "s");
  EXPECT_FALSE(summary_of(folder.path)["measures"]["ahead impulse"]["value"].is_null());
}

TEST(Program, RunsRiemannToItsLimits) {
  const Folder folder("riemann");
  const Ran ran =
      run_program("run '" + input("riemann") + "' --out '" + folder.path.string() + "'");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto j = summary_of(folder.path);
  EXPECT_GE(j["checks"].size(), 10u);
  for (const auto& check : j["checks"]) EXPECT_EQ(check["verdict"], "reached") << check;
}

TEST(Program, TellsInItsStatusWhetherLimitsAreReached) {
  const Folder folder("verify");
  const fs::path scene = folder.path / "tube.xml";
  Document document = read_input(input("sod"));
  List& list = *document.list;
  list.sublist("grid").set("cells", Teuchos::Array<int>(1, 50)).set("cell size", 0.02);
  list.remove("checks");
  list.sublist("checks").sublist("mass error").set("most", 1e-12);
  write_input(list, scene.string(), "");
  const Ran reached = run_program("verify '" + scene.string() + "'", folder.path);
  EXPECT_EQ(reached.status, 0) << reached.err << reached.out;
  EXPECT_NE(reached.out.find("1 reached, 0 missed"), reached.out.npos) << reached.out;
  list.sublist("checks").sublist("L1 density").set("most", 1e-9);
  write_input(list, scene.string(), "");
  const Ran missed = run_program("verify '" + scene.string() + "'", folder.path);
  EXPECT_EQ(missed.status, 1);
  EXPECT_NE(missed.out.find("1 reached, 1 missed"), missed.out.npos) << missed.out;
  EXPECT_FALSE(fs::exists(folder.path / "out"));
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, LeavesCompleteOutput) {
  const Folder folder("interrupt");
  const fs::path out = folder.path / "out";
  const Ran ran = test::interrupt_program(
      {"run", input("sod"), "--set", "time/end=0.19", "--set", "grid/cells={20000}", "--set",
       "grid/cell size=0.00005", "--out", out.string()},
      out / "history.csv", GetParam());
  EXPECT_EQ(ran.status, 75) << ran.err;
  const auto j = summary_of(out);
  EXPECT_EQ(j["status"], "interrupted");
  EXPECT_LT(j["time"], 0.19);
  EXPECT_EQ(j["checks"].size(), 0u);
  const std::string history = read_file(out / "history.csv");
  EXPECT_EQ(history.back(), '\n');
  EXPECT_EQ(std::stol(test::columns_of_last_line(history).at(0)), j["steps"].get<long>());
  const Ran exported =
      run_program("export '" + out.string() + "' --csv '" + (out / "a.csv").string() + "'");
  EXPECT_EQ(exported.status, 0) << exported.err;
  EXPECT_EQ(lines_of(read_file(out / "a.csv")), 1 + j["particles"].get<long>());
}
INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace brisance
