// A run that is cut off anywhere and goes on is the same run, to the bit; and what is broken on the
// disk is told, not used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cstring>

#include "drivers/checkpoint.hpp"
#include "drivers/commands.hpp"
#include "drivers/files.hpp"
#include "drivers/folder_lock.hpp"
#include "drivers/hdf5.hpp"
#include "drivers/locations.hpp"
#include "drivers/run.hpp"
#include "drivers/simulation.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using testing::HasSubstr;

std::string input(const std::string& name) {
  return (data_folder() / "inputs" / (name + ".xml")).string();
}

std::vector<std::string> every_input() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(data_folder() / "inputs"))
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", value);
  return digits;
}

/// The scene for about so many steps, with outputs and lines of the history between checkpoints.
List shortened(const std::string& name, double steps, int between) {
  const List whole = load_scene({input(name), {}, {}});
  const List* exact_list = find_list(whole, "exact");
  const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
  const double end = std::min(get<double>(whole.sublist("time"), "end"),
                              steps * make_simulation(whole, exact.get())->dt());
  return load_scene({input(name),
                     {},
                     {"time/end=" + text(end), "output/interval=" + text(end / 7),
                      "output/history interval=" + text(end / 15),
                      "checkpoint/steps=" + std::to_string(between), "checkpoint/keep=1000"}});
}

RunResult run_into(const fs::path& folder, const List& scene, Archive* resume = nullptr) {
  RunOptions options;
  options.folder = folder;
  options.quiet = true;
  options.resume = resume;
  return run(scene, options);
}

std::vector<fs::path> checkpoints_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder / "checkpoints"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
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

TEST(Checkpoints, KeepOnlyTheNewest) {
  const Folder folder("keep");
  List scene = shortened("sod", 40, 3);
  scene.sublist("checkpoint").set("keep", 3);
  run_into(folder.path, scene);
  EXPECT_EQ(checkpoints_in(folder.path).size(), 3u);
}

TEST(Checkpoints, OfAnEarlierRunArePutAside) {
  const Folder folder("aside");
  const List scene = shortened("sod", 20, 5);
  run_into(folder.path, scene);
  const std::size_t number = checkpoints_in(folder.path).size();
  List plain = scene;
  plain.remove("checkpoint");
  run_into(folder.path, plain);
  EXPECT_FALSE(fs::exists(folder.path / "checkpoints"));
  std::size_t aside = 0;
  for (const auto& entry : fs::directory_iterator(folder.path / "checkpoints.before"))
    aside += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(aside, number);
}

TEST(Checkpoints, ComeAtIntervalsOfSimulatedTime) {
  const Folder folder("by_time");
  List scene = shortened("sod", 40, 0);
  const double end = get<double>(scene.sublist("time"), "end");
  scene.sublist("checkpoint").set("simulated time", end / 4);
  run_into(folder.path, scene);
  const auto checkpoints = checkpoints_in(folder.path);
  ASSERT_EQ(checkpoints.size(), 4u);  // and the one at the end
  const double dt = end / 30;
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(read_checkpoint(checkpoints[k]).head.time, (k + 1) * end / 4, dt);
}

// Everything below breaks one run in a folder of its own.
class Broken : public testing::Test {
 protected:
  Folder folder{"broken"};
  List scene = shortened("sod", 40, 8);
  void SetUp() override { run_into(folder.path, scene); }
  fs::path newest() const { return checkpoints_in(folder.path).back(); }
  static void rewrite(const fs::path& file, const std::string& content) {
    write_file(file, content);
  }
  /// The newest is told to have the fault, and the one before is taken.
  void expect_the_one_before(const std::string& fault) const {
    const auto all = checkpoints_in(folder.path);
    const Found found = find_checkpoint(folder.path);
    EXPECT_EQ(found.file, all[all.size() - 2]);
    ASSERT_EQ(found.notes.size(), 2u);
    EXPECT_THAT(found.notes[0], HasSubstr(fault));
    EXPECT_THAT(found.notes[0], HasSubstr(all.back().string()));
    EXPECT_THAT(found.notes[1], HasSubstr("steps are lost"));
  }
};

TEST_F(Broken, AnyFlippedBitIsFound) {
  const std::string good = read_file(newest());
  for (std::size_t at = 3; at < good.size(); at += good.size() / 97) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 1 << at % 8);
    rewrite(newest(), bad);
    EXPECT_THROW(read_checkpoint(newest()), std::runtime_error) << at;
  }
  std::string bad = good;
  bad[good.size() / 2] = static_cast<char>(bad[good.size() / 2] ^ 4);
  rewrite(newest(), bad);
  expect_the_one_before("is damaged");
}

TEST_F(Broken, AFileThatIsCutOffIsFound) {
  const std::string good = read_file(newest());
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{10}, good.size() / 2, good.size() - 1}) {
    rewrite(newest(), good.substr(0, size));
    expect_the_one_before("is cut off");
  }
}

TEST_F(Broken, AFormatOfAnotherVersionIsRefused) {
  const fs::path file = newest();
  {
    std::string content = read_file(file);
    content.resize(content.size() - seal_of("").size());
    rewrite(file, content);
    const hid_t opened = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t format = H5Aopen(opened, "format", H5P_DEFAULT);
    const std::int64_t other = 7;
    ASSERT_GE(H5Awrite(format, H5T_NATIVE_INT64, &other), 0);
    H5Aclose(format);
    H5Fclose(opened);
  }
  const std::string content = read_file(file);
  rewrite(file, content + seal_of(content));
  expect_the_one_before("has the format 7 of another version");
}

TEST_F(Broken, WithoutAGoodOneThereIsNoRestart) {
  for (const auto& file : checkpoints_in(folder.path)) rewrite(file, "no checkpoint");
  EXPECT_THROW(find_checkpoint(folder.path), std::runtime_error);
  fs::remove_all(folder.path / "checkpoints");
  try {
    find_checkpoint(folder.path);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("it holds no checkpoints"));
  }
  EXPECT_THROW(folder_of_run(folder.path / "nowhere"), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder.path / "nowhere"));
}

TEST_F(Broken, HalfWrittenFilesAreNotSeen) {
  rewrite(folder.path / "checkpoints/step_999999999999.h5.tmp", "half");
  EXPECT_TRUE(find_checkpoint(folder.path).notes.empty());
}

TEST_F(Broken, AStateOfAnotherSceneDoesNotFit) {
  Found found = find_checkpoint(folder.path);
  try {
    run_into(folder.path, shortened("acoustic_wave", 10, 3), &found.checkpoint.archive);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the checkpoint"));
  }
}

TEST(FolderLock, LetsOneRunInAtATime) {
  const Folder folder("lock");
  {
    const FolderLock first(folder.path);
    EXPECT_THROW(FolderLock(folder.path), std::runtime_error);
  }
  EXPECT_NO_THROW(FolderLock(folder.path));
}

}  // namespace
}  // namespace brisance
