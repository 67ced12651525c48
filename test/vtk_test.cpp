#include "drivers/vtk.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <map>
#include <stdexcept>

#include "drivers/files.hpp"

namespace brisance::vtk {
namespace {

namespace fs = std::filesystem;

/// A file of ours taken apart into its appended arrays; nothing may lie between or behind them.
class Parsed {
 public:
  explicit Parsed(const fs::path& path) : text_(read_file(path)) {
    const std::string mark = "<AppendedData encoding=\"raw\">\n_";
    const auto data = text_.find(mark) + mark.size();
    header_ = text_.substr(0, data - mark.size());
    std::size_t end = 0;
    for (auto at = header_.find("<DataArray "); at != std::string::npos;
         at = header_.find("<DataArray ", at + 1)) {
      const auto element = header_.substr(at, header_.find('>', at) - at);
      EXPECT_EQ(value_in(element, "format"), "appended");
      EXPECT_EQ(std::stoull(value_in(element, "offset")), end)
          << "an array does not follow the last";
      std::uint64_t size = 0;
      std::memcpy(&size, text_.data() + data + end, sizeof size);
      arrays_[value_in(element, "Name")] = {value_in(element, "type"),
                                            std::stoi(value_in(element, "NumberOfComponents")),
                                            text_.substr(data + end + sizeof size, size)};
      end += sizeof size + size;
    }
    EXPECT_EQ(text_.substr(data + end), "\n</AppendedData>\n</VTKFile>\n");
  }

  /// The value of an attribute where it first occurs.
  std::string header(const std::string& name) const { return value_in(header_, name); }
  bool has(const std::string& text) const { return header_.find(text) != std::string::npos; }
  std::size_t arrays() const { return arrays_.size(); }
  int components(const std::string& name) const { return arrays_.at(name).components; }
  std::string type(const std::string& name) const { return arrays_.at(name).type; }

  template <class T>
  std::vector<T> numbers(const std::string& name) const {
    const auto& bytes = arrays_.at(name).bytes;
    std::vector<T> result(bytes.size() / sizeof(T));
    std::copy_n(bytes.data(), bytes.size(), reinterpret_cast<char*>(result.data()));
    return result;
  }

 private:
  struct Appended {
    std::string type;
    int components = 0;
    std::string bytes;
  };

  static std::string value_in(const std::string& text, const std::string& name) {
    const auto at = text.find(' ' + name + "=\"");
    if (at == std::string::npos) return "";
    const auto begin = at + name.size() + 3;
    return text.substr(begin, text.find('"', begin) - begin);
  }

  std::string text_, header_;
  std::map<std::string, Appended> arrays_;
};

class Vtk : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) / ("brisance_vtk_" + std::to_string(::getpid()));

  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  /// A frame of n particles in a row, x = 0, 1, ..., with density = 10 + x.
  fs::path frame(const std::string& name, int n) const {
    std::vector<double> points, density, velocity;
    std::vector<std::int64_t> id;
    for (int i = 0; i < n; ++i) {
      points.insert(points.end(), {1.0 * i, 0.5, 0.0});
      density.push_back(10.0 + i);
      velocity.insert(velocity.end(), {10.0 + i, 0.0, 0.0});
      id.push_back(i);
    }
    write_vtp(folder / name, points, {{"density", density}, {"id", id}, {"velocity", 3, velocity}});
    return folder / name;
  }
  std::string series_text() const { return read_file(folder / "particles.pvd"); }
};

TEST_F(Vtk, ParticlesReadBackBitForBit) {
  const std::vector<double> points = {0.1, 0, 0, 1.0 / 3, -1e-300, 0};
  const std::vector<double> velocity = {1, 2, 3, 4, 5, 1e300};
  const std::vector<std::int64_t> id = {7, std::int64_t{1} << 60};
  const std::vector<float> damage = {0.25f, 1.0f / 3};
  const std::vector<std::int32_t> material = {-1, 2};
  const std::vector<std::uint8_t> flag = {0, 255};
  write_vtp(folder / "p.vtp", points,
            {{"velocity", 3, velocity},
             {"id", id},
             {"damage", damage},
             {"material", material},
             {"flag", flag}});

  const Parsed file(folder / "p.vtp");
  EXPECT_EQ(file.header("type"), "PolyData");
  EXPECT_EQ(file.header("header_type"), "UInt64");
  EXPECT_EQ(file.header("byte_order"), "LittleEndian");
  EXPECT_EQ(file.header("NumberOfPoints"), "2");
  EXPECT_EQ(file.header("NumberOfVerts"), "2");
  EXPECT_EQ(file.arrays(), 8u);
  EXPECT_EQ(file.numbers<double>("Points"), points);
  EXPECT_EQ(file.components("Points"), 3);
  EXPECT_EQ(file.numbers<double>("velocity"), velocity);
  EXPECT_EQ(file.components("velocity"), 3);
  EXPECT_EQ(file.numbers<std::int64_t>("id"), id);
  EXPECT_EQ(file.numbers<float>("damage"), damage);
  EXPECT_EQ(file.numbers<std::int32_t>("material"), material);
  EXPECT_EQ(file.numbers<std::uint8_t>("flag"), flag);
  EXPECT_EQ(file.type("velocity"), "Float64");
  EXPECT_EQ(file.type("id"), "Int64");
  EXPECT_EQ(file.type("damage"), "Float32");
  EXPECT_EQ(file.type("material"), "Int32");
  EXPECT_EQ(file.type("flag"), "UInt8");
}

