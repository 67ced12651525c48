// Disks that are full or read-only, and folders that are gone: the newest good state is kept and
// used, what is lost is said, and nothing that was good is destroyed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "drivers/files.hpp"
#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::in_quotes;
using test::Ran;
using test::run_program;
using test::run_script;
using test::run_script_alone;
using testing::HasSubstr;

/// Half of a run, by which something can go wrong, in a folder whose name the tests know.
const std::string few =
    " --set output/grid=false --set output/particles=false "
    "--set 'output/history interval=0' ";

std::string first_half(const fs::path& out) { return test::tube(out) + few + "--set time/end=0.1"; }
std::string second_half(const fs::path& out) {
  return "restart " + in_quotes(out) + " --threads 1 --until 0.2";
}

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) all[entry.path().string()] = read_file(entry.path());
  return all;
}

/// Why scripts cannot mount anything here; empty if they can.
std::string cannot_mount() {
  const Folder folder("mount");
  return run_script_alone("mount -t tmpfs none " + in_quotes(folder.path)).err;
}

class DiskFaults : public testing::Test {
 protected:
  Folder folder{"disk"};
  fs::path whole = folder.path / "whole", run = folder.path / "run";

  void SetUp() override {
    ASSERT_EQ(run_program(first_half(whole)).status, 0);
    fs::copy(whole, run, fs::copy_options::recursive);
    ASSERT_EQ(run_program(second_half(whole)).status, 0);
  }
  /// The second half of what has gone through a fault is that of what has not.
  void expect_to_go_on() const {
    const Ran ran = run_program(second_half(run));
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_TRUE(read_file(run / "history.csv") == read_file(whole / "history.csv"));
  }
  static std::ptrdiff_t lines_of(const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  }
};

// There is room for a table, but not for a checkpoint; then for nothing at all.
TEST_F(DiskFaults, AFullDiskLosesNoStateThatWasGood) {
  const std::string why = cannot_mount();
  if (!why.empty()) GTEST_SKIP() << "only who may mount has a small disk: " << why;
  const std::string disk = in_quotes(folder.path / "mounted"), r = disk + "/run",
                    again = "$brisance restart " + r + " --threads 1 --until 0.2 ";
  const Ran ran = run_script_alone(
      "set -e\n"
      "mkdir " +
      disk + "; mount -t tmpfs -o size=4m none " + disk + "; cp -r " + in_quotes(run) + " " + r +
      "; cp -r " + r + " " + disk +
      "/before\n"
      "free=$(df -Pk " +
      disk +
      " | awk 'NR == 2 { print $4 }')\n"
      "head -c $(((free - 200) * 1024)) /dev/zero >" +
      disk +
      "/fill\n"
      "status=0; " +
      again +
      "|| status=$?; echo status $status\n"
      "diff -r " +
      r + "/checkpoints " + disk +
      "/before/checkpoints && echo kept\n"
      "cp " +
      r + "/input.xml " + disk +
      "/before\n"
      "cat /dev/zero >>" +
      disk +
      "/fill 2>/dev/null || true\n"
      "status=0; " +
      again + "2>" + in_quotes(folder.path / "full") +
      " || status=$?\n"
      "echo full $status\n"
      "diff -r " +
      r + "/checkpoints " + disk +
      "/before/checkpoints && echo kept again\n"
      "diff " +
      r + "/input.xml " + disk +
      "/before/input.xml && echo input kept\n"
      "rm -r " +
      in_quotes(run) + "; rm " + disk + "/fill; cp -r " + r + " " + in_quotes(run) + "\n");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("status 0\nkept\n"));
  EXPECT_THAT(ran.err, HasSubstr("no checkpoint: cannot write '"));
  EXPECT_THAT(ran.err, HasSubstr(" MB and the disk has 0 MB left"));
  EXPECT_THAT(ran.out, HasSubstr("full 1\nkept again\ninput kept\n"));
  const std::string full = read_file(folder.path / "full");
  EXPECT_THAT(full, HasSubstr("the disk is full"));
  EXPECT_EQ(lines_of(full), 1) << full;
  expect_to_go_on();
}

// What any process may do to itself: no file may be as long as a checkpoint.
TEST_F(DiskFaults, CheckpointsThatCannotBeWrittenAreToldAndTheRunGoesOn) {
  const auto before = contents(run / "checkpoints");
  const Ran ran = run_script("trap '' XFSZ; ulimit -f 400; exec $brisance " + second_half(run));
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("no checkpoint: cannot write '"));
  EXPECT_EQ(contents(run / "checkpoints"), before);
  EXPECT_TRUE(read_file(run / "history.csv") == read_file(whole / "history.csv"));
  expect_to_go_on();
}

TEST_F(DiskFaults, AReadOnlyFolderStaysAsItIs) {
  const std::string why = cannot_mount();
  if (!why.empty()) GTEST_SKIP() << "root may write in any folder but a mounted one: " << why;
  const auto before = contents(run);
  const auto read_only = [](const fs::path& path) {
    return "mount --bind " + in_quotes(path) + " " + in_quotes(path) +
           " && mount -o remount,bind,ro " + in_quotes(path) + " && exec $brisance ";
  };
  const Ran refused = run_script_alone(read_only(run) + second_half(run));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("the folder is read-only"));
  EXPECT_EQ(lines_of(refused.err), 1) << refused.err;
  EXPECT_EQ(contents(run), before);
  // Where only checkpoints cannot be written, the run goes on without.
  const auto good = contents(run / "checkpoints");
  const Ran ran = run_script_alone(read_only(run / "checkpoints") + second_half(run));
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("no checkpoint: cannot write '"));
  EXPECT_EQ(contents(run / "checkpoints"), good);
  expect_to_go_on();
}

TEST_F(DiskFaults, AFolderThatIsGoneIsMadeAgain) {
  const fs::path out = folder.path / "out", gone = folder.path / "gone";
  const Ran ran = test::meddle_with_program(first_half(out), out / "checkpoints",
                                            [&](pid_t) { fs::rename(out / "checkpoints", gone); });
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_FALSE(test::checkpoints_in(out).empty());
  fs::remove_all(out / "checkpoints");
  const Ran none = run_program(second_half(out));
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr("it holds no checkpoints"));
  EXPECT_EQ(lines_of(none.err), 1) << none.err;
}

}  // namespace
}  // namespace brisance
