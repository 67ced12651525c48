// Pictures as people ask for them: files of plausible size, and one line for what cannot be meant.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Ran;
using test::run_program;

struct Size {
  int width = 0, height = 0;
};

int number_in(const std::string& bytes, std::size_t at, int count, bool big_end) {
  int value = 0;
  for (int k = 0; k < count; ++k) {
    const std::size_t place = at + static_cast<std::size_t>(big_end ? k : count - 1 - k);
    value = 256 * value + static_cast<unsigned char>(bytes.at(place));
  }
  return value;
}

/// From the head of the file, which is checked.
Size size_of_png(const fs::path& path) {
  const std::string bytes = read_file(path);
  EXPECT_EQ(bytes.substr(1, 3), "PNG") << path;
  return {number_in(bytes, 16, 4, true), number_in(bytes, 20, 4, true)};
}

Size size_of_gif(const fs::path& path) {
  const std::string bytes = read_file(path);
  EXPECT_EQ(bytes.substr(0, 6), "GIF89a") << path;
  return {number_in(bytes, 6, 2, false), number_in(bytes, 8, 2, false)};
}

/// Each frame of a GIF has a graphic control block of four bytes.
int frames_of_gif(const fs::path& path) {
  const std::string bytes = read_file(path), mark("\x21\xF9\x04", 3);
  int count = 0;
  for (auto at = bytes.find(mark); at != bytes.npos; at = bytes.find(mark, at + 1))
    count += bytes.at(at + 7) == '\0';
  return count;
}

/// A tube, a flyer on a wall, the same with fewer outputs, and its start in few columns of few digits.
class Pictures : public testing::Test {
 protected:
  static void SetUpTestSuite() { folder = new Folder("plot"); }
  static void TearDownTestSuite() {
    delete folder;
    folder = nullptr;
  }
  /// With the runs that it names.
  static Ran plot(const std::string& words) {
    const std::string wall = "--set time/end=4e-5 --set output/interval=";
    need("tube", words, "sod", "--set 'grid/cells={50}' --set 'grid/cell size=0.02'");
    need("wall", words, "concrete_impact", wall + "1e-5");
    need("other", words, "concrete_impact", wall + "2e-5");
    need("narrow", words, "concrete_impact",
         "--set time/end=4e-6 --set output/precision=single "
         "--set 'output/columns={velocity, pressure, volume}'");
    return run_program("plot " + words, folder->path);
  }
  static void need(const std::string& name, const std::string& words, const std::string& scene,
                   const std::string& changes) {
    if (words.find(name) == words.npos || fs::exists(at(name))) return;
    const Ran ran = run_program("run '" + (data_folder() / "inputs" / (scene + ".xml")).string() +
                                "' " + changes + " --out '" + at(name).string() + "'");
    ASSERT_EQ(ran.status, 0) << ran.err;
  }
  static fs::path at(const std::string& name) { return folder->path / name; }

  /// Large enough to be looked at, and not empty: a blank picture of that size has some 10 kB.
  static Size expect_picture(const std::string& name) {
    EXPECT_TRUE(fs::exists(at(name))) << name;
    if (!fs::exists(at(name))) return {};
    EXPECT_GT(fs::file_size(at(name)), 15'000u) << name;
    const Size size = size_of_png(at(name));
    EXPECT_GE(std::min(size.width, size.height), 400) << name;
    EXPECT_LE(std::max(size.width, size.height), 2600) << name;
    return size;
  }

  static Folder* folder;
};
Folder* Pictures::folder = nullptr;

TEST_F(Pictures, WithoutOptionsAreAllThatThereAre) {
  const Ran wall = plot("wall tube --out all");
  EXPECT_EQ(wall.status, 0) << wall.err;
  for (const char* name : {"fields", "cracks", "history"})
    expect_picture("all/wall/" + std::string(name) + ".png");
  expect_picture("all/tube/profiles.png");
  EXPECT_EQ(std::count(wall.out.begin(), wall.out.end(), '\n'), 5) << wall.out;
}

TEST_F(Pictures, OfThoseOnlyWhatIsAskedFor) {
  const Ran ran = plot("wall --what history --out h.png");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "h.png\n");
  expect_picture("h.png");
}

TEST_F(Pictures, FieldsAtTimesStandSideBySide) {
  const Ran ran = plot("wall --field Damage --field 'stress xx' --time 0,2e-5 --time 1");
  EXPECT_EQ(ran.status, 0) << ran.err;
  expect_picture("wall/pictures/damage_000000_000002_000004.png");
  expect_picture("wall/pictures/stress_xx_000000_000002_000004.png");
  EXPECT_NE(ran.out.find("wall: nearest to t = 1 s is the output at 40 µs"), ran.out.npos)
      << ran.out;
}

