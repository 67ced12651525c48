#include "drivers/progress.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "drivers/files.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

/// Wall time stands still unless a test moves it.
Progress::Clock::time_point wall_time;
Progress::Clock::time_point fake_now() { return wall_time; }
void pass(double seconds) {
  wall_time +=
      std::chrono::duration_cast<Progress::Clock::duration>(std::chrono::duration<double>(seconds));
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class ProgressLine : public testing::Test {
 protected:
  std::ostringstream shown;
  fs::path log = fs::path(testing::TempDir()) / ("brisance_log_" + std::to_string(::getpid()));

  void TearDown() override { fs::remove(log); }

  Progress::Screen file() { return {shown, false, 80, fake_now}; }
  Progress::Screen terminal(int width = 80) { return {shown, true, width, fake_now}; }
  static Progress::Options until(double end) {
    Progress::Options options;
    options.end = end;
    return options;
  }
  /// Equal steps of 1000 particles from `from` to `to` (in steps) of 100, each taking so long.
  static void steps(Progress& progress, int from, int to, double wall_seconds) {
    for (int step = from + 1; step <= to; ++step) {
      pass(wall_seconds);
      progress.update({0.01 * step, 0.01, step, 1000});
    }
  }
};

TEST_F(ProgressLine, TellsShareTimeLeftStepAndSpeed) {
  Progress progress(until(1), terminal());
  steps(progress, 0, 25, 1.0);
  // 25 of 100 steps took 25 s: 75 s are left, at 1000 particles per step and second.
  const auto last = shown.str().substr(shown.str().rfind('\r'));
  EXPECT_EQ(last, "\r 25.0 %  1 min 15 s left  dt 1.00e-02 s  1 k particle-steps/s  step 25\x1b[K");
}

TEST_F(ProgressLine, TheTimeLeftFollowsTheRecentSpeed) {
  Progress progress(until(1), terminal());
  steps(progress, 0, 50, 0.01);
  steps(progress, 50, 75, 10);
  // The memory of 15 s is over by far: 25 steps of 10 s are left, not the 1 min 23 s of the mean.
  EXPECT_NE(shown.str().substr(shown.str().rfind('\r')).find("4 min 10 s left"), std::string::npos)
      << shown.str();
}

TEST_F(ProgressLine, ATerminalHasOneLineThatFitsIt) {
  {
    Progress progress(until(1), terminal(40));
    steps(progress, 0, 100, 1.0);
  }
  std::istringstream lines(shown.str());
  std::string part;
  while (std::getline(lines, part, '\r')) EXPECT_LE(part.substr(0, part.find('\x1b')).size(), 39u);
  EXPECT_EQ(count(shown.str(), "\n"), 1);
  EXPECT_EQ(shown.str().back(), '\n');
}

TEST_F(ProgressLine, ATerminalIsRewrittenFiveTimesASecondAtMost) {
  Progress progress(until(1), terminal());
  steps(progress, 0, 100, 0.02);
  EXPECT_LE(count(shown.str(), "\r"), 10);
  EXPECT_GE(count(shown.str(), "\r"), 9);
}

TEST_F(ProgressLine, AFileGetsALineForEachTenth) {
  Progress progress(until(1), file());
  steps(progress, 0, 95, 0.25);
  EXPECT_EQ(count(shown.str(), "\n"), 10)
      << shown.str();  // 0 % after the first second, then 10 % ...
  EXPECT_EQ(count(shown.str(), "\r"), 0);
  EXPECT_EQ(count(shown.str(), "\x1b"), 0);
}

TEST_F(ProgressLine, AFileGetsALineNowAndThenInASlowRun) {
  Progress progress(until(100), file());
  steps(progress, 0, 100, 1.0);
  // The first step's, then one each 10 s.
  EXPECT_EQ(count(shown.str(), "\n"), 10) << shown.str();
}

TEST_F(ProgressLine, AFileGetsNoLineInAFractionOfASecond) {
  Progress progress(until(1), file());
  steps(progress, 0, 100, 0.009);
  EXPECT_EQ(shown.str(), "");
}

TEST_F(ProgressLine, TheLogHasPlainLinesWhateverTheScreen) {
  for (const bool on_terminal : {true, false}) {
    auto options = until(1);
    options.log = log;
    {
      Progress progress(options, on_terminal ? terminal() : file());
      steps(progress, 0, 100, 0.5);
      progress.finish({1, 0.01, 100, 1000});
    }
    const auto text = read_file(log);
    EXPECT_EQ(count(text, "\r"), 0);
    EXPECT_EQ(count(text, "\x1b"), 0);
    EXPECT_EQ(count(text, "particle-steps/s"), 12) << text;  // 0, 10 ... 100 % and the end
    EXPECT_EQ(count(text, "t 0.5 s"), 1);
  }
}

TEST_F(ProgressLine, QuietIsSilentButLogs) {
  auto options = until(1);
  options.log = log;
  options.quiet = true;
  {
    Progress progress(options, terminal());
    steps(progress, 0, 100, 0.5);
    progress.finish({1, 0.01, 100, 1000});
  }
  EXPECT_EQ(shown.str(), "");
  EXPECT_EQ(count(read_file(log), "done: "), 1);
}

TEST_F(ProgressLine, TheEndDoesNotTearTheRewrittenLine) {
  Progress progress(until(1), terminal());
  steps(progress, 0, 1, 1.0);
  progress.finish({1, 1, 1, 1000});
  EXPECT_NE(shown.str().find("step 1\x1b[K\r\x1b[Kdone: t 1 s"), std::string::npos) << shown.str();
}

TEST_F(ProgressLine, TheEndTellsWhetherAllWasDone) {
  {
    Progress progress(until(1), file());
    steps(progress, 0, 50, 0.001);
    progress.finish({0.5, 0.01, 50, 1000});
  }
  EXPECT_EQ(shown.str(), "stopped at 50.0 %: t 0.5 s, step 50, 0.1 s, 1 M particle-steps/s\n");
  shown.str("");
  Progress progress(until(1), file());
  steps(progress, 0, 100, 0.001);
  progress.finish({1.003, 0.01, 100, 1000});
  EXPECT_EQ(shown.str(), "done: t 1.003 s, step 100, 0.1 s, 1 M particle-steps/s\n");
}

TEST_F(ProgressLine, ARestartGoesOnWithTheLogAndCountsItsOwnSpeed) {
  write_file(log, "before\n");
  auto options = until(1);
  options.log = log;
  options.resumed_at = 0.5;
  {
    Progress progress(options, terminal());
    steps(progress, 50, 75, 1.0);
  }
  EXPECT_EQ(read_file(log).substr(0, 7), "before\n");
  EXPECT_NE(shown.str().find(" 75.0 %  25 s left"), std::string::npos) << shown.str();
}

TEST_F(ProgressLine, ALogThatCannotBeWrittenIsOneLine) {
  auto options = until(1);
  options.log = "/no such folder/log.txt";
  try {
    Progress progress(options, file());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot write '/no such folder/log.txt': "),
              std::string::npos);
  }
}

