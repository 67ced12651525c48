// The same numbers to the last bit, run for run.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <filesystem>

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