TEST_F(Pictures, RunsStandSideBySide) {
  const Ran ran = plot("wall other --field 'velocity magnitude' --range 0 2000");
  EXPECT_EQ(ran.status, 0) << ran.err;
  expect_picture("wall/pictures/velocity_of_2_runs.png");
  ASSERT_EQ(plot("tube --field density --out one.png").status, 0);
  ASSERT_EQ(plot("tube tube --field density --out two.png").status, 0);
  EXPECT_GT(expect_picture("two.png").width, expect_picture("one.png").width);
}

TEST_F(Pictures, OfAGridAreAskedForByItsName) {
  const Ran ran = plot("wall --field grid/fill --field grid_pressure --out grid");
  EXPECT_EQ(ran.status, 0) << ran.err;
  expect_picture("grid/grid_fill.png");
  expect_picture("grid/grid_pressure.png");
}

TEST_F(Pictures, OfAFieldOnALineAreProfiles) {
  const Ran ran = plot("tube --field pressure --log --time 0,0.1,0.2");
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Size size = expect_picture("tube/pictures/pressure_000000_000005_000010.png");
  EXPECT_GT(size.width, size.height);
}

TEST_F(Pictures, MoveThroughAllOutputs) {
  const Ran ran = plot("wall other --animate --field pressure --out film.gif");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out, "film.gif: 5 outputs, a GIF by python3-pil\n");
  EXPECT_EQ(frames_of_gif(at("film.gif")), 5);
  const Size size = size_of_gif(at("film.gif"));
  EXPECT_GE(std::min(size.width, size.height), 300);
  const Ran line = plot("tube --animate --time 0,0.2 --out line.gif");
  EXPECT_EQ(line.status, 0) << line.err;
  EXPECT_EQ(frames_of_gif(at("line.gif")), 2);
}

TEST_F(Pictures, MoveAsMp4WhereFfmpegIs) {
  const Ran ran = plot("tube --animate --time 0,0.2 --out film.mp4");
  if (std::system("command -v ffmpeg >/dev/null 2>&1") == 0) {
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_GT(fs::file_size(at("film.mp4")), 1000u);
  } else {
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(ran.err,
              "plot: no ffmpeg for MP4; install the Debian package ffmpeg, or name a .gif\n");
  }
}

TEST_F(Pictures, AreDrawnOfARunThatHasNotEnded) {
  ASSERT_EQ(plot("tube --what history").status, 0);
  for (const char* later : {"summary.json", "exact.csv"}) fs::remove(at("tube") / later);
  const Ran ran = plot("tube --out unfinished");
  EXPECT_EQ(ran.status, 0) << ran.err;
  expect_picture("unfinished/profiles.png");
  fs::remove_all(at("tube"));
}

TEST_F(Pictures, WhoseColumnsWereNotWrittenAreLeftOutAndTold) {
  const std::string fields =
      "plot: no picture 'fields': the output has no column 'density', 'energy' (output/columns)\n";
  const Ran usual = plot("narrow --out few");
  EXPECT_EQ(usual.status, 0);
  EXPECT_EQ(usual.out, "few/history.png\n");
  EXPECT_EQ(usual.err,
            fields + "plot: no picture 'cracks': the output has no column 'material', 'damage', "
                     "'decohesion', 'normal x', 'normal y' (output/columns)\n");
  const Ran asked = plot("narrow --what fields");
  EXPECT_EQ(asked.status, 1);
  EXPECT_EQ(asked.err, fields);
  const Ran there = plot("narrow --field pressure --out one.png");
  EXPECT_EQ(there.status, 0) << there.err;
  expect_picture("one.png");
}

TEST_F(Pictures, ThatCannotBeMeantAreToldInOneLine) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"wall --field presure", "no field 'presure' in wall; there are: velocity,"},
      {"wall --field pressure --range 2 1", "MIN must be below MAX"},
      {"wall --field pressure --log --range -1e9 -1e8", "nothing of 'pressure' is above 0"},
      {"wall --log", "name it with --field"},
      {"wall --time soon", "must be seconds"},
      {"wall --out a.png", "ask for one picture"},
      {"wall --animate --out a.png", "for --animate"},
      {"wall --what gauges", "no list 'gauges'"},
      {"wall tube --field pressure", "on a line and in the plane"},
      {"", "DIR"}};
  for (const auto& [words, told] : mistakes) {
    const Ran ran = plot(words);
    EXPECT_EQ(ran.status, 2) << words;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << words << "\n" << ran.err;
    EXPECT_NE(ran.err.find(told), ran.err.npos) << words << "\n" << ran.err;
  }
}

TEST_F(Pictures, ThatCannotBeWrittenAreToldInOneLine) {
  write_file(at("file"), "in the way");
  const Ran ran = plot("wall --field pressure --out file/a.png");
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_NE(ran.err.find("cannot write file/a.png"), ran.err.npos) << ran.err;
}

TEST(PicturesOfPoints, ShowWhatIsThere) {
  const std::string command = "/usr/bin/python3 '" BRISANCE_SOURCE_DIR "/test/plot_check.py' '" +
                              script_file("plot.py").parent_path().string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace brisance
