// What stands around the benchmarks: verdicts on two results; scaling, sizes and roofline of a
// program that only pretends to measure.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "drivers/files.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Folder;
using test::Ran;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Bench : public testing::Test {
 protected:
  Ran bench(const std::string& words) {
    const fs::path out = folder.path / "said", err = folder.path / "complained";
    const std::string command = "cd '" + folder.path.string() + "' && /usr/bin/python3 '" +
                                BRISANCE_SOURCE_DIR + "/perf/bench.py' " + words + " >'" +
                                out.string() + "' 2>'" + err.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
  }

  /// A result with a benchmark "step" of these rates.
  void write(const std::string& name, const std::vector<double>& rates, const char* threads = "2") {
    json document;
    document["context"] = {{"commit", "abc"}, {"threads", threads}};
    for (const double rate : rates)
      document["benchmarks"].push_back({{"name", "step/real_time"},
                                        {"run_name", "step/real_time"},
                                        {"run_type", "iteration"},
                                        {"real_time", 1.0},
                                        {"time_unit", "ms"},
                                        {"particle-steps/s", rate}});
    write_file(folder.path / name, document.dump());
  }
  Ran compared(const std::vector<double>& a, const std::vector<double>& b) {
    write("a.json", a);
    write("b.json", b);
    return bench("--compare a.json b.json");
  }

  Folder folder{"bench"};
};

TEST_F(Bench, CallsFasterOrSlowerOnlyWhatIsBeyondTheNoise) {
  const Ran same = compared({100, 95, 105}, {108, 103, 104});  // 4 %, repetitions 10 % apart
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("1 same within noise"));
  const Ran faster = compared({100, 99, 101}, {108, 107, 109});
  EXPECT_EQ(faster.status, 0);
  EXPECT_THAT(faster.out, HasSubstr("1 faster"));
  EXPECT_THAT(faster.out, HasSubstr("1.080"));
  const Ran slower = compared({100, 99, 101}, {92, 93, 91});
  EXPECT_EQ(slower.status, 1);
  EXPECT_THAT(slower.out, HasSubstr("1 SLOWER"));
}

TEST_F(Bench, TakesNoDifferenceOfAPerCentForOne) {
  EXPECT_THAT(compared({100, 100, 100}, {99, 99, 99}).out, HasSubstr("1 same within noise"));
}

TEST_F(Bench, HasNoVerdictOnTooFewRepetitions) {
  EXPECT_THAT(compared({100, 100}, {50, 50}).out, HasSubstr("1 too few repetitions"));
}

TEST_F(Bench, SaysWhereTwoResultsAreNotAlike) {
  write("a.json", {1, 1, 1});
  write("b.json", {1, 1, 1}, "4");
  EXPECT_THAT(bench("--compare a.json b.json").out, HasSubstr("threads is '2' in A, '4' in B"));
}

