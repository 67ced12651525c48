// A run that is cut off anywhere and goes on is the same run, to the bit.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <map>
#include <sstream>

#include "drivers/checkpoint.hpp"
#include "drivers/commands.hpp"
#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::checkpoints_in;
using test::Folder;
using test::input;
using test::run_into;
using test::shortened;

std::vector<std::string> every_input() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(data_folder() / "inputs"))
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Everything but how long it took, as bytes; numbers that are none are equal to themselves.
std::map<std::string, std::string> bits_of(const fs::path& checkpoint) {
  Checkpoint read = read_checkpoint(checkpoint);
  std::map<std::string, std::string> bits;
  for (const auto& [name, entry] : read.archive.entries()) {
    if (name.rfind("spent/", 0) == 0) continue;
    std::visit(
        [&, key = name](const auto& data) {
          bits[key].assign(reinterpret_cast<const char*>(data.data()),
                           data.size() * sizeof(data[0]));
        },
        entry.data);
  }
  return bits;
}

/// All files of a run that its numbers go into.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string(), kind = entry.path().extension();
    if (kind == ".csv" || kind == ".pvd" || kind == ".vtp" || kind == ".vti")
      files[name] = read_file(entry.path());
  }
  return files;
}

template <class T>
void expect_same(const T& a, const T& b, const std::string& where) {
  for (const auto& [name, bytes] : a) {
    const auto other = b.find(name);
    ASSERT_NE(other, b.end()) << name << " is missing, " << where;
    EXPECT_TRUE(other->second == bytes) << name << " differs, " << where;
  }
  EXPECT_EQ(a.size(), b.size()) << where;
}

/// Runs the scene once, and then again from each of its checkpoints but the last.
void expect_same_from_everywhere(const std::string& name, const List& scene) {
  const Folder folder("restart_" + name);
  run_into(folder.path, scene);
  const auto checkpoints = checkpoints_in(folder.path);
  ASSERT_GE(checkpoints.size(), 2u);
  const auto files = files_of(folder.path);
  const auto bits = bits_of(checkpoints.back());
  const fs::path last = checkpoints.back();
  for (std::size_t k = 0; k + 1 < checkpoints.size(); ++k) {
    Found found = find_checkpoint(checkpoints[k]);
    fs::remove(last);
    run_into(folder.path, scene, &found.checkpoint.archive);
    const std::string where = "from " + checkpoints[k].filename().string();
    ASSERT_TRUE(fs::exists(last)) << where;
    expect_same(bits, bits_of(last), where);
    expect_same(files, files_of(folder.path), where);
  }
}

/// Of all planes after a step, from the history [J/m]; -1: at the end.
double decohesion_work(const fs::path& run, std::int64_t step) {
  std::istringstream lines(read_file(run / "history.csv"));
  std::string line, entry;
  std::getline(lines, line);
  std::istringstream head(line);
  int column = 0;
  while (std::getline(head, entry, ',') && entry != "decohesion") ++column;
  while (std::getline(lines, line)) {
    std::istringstream row(line);
    for (int k = 0; k <= column; ++k) std::getline(row, entry, ',');
    if (std::stoll(line) == step) break;
  }
  return std::stod(entry);
}

class EveryScene : public testing::TestWithParam<std::string> {};

TEST_P(EveryScene, GoesOnAsIfNothingHadHappened) {
  expect_same_from_everywhere(GetParam(), shortened(GetParam(), 24, 10));
}
INSTANTIATE_TEST_SUITE_P(Restart, EveryScene, testing::ValuesIn(every_input()),
                         [](const auto& p) { return p.param; });

// The charge is lit at 0 and burns for longer than this.
TEST(Restart, IsExactWhileABombBurnsSlow) {
  List scene = load_scene(
      {input("bomb_quarter"),
       {},
       {"time/end=1.2e-5", "output/interval=2e-6", "checkpoint/steps=8", "checkpoint/keep=1000"}});
  expect_same_from_everywhere("burning", scene);
}

TEST(Restart, IsExactWhileConcreteComesApart) {
  const List scene = load_scene(
      {input("concrete_impact"),
       {},
       {"time/end=1e-4", "output/interval=2e-5", "output/history interval=1e-6",
        "checkpoint/steps=10", "checkpoint/keep=1000"}});
  const Folder folder("fracture");
  run_into(folder.path, scene);
  const auto checkpoints = checkpoints_in(folder.path);
  ASSERT_GE(checkpoints.size(), 2u);
  const auto step = read_checkpoint(checkpoints[checkpoints.size() - 2]).head.step;
  const double then = decohesion_work(folder.path, step);
  EXPECT_GT(then, 0);
  EXPECT_GT(decohesion_work(folder.path, -1), then);
  expect_same_from_everywhere("fracture", scene);
}

TEST(Restart, IsExactAfterParticlesHaveBeenSplit) {
  const List scene =
      load_scene({input("near_vacuum"), {}, {"checkpoint/steps=60", "checkpoint/keep=1000"}});
  const Folder folder("split");
  run_into(folder.path, scene);
  const auto checkpoints = checkpoints_in(folder.path);
  Checkpoint first = read_checkpoint(checkpoints.front()),
             last = read_checkpoint(checkpoints.back());
  const auto ids = [](Checkpoint& c) {
    return std::get<Archive::Integers>(c.archive.entries().at("state/next id").data).front();
  };
  EXPECT_GT(ids(last), ids(first));
  expect_same_from_everywhere("split", scene);
}

TEST(Restart, IsExactWhileGasSleepsAndWakes) {
  const List scene =
      load_scene({input("sod"),
                  {},
                  {"time/end=0.1", "grid/cells={100}", "grid/cell size=0.01", "scheme/sleep=true",
                   "checkpoint/steps=17", "checkpoint/keep=1000"}});
  const Folder folder("asleep");
  run_into(folder.path, scene);
  const auto asleep = [](const fs::path& file) {
    Checkpoint read = read_checkpoint(file);
    const auto& cells =
        std::get<Archive::Integers>(read.archive.entries().at("state/sleep/cells asleep").data);
    return std::count(cells.begin(), cells.end(), 1);
  };
  const auto checkpoints = checkpoints_in(folder.path);
  EXPECT_GT(asleep(checkpoints.front()), 0);
  EXPECT_LT(asleep(checkpoints.back()), asleep(checkpoints.front()));
  expect_same_from_everywhere("asleep", scene);
}

TEST(Restart, IsNotSeenInARunThatWritesCheckpoints) {
  const Folder with("with"), without("without");
  const List scene = shortened("gauges", 40, 3);
  run_into(with.path, scene);
  List plain = scene;
  plain.remove("checkpoint");
  run_into(without.path, plain);
  expect_same(files_of(without.path), files_of(with.path), "with checkpoints");
  EXPECT_FALSE(fs::exists(without.path / "checkpoints"));
}

}  // namespace
}  // namespace brisance