TEST_F(Vtk, EachParticleIsAVertex) {
  const Parsed file(frame("p.vtp", 4));
  EXPECT_EQ(file.numbers<std::int32_t>("connectivity"), (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(file.numbers<std::int32_t>("offsets"), (std::vector<std::int32_t>{1, 2, 3, 4}));
}

TEST_F(Vtk, NoParticlesAreAFileToo) {
  const Parsed file(frame("p.vtp", 0));
  EXPECT_EQ(file.header("NumberOfPoints"), "0");
  EXPECT_EQ(file.arrays(), 6u);
  EXPECT_TRUE(file.numbers<double>("density").empty());
}

TEST_F(Vtk, TheFirstNumberAndTheFirstVectorAreWhatAViewerShows) {
  EXPECT_TRUE(
      Parsed(frame("p.vtp", 1)).has("<PointData Scalars=\"density\" Vectors=\"velocity\">"));
}

TEST_F(Vtk, NamesMayHoldWhatXmlReserves) {
  write_vtp(folder / "p.vtp", {0, 0, 0}, {{"a<b & \"c\">", std::vector<double>{1}}});
  EXPECT_TRUE(Parsed(folder / "p.vtp").has("Name=\"a&lt;b &amp; &quot;c&quot;&gt;\""));
}

TEST_F(Vtk, ColumnsOfAnotherLengthAreRefused) {
  const std::vector<double> two = {1, 2};
  EXPECT_THROW(write_vtp(folder / "p.vtp", {0, 0, 0}, {{"a", two}}), std::invalid_argument);
  EXPECT_THROW(write_vtp(folder / "p.vtp", two, {}), std::invalid_argument);
  EXPECT_THROW(Column("a", 3, two), std::invalid_argument);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Vtk, AGridHasItsPlaceAndItsValues) {
  const Box box{{-1, 0.1, 0}, {0.5, 0.25, 1}, {2, 3, 0}};
  EXPECT_EQ(box.count_points(), 12u);
  EXPECT_EQ(box.count_cells(), 6u);
  std::vector<double> mass(12), density(6);
  for (std::size_t i = 0; i < mass.size(); ++i) mass[i] = 0.1 * static_cast<double>(i);
  write_vti(folder / "g.vti", box, {{"mass", mass}}, {{"density", density}});

  const Parsed file(folder / "g.vti");
  EXPECT_EQ(file.header("type"), "ImageData");
  EXPECT_EQ(file.header("WholeExtent"), "0 2 0 3 0 0");
  EXPECT_EQ(file.header("Extent"), "0 2 0 3 0 0");
  EXPECT_EQ(file.header("Origin"), "-1 0.1 0");
  EXPECT_EQ(file.header("Spacing"), "0.5 0.25 1");
  EXPECT_EQ(file.numbers<double>("mass"), mass);
  EXPECT_EQ(file.numbers<double>("density"), density);
  EXPECT_THROW(write_vti(folder / "g.vti", box, {{"mass", density}}, {}), std::invalid_argument);
}

TEST_F(Vtk, ASeriesNamesItsFilesRelativelyAtExactTimes) {
  Series series(folder / "particles.pvd");
  EXPECT_FALSE(fs::exists(series.path()));
  series.add(0, frame("particles_000000.vtp", 1));
  series.add(0.1 + 0.2, frame("particles_000001.vtp", 2));
  EXPECT_NE(
      series_text().find("timestep=\"0\" group=\"\" part=\"0\" file=\"particles_000000.vtp\""),
      std::string::npos);
  EXPECT_NE(series_text().find("timestep=\"0.30000000000000004\""), std::string::npos);
  EXPECT_NE(series_text().find("</VTKFile>"), std::string::npos);
  EXPECT_EQ(Series::resumed(folder / "particles.pvd", 1).entries()[1].time, 0.1 + 0.2);
}

TEST_F(Vtk, ARestartedSeriesLosesWhatComesAfter) {
  Series before(folder / "particles.pvd");
  for (int i = 0; i < 4; ++i) before.add(0.1 * i, folder / (std::to_string(i) + " & more.vtp"));
  auto series = Series::resumed(folder / "particles.pvd", 0.1 * 2);
  ASSERT_EQ(series.entries().size(), 2u);
  series.add(0.25, folder / "new.vtp");
  const auto again = Series::resumed(folder / "particles.pvd", 1);
  ASSERT_EQ(again.entries().size(), 3u);
  EXPECT_EQ(again.entries()[1].file, "1 & more.vtp");
  EXPECT_EQ(again.entries()[2].file, "new.vtp");
  EXPECT_EQ(again.entries()[2].time, 0.25);
}

TEST_F(Vtk, ARestartWithoutASeriesBeginsOne) {
  EXPECT_TRUE(Series::resumed(folder / "particles.pvd", 1).entries().empty());
}

TEST_F(Vtk, ATornSeriesIsRefusedInOneLine) {
  Series series(folder / "particles.pvd");
  series.add(0, folder / "a.vtp");
  for (const auto& broken : {series_text().substr(0, 120), std::string(), std::string("<xml/>")}) {
    write_file(folder / "particles.pvd", broken);
    try {
      Series::resumed(folder / "particles.pvd", 1);
      FAIL() << broken;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()),
                "'" + (folder / "particles.pvd").string() + "' is no time series or is cut off");
    }
  }
}

