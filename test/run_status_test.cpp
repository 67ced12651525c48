// What is told of a run from its folder, while it goes on, after its end, and when it was killed.
#include "drivers/run_status.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/files.hpp"
#include "drivers/folder_lock.hpp"
#include "drivers/locations.hpp"
#include "drivers/progress.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;
using Phase = RunStatus::Phase;

Progress::Clock::time_point wall_time;
Progress::Clock::time_point fake_now() { return wall_time; }

/// A folder in which a run of 100 steps to 0.2 s writes its log as runs do, one second a step.
class StatusOfARun : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy(data_folder() / "inputs/sod.xml", folder.path / "input.xml");
    options.end = 0.2;
    options.log = folder.path / "log.txt";
  }

  void steps(Progress& progress, int from, int to) {
    for (int step = from + 1; step <= to; ++step) {
      wall_time += std::chrono::seconds(1);
      progress.update({0.002 * step, 0.002, step, 1000});
    }
  }
  RunStatus read() { return read_run_status(folder.path); }

  Folder folder{"status"};
  Progress::Options options;
  std::ostringstream screen;
  Progress::Screen quiet{screen, false, 80, fake_now};
};

TEST_F(StatusOfARun, BeforeItsFirstLineItStarts) {
  const FolderLock lock(folder.path);
  EXPECT_EQ(read().phase, Phase::starting);
  EXPECT_EQ(line_of(read()), "starting");
}

TEST_F(StatusOfARun, OnItsWayItIsThatOfTheLastLine) {
  const FolderLock lock(folder.path);
  Progress progress(options, quiet);
  progress.note("checkpoints of an earlier run are now in 'checkpoints.before'");
  steps(progress, 0, 31);
  const RunStatus s = read();
  EXPECT_EQ(s.phase, Phase::running);
  EXPECT_EQ(s.step, 30);  // the last line is that of the last tenth
  EXPECT_DOUBLE_EQ(s.time, 0.06);
  EXPECT_NEAR(s.percent, 30, 1e-9);
  EXPECT_EQ(s.left, "1 min 10 s");
  EXPECT_EQ(s.rate, "1 k");
  EXPECT_DOUBLE_EQ(s.dt, 0.002);
  EXPECT_EQ(s.notes, std::vector<std::string>{
                         "checkpoints of an earlier run are now in 'checkpoints.before'"});
  EXPECT_LT(s.age, 60);
}

TEST_F(StatusOfARun, AHistoryThatIsNewerThanTheLogCounts) {
  const FolderLock lock(folder.path);
  Progress progress(options, quiet);
  steps(progress, 0, 20);
  write_file(folder.path / "history.csv",
             "step,time,dt,energy_error\n0,0,0.002,0\n50,0.1,0.001,-3e-15\n60,0.12,0.0");
  const RunStatus s = read();
  EXPECT_EQ(s.step, 50);
  EXPECT_NEAR(s.percent, 50, 1e-9);
  EXPECT_DOUBLE_EQ(s.dt, 0.001);
  ASSERT_TRUE(s.energy);
  EXPECT_DOUBLE_EQ(s.energy->error, -3e-15);
  EXPECT_DOUBLE_EQ(s.energy->time, 0.1);
}

TEST_F(StatusOfARun, AtItsEndItHasTheVerdicts) {
  {
    Progress progress(options, quiet);
    steps(progress, 0, 100);
    progress.finish({0.2, 0.002, 100, 1000});
    const FolderLock lock(folder.path);
    EXPECT_EQ(read().phase, Phase::running);  // it writes what it has measured
  }
  write_file(folder.path / "summary.json",
             R"({"status": "finished", "checks": [{"verdict": "reached"}, {"verdict": "missed"},
                 {"verdict": "reached"}]})");
  const RunStatus s = read();
  EXPECT_EQ(s.phase, Phase::ended);
  EXPECT_EQ(s.status, "finished");
  EXPECT_EQ(line_of(s),
            "done: t 0.2 s, step 100, 1 min 40 s, 1 k particle-steps/s; limits: 2 reached, 1 "
            "missed");
}

TEST_F(StatusOfARun, AStoppedOneTellsHowToGoOn) {
  {
    Progress progress(options, quiet);
    steps(progress, 0, 40);
    progress.finish({0.08, 0.002, 40, 1000});
  }
  fs::create_directory(folder.path / "checkpoints");
  write_file(folder.path / "checkpoints/step_000000000020.h5", "");
  write_file(folder.path / "checkpoints/step_000000000040.h5", "");
  write_file(folder.path / "summary.json", R"({"status": "interrupted", "checks": []})");
  const RunStatus s = read();
  EXPECT_EQ(s.phase, Phase::ended);
  EXPECT_NEAR(s.percent, 40, 1e-9);
  ASSERT_TRUE(s.checkpoint);
  EXPECT_EQ(s.checkpoint->file, "step_000000000040.h5");
  const std::string block = block_of(s, folder.path, 500);
  EXPECT_NE(block.find("stopped at 40.0 %"), block.npos) << block;
  EXPECT_NE(block.find("restart '" + folder.path.string()), block.npos) << block;
}

TEST_F(StatusOfARun, AKilledOneIsCutOff) {
  { const FolderLock lock(folder.path); }  // leaves its file behind
  Progress progress(options, quiet);
  steps(progress, 0, 40);
  EXPECT_EQ(read().phase, Phase::cut_off);
  EXPECT_EQ(line_of(read()).find("cut off at 40.0 %"), 0u) << line_of(read());
}

TEST_F(StatusOfARun, WithoutALockTheAgeOfItsLogTells) {
  Progress progress(options, quiet);
  steps(progress, 0, 40);
  EXPECT_EQ(read().phase, Phase::running);
  fs::last_write_time(options.log, fs::file_time_type::clock::now() - std::chrono::minutes(2));
  EXPECT_EQ(read().phase, Phase::cut_off);
}

TEST_F(StatusOfARun, IsNoWiderThanTheScreen) {
  const FolderLock lock(folder.path);
  Progress progress(options, quiet);
  steps(progress, 0, 40);
  std::istringstream block(block_of(read(), folder.path, 20));
  for (std::string line; std::getline(block, line);) EXPECT_LE(line.size(), 20u) << line;
}

TEST_F(StatusOfARun, IsThatOfTheProgram) {
  const fs::path out = folder.path / "out";
  const Ran ran = run_program("run '" + (data_folder() / "inputs/sod.xml").string() +
                              "' --set 'grid/cells={50}' --set 'grid/cell size=0.02' --out '" +
                              out.string() + "'");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Ran watched = run_program("watch '" + out.string() + "'");
  EXPECT_EQ(watched.status, 0) << watched.err;
  EXPECT_EQ(watched.out.find("done: t 0.2 s, step "), 0u) << watched.out;
  EXPECT_EQ(std::count(watched.out.begin(), watched.out.end(), '\n'), 1) << watched.out;
  const Ran once = run_program("watch --once '" + out.string() + "'");
  EXPECT_EQ(once.status, 0) << once.err;
  for (const char* part : {"done: t 0.2 s", "energy ", "outputs     11\n", "checkpoint  none\n"})
    EXPECT_NE(once.out.find(part), once.out.npos) << part << "\n" << once.out;
}

}  // namespace
}  // namespace brisance
