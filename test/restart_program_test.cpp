// Restart from outside: what people type, and what no process survives.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "drivers/files.hpp"
#include "drivers/folder_lock.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::in_quotes;
using test::Ran;
using test::run_program;
using test::tube;
using testing::HasSubstr;

nlohmann::json summary_of(const fs::path& out) {
  return nlohmann::json::parse(read_file(out / "summary.json"));
}

TEST(RestartProgram, GoesOnAfterTheClockHasStoppedIt) {
  const Folder folder("wall");
  const fs::path whole = folder.path / "whole", parts = folder.path / "parts";
  ASSERT_EQ(run_program(tube(whole)).status, 0);
  Ran ran = run_program(tube(parts) + " --wall-limit 0.05");
  ASSERT_EQ(ran.status, 75) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("brisance restart"));
  EXPECT_EQ(summary_of(parts)["status"], "interrupted");
  ran = run_program("restart " + in_quotes(parts));
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("goes on from step"));
  EXPECT_EQ(summary_of(parts)["status"], "finished");
  for (const char* name : {"history.csv", "particles.pvd", "particles_000010.vtp"})
    EXPECT_TRUE(read_file(parts / name) == read_file(whole / name)) << name;
}

TEST(RestartProgram, GoesOnAfterASignalWithTheBitsOfOneRun) {
  const Folder folder("signal");
  const fs::path whole = folder.path / "whole", parts = folder.path / "parts";
  ASSERT_EQ(run_program(tube(whole)).status, 0);
  Ran ran = test::meddle_with_program(tube(parts), parts / "checkpoints",
                                      [](pid_t child) { ::kill(child, SIGTERM); });
  ASSERT_EQ(ran.status, 75) << ran.err;
  EXPECT_GT(summary_of(parts)["steps"].get<long>(), 0);
  EXPECT_LT(summary_of(parts)["time"].get<double>(), summary_of(whole)["time"].get<double>());
  ran = run_program("restart " + in_quotes(parts));
  EXPECT_EQ(ran.status, 0) << ran.err;
  for (const char* name : {"history.csv", "particles.pvd", "particles_000010.vtp", "grid.pvd"})
    EXPECT_TRUE(read_file(parts / name) == read_file(whole / name)) << name;
}

TEST(RestartProgram, ChangesTheEndAndTheOutputAndNothingElse) {
  const Folder folder("changed");
  const fs::path out = folder.path / "out";
  ASSERT_EQ(run_program(tube(out) + " --set time/end=0.1").status, 0);
  for (const char* wrong : {"--set scheme/damping=0", "--set 'grid/cells={10}'", "--until 0.01",
                            "--set 'output/intervall=1'"}) {
    const Ran refused = run_program("restart " + in_quotes(out) + " " + wrong);
    EXPECT_EQ(refused.status, 2) << wrong;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
  const Ran ran =
      run_program("restart " + in_quotes(out) + " --until 0.12 --set output/grid=false --threads 1");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("ends at 0.12 s instead of 0.1 s"));
  EXPECT_THAT(ran.err, HasSubstr("its step to 0.1 s was cut to end there, as none of one run to "
                                 "0.12 s is"));
  EXPECT_DOUBLE_EQ(summary_of(out)["time"], 0.12);
  const std::string series = read_file(out / "particles.pvd");
  EXPECT_THAT(series, HasSubstr("particles_000012.vtp"));  // 0, 0.01 ... 0.12
  EXPECT_FALSE(fs::exists(out / "particles_000013.vtp"));
}

TEST(RestartProgram, SaysWhyItCannot) {
  const Folder folder("cannot");
  const Ran nowhere = run_program("restart " + in_quotes(folder.path / "nowhere"));
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_THAT(nowhere.err, HasSubstr("there is no such file or folder"));
  const Ran empty = run_program("restart " + in_quotes(folder.path));
  EXPECT_EQ(empty.status, 1);
  EXPECT_THAT(empty.err, HasSubstr("it holds no checkpoints"));
  const FolderLock busy(folder.path);
  for (const std::string& words : {"restart " + in_quotes(folder.path), tube(folder.path)})
    EXPECT_THAT(run_program(words).err, HasSubstr("is in use by another run"));
}

/// Starts the program on one thread and kills it after a while, unless it ends before. Returns
/// whether it was killed.
bool killed_after(const std::string& arguments, std::chrono::milliseconds delay) {
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string command =
        std::string("exec ") + BRISANCE_PROGRAM + " " + arguments + " >/dev/null 2>&1 </dev/null";
    ::setenv("OMP_PROC_BIND", "false", 1);
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  std::this_thread::sleep_for(delay);
  ::kill(child, SIGKILL);
  int code = 0;
  ::waitpid(child, &code, 0);
  return WIFSIGNALED(code);
}

bool has_checkpoint(const fs::path& run) {
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(run / "checkpoints", missing))
    if (entry.path().extension() == ".h5") return true;
  return false;
}

/// Kills a run so often, each time some random moment after it was started or taken up.
void expect_to_survive(int kills, unsigned seed) {
  const Folder folder("kill");
  const fs::path whole = folder.path / "whole", parts = folder.path / "parts";
  const auto started = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program(tube(whole)).status, 0);
  const auto needed = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::steady_clock::now() - started);
  std::mt19937 random(seed);
  int done = 0;
  for (int attempt = 0; done < kills && attempt < 4 * kills; ++attempt) {
    const bool begun = has_checkpoint(parts);
    const std::chrono::milliseconds delay(random() % (needed.count() + 1));
    if (killed_after(begun ? "restart " + in_quotes(parts) + " --threads 1" : tube(parts), delay))
      ++done;
    else
      fs::remove_all(parts);  // came to its end: again from the start
  }
  EXPECT_EQ(done, kills);
  const bool begun = has_checkpoint(parts);
  const Ran last = run_program(begun ? "restart " + in_quotes(parts) + " --threads 1" : tube(parts));
  ASSERT_EQ(last.status, 0) << last.err;
  for (const char* name : {"history.csv", "particles.pvd", "particles_000010.vtp", "grid.pvd"})
    EXPECT_TRUE(read_file(parts / name) == read_file(whole / name)) << name;
}

TEST(RestartProgram, SurvivesFiveKills) { expect_to_survive(5, 1); }
TEST(RestartProgram, SurvivesFiftyKillsSlow) { expect_to_survive(50, 2); }

}  // namespace
}  // namespace brisance