TEST_F(Vtk, TheLastTimeMayBeWrittenAgainButNotAnEarlierOne) {
  Series series(folder / "particles.pvd");
  series.add(0, folder / "a.vtp");
  series.add(1, folder / "b.vtp");
  series.add(1, folder / "c.vtp");
  ASSERT_EQ(series.entries().size(), 2u);
  EXPECT_EQ(series.entries()[1].file, "c.vtp");
  EXPECT_THROW(series.add(0.5, folder / "d.vtp"), std::invalid_argument);
  EXPECT_THROW(series.add(2, folder.parent_path() / "d.vtp"), std::invalid_argument);
}

TEST_F(Vtk, ASeriesInTheCurrentFolderWorks) {
  const auto before = fs::current_path();
  fs::current_path(folder);
  Series series("particles.pvd");
  series.add(0, "./a.vtp");
  fs::current_path(before);
  EXPECT_NE(series_text().find("file=\"a.vtp\""), std::string::npos);
}

/// Opens what we write in ParaView itself, if it is there.
TEST_F(Vtk, SlowParaViewReadsParticlesGridsAndTimes) {
  if (std::system(
          "for p in pvbatch xvfb-run xauth; do command -v $p || exit 1; done > /dev/null")) {
    GTEST_SKIP() << "needs pvbatch and xvfb-run (Debian: paraview, python3-paraview, xvfb, xauth)";
  }
  Series particles(folder / "particles.pvd"), grids(folder / "grid.pvd");
  const std::vector<int> counts = {3, 0, 5};
  for (int i = 0; i < 3; ++i) {
    const auto number = std::to_string(i);
    particles.add(0.1 * i, frame("particles_" + number + ".vtp", counts[i]));
    const Box box{{1, 2, 0}, {0.5, 0.5, 0.5}, {2, 3, 0}};
    write_vti(folder / ("grid_" + number + ".vti"), box,
              {{"mass", std::vector<double>(box.count_points(), 4)}},
              {{"density", std::vector<double>(box.count_cells(), 5)}});
    grids.add(0.1 * i, folder / ("grid_" + number + ".vti"));
  }
  const auto command = "xvfb-run -a pvbatch '" BRISANCE_SOURCE_DIR "/test/paraview_check.py' '" +
                       folder.string() + "' > '" + (folder / "seen.txt").string() + "' 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << read_file(folder / "seen.txt");

  const auto seen = read_file(folder / "seen.txt");
  const auto expect_line = [&](const std::string& line) {
    EXPECT_NE(seen.find(line + "\n"), std::string::npos) << line << " is missing in\n" << seen;
  };
  expect_line("particles.pvd time 0.0 points 3 cells 3");
  expect_line("particles.pvd time 0.1 points 0 cells 0");
  expect_line("particles.pvd time 0.2 points 5 cells 5");
  expect_line("  bounds 0.0 4.0 0.5 0.5 0.0 0.0");
  expect_line("  point density 10.0 14.0");
  expect_line("  point id 0.0 4.0");
  expect_line("  point velocity 10.0 14.0 0.0 0.0 0.0 0.0");
  expect_line("grid.pvd time 0.2 points 12 cells 6");
  expect_line("  bounds 1.0 2.0 2.0 3.5 0.0 0.0");
  expect_line("  point mass 4.0 4.0");
  expect_line("  cell density 5.0 5.0");
  EXPECT_GT(fs::file_size(folder / "particles.png"), 1000u);
  EXPECT_GT(fs::file_size(folder / "grid.png"), 1000u);
}

}  // namespace
}  // namespace brisance::vtk
