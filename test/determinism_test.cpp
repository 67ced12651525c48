// The same numbers to the last bit, run for run.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <filesystem>
#include <string>
#include <utility>

#include "drivers/commands.hpp"
#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "drivers/run.hpp"
#include "test/program.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

/// A blast in the plane with splitting, relaxations and walls; short.
std::string blast_arguments(const fs::path& out) {
  return "run '" + (data_folder() / "inputs/sedov_table1.xml").string() +
         "' --set 'time/end=2e-6' --set 'grid/cells={40,40}' --set 'grid/origin={-0.1,-0.1}' "
         "--out '" +
         out.string() + "'";
}

TEST(Determinism, TwoRunsOfTheProgramWriteTheSameBytes) {
  const test::Folder folder("determinism");
  std::string files[2];
  for (int k = 0; k < 2; ++k) {
    const fs::path out = folder.path / std::to_string(k);
    const auto ran = test::run_program(blast_arguments(out));
    ASSERT_EQ(ran.status, 0) << ran.err;
    for (const char* name : {"particles_000000.vtp", "particles_000010.vtp", "grid_000010.vti"})
      files[k] += read_file(out / name);
    files[k] += read_file(out / "history.csv");
  }
  EXPECT_TRUE(files[0] == files[1]);
}

struct OfAnyThreads : testing::TestWithParam<std::pair<const char*, const char*>> {};

// Gas, explosive, steel and concrete at once, until the case breaks; a mass on a spring; a shock
// that leaves through free ends; gas that drifts through periodic ones, sorted in waves. Three
// threads share few rows: none has as much as another.
TEST_P(OfAnyThreads, GivesTheSameBits) {
  const test::Folder folder("threads");
  const auto [name, end] = GetParam();
  std::string one;
  for (const int threads : {1, 2, 3}) {
    const fs::path out = folder.path / std::to_string(threads);
    const auto ran = test::run_program(
        "run '" + (data_folder() / "inputs" / (std::string(name) + ".xml")).string() +
        "' --set 'time/end=" + end + "' --threads " + std::to_string(threads) + " --out '" +
        out.string() + "'");
    ASSERT_EQ(ran.status, 0) << ran.err;
    if (threads == 1) {
      one = out.string();
      continue;
    }
    const auto compared = test::run_program("compare '" + one + "' '" + out.string() + "'");
    EXPECT_EQ(compared.status, 0) << compared.out;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, OfAnyThreads,
                         testing::Values(std::pair{"bomb_quarter", "2e-5"},
                                         std::pair{"piston_container", "2e-4"},
                                         std::pair{"elastic_discs", "0.2"},
                                         std::pair{"sedov_table1", "2e-6"},
                                         std::pair{"vortex", "0.5"}));

TEST(Determinism, TwoRunsInOneProcessAreTheSame) {
  const auto end = [] {
    return test::simulated(test::scene(2, {"grid/cells={20, 8}", "bodies/first/pressure=20",
                                           "boundaries/x high=free", "time/end=0.2"}))
        ->snapshot();
  };
  const Snapshot a = end(), b = end();
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.table.x, b.table.x);
  EXPECT_EQ(a.table.vy, b.table.vy);
  EXPECT_EQ(a.table.energy, b.table.energy);
  EXPECT_EQ(a.table.volume, b.table.volume);
}

// Sums over threads are taken in another order: only round-off may differ, here after a hundred
// steps of a scheme that is stable.
TEST(Determinism, AnotherNumberOfThreadsChangesRoundOffOnly) {
  const test::Folder folder("threads");
  std::string last[2];
  double energy[2];
  for (int k = 0; k < 2; ++k) {
    const fs::path out = folder.path / std::to_string(k);
    const auto ran =
        test::run_program(blast_arguments(out) + " --threads " + std::to_string(k + 1));
    ASSERT_EQ(ran.status, 0) << ran.err;
    const std::string history = read_file(out / "history.csv");
    const auto columns = test::columns_of_last_line(history);
    energy[k] = std::stod(columns.at(8));
    last[k] = columns.at(0) + "," + columns.at(3);  // steps and particles
  }
  EXPECT_EQ(last[0], last[1]);
  EXPECT_NEAR(energy[0] / energy[1], 1, 1e-9);
}

}  // namespace
}  // namespace brisance