TEST_F(ProgressLine, AStepThatIsNotShownCostsLessThanAMicrosecond) {
  Progress progress(until(1), Progress::Screen{shown, true});
  const int n = 1000000;
  const auto start = Progress::Clock::now();
  for (int step = 0; step < n; ++step) progress.update({1e-9 * step, 1e-9, step, 1000});
  const std::chrono::duration<double> passed = Progress::Clock::now() - start;
  EXPECT_LT(passed.count() / n, 1e-6);
}

TEST(ReadableDuration, HasTheTwoLargestUnits) {
  EXPECT_EQ(readable_duration(0), "0.0 s");
  EXPECT_EQ(readable_duration(3.21), "3.2 s");
  EXPECT_EQ(readable_duration(9.96), "10 s");
  EXPECT_EQ(readable_duration(59.6), "1 min 00 s");
  EXPECT_EQ(readable_duration(65.2), "1 min 05 s");
  EXPECT_EQ(readable_duration(7300), "2 h 01 min");
  EXPECT_EQ(readable_duration(2 * 86400 + 3 * 3600 + 59), "2 d 03 h");
  EXPECT_EQ(readable_duration(HUGE_VAL), "ages");
}

TEST(ReadableNumber, HasThreeDigitsAndAPrefix) {
  EXPECT_EQ(readable_number(0), "0");
  EXPECT_EQ(readable_number(999), "999");
  EXPECT_EQ(readable_number(999.7), "1 k");
  EXPECT_EQ(readable_number(12345678), "12.3 M");
  EXPECT_EQ(readable_number(2.5e9), "2.5 G");
}

}  // namespace
}  // namespace brisance