TEST_F(Bench, RefusesWhatIsNoResultInOneLine) {
  write("a.json", {1});
  write_file(folder.path / "none.json", "{}");
  for (const char* words : {"--compare a.json none.json", "--compare a.json missing.json",
                            "--scaling --program false"}) {
    const Ran ran = bench(words);
    EXPECT_EQ(ran.status, 1);
    EXPECT_THAT(ran.err.substr(ran.err.rfind("brisance: ")), StartsWith("brisance: "));
  }
  for (const char* words : {"", "--scaling --threads 0"}) {
    const Ran ran = bench(words);
    EXPECT_EQ(ran.status, 2);
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
}

/// A program that writes what it counts, without measuring.
class PretendedBench : public Bench {
 protected:
  PretendedBench() {
    write_file(folder.path / "program", R"(#!/usr/bin/python3
import json, os, sys
def words(option):
    return [word.split("=", 1)[1] for word in sys.argv if word.startswith(option)]
threads = int(os.environ["OMP_NUM_THREADS"])
entries = []
def entry(name, **counts):
    entries.append({"name": name, "run_name": name + "/real_time", "run_type": "iteration", "real_time": 1,
                    "time_unit": "ms", **counts})
entry("machine/triad", **{"GB/s": 10.0})
entry("machine/multiply and add", **{"GFLOP/s": 50.0})
entry("step/500", **{"particle-steps/s": 100.0 * threads**0.5, "GB/s": 2.0, "GFLOP/s": 4.0})
entry("step/uncounted", **{"particle-steps/s": 1.0})
entry("weak/box/%d" % (200 * threads**0.5), **{"particle-steps/s": 100.0 * threads})
entry("kernel/force", **{"particles/s": 50.0, "GB/s": 4.0})
for cells in words("--cells="):
    for n in map(int, cells.split(",")):
        entry("size/balanced/%d" % n, **{"particle-steps/s": 1e7, "particles": 4.0 * n * n, "peak bytes/particle": 200.0})
pattern = words("--benchmark_filter=")[0]
if "^size" in pattern:
    entries = [e for e in entries if e["name"].startswith("size")]
json.dump({"context": {"commit": "abc", "processor": "pretended"}, "benchmarks": entries},
          open(words("--benchmark_out=")[0], "w"))
)");
    fs::permissions(folder.path / "program", fs::perms::owner_all);
  }
};

TEST_F(Bench, HelpNamesWhatThereIs) {
  const Ran ran = bench("--help");
  EXPECT_EQ(ran.status, 0);
  for (const char* what : {"--scaling", "--sizes", "--roofline", "--compare", "--benchmark_filter"})
    EXPECT_THAT(ran.out, HasSubstr(what));
}

// Its rate grows with the square root of the threads, that of the weak box with the threads.
TEST_F(PretendedBench, ScalingIsTableFileAndPicture) {
  const Ran ran = bench("--scaling --threads 4 --program ./program --out scaled");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const std::string csv = read_file(folder.path / "scaled/scaling.csv");
  EXPECT_THAT(csv, HasSubstr("step/500,strong,4,200.0,particle-steps/s,2.0,0.5,"));
  EXPECT_THAT(csv, HasSubstr("weak/box,weak,4,400.0,particle-steps/s,4.0,1.0,"));
  EXPECT_THAT(ran.out, HasSubstr("40 %"));  // of the triad: kernel/force
  EXPECT_TRUE(fs::exists(folder.path / "scaled/scaling.png"));
}

// Two boxes a decade of particles.
TEST_F(PretendedBench, SizesAreTableFileAndPicture) {
  const Ran ran = bench("--sizes --largest 1e5 --threads 2 --program ./program --out sized");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const std::string csv = read_file(folder.path / "sized/sizes.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3) << csv;
  EXPECT_THAT(csv, HasSubstr("size/balanced,10000,2,100.0,0.0,200.0,pretended,abc,"));
  EXPECT_THAT(csv, HasSubstr("size/balanced,31684,2,"));
  EXPECT_THAT(csv, HasSubstr("size/balanced,99856,2,"));
  EXPECT_TRUE(fs::exists(folder.path / "sized/sizes.png"));
}

// Two operations a byte: the roof is 2 x 10 GFLOP/s, the step's 4 are a fifth of it.
TEST_F(PretendedBench, RooflineIsTableFileAndPicture) {
  const Ran ran = bench("--roofline --threads 1 --program ./program --out roofed");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const std::string csv = read_file(folder.path / "roofed/roofline.csv");
  EXPECT_THAT(csv,
              HasSubstr("step/500,1,100.0,particle-steps/s,0.0,2.0,4.0,2.0,20.0,0.2,10.0,50.0,"));
  EXPECT_THAT(csv, Not(HasSubstr("uncounted")));
  EXPECT_THAT(ran.out, HasSubstr("20 %"));
  EXPECT_TRUE(fs::exists(folder.path / "roofed/roofline.png"));
}

TEST_F(PretendedBench, RefusesBoxesWithoutARange) {
  const Ran ran = bench("--sizes --largest 2e4 --program ./program");
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.err, "brisance: --largest must be at least 31623 particles\n");
}

}  // namespace
}  // namespace brisance
