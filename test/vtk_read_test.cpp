#include "drivers/vtk_read.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "drivers/files.hpp"
#include "drivers/vtk.hpp"

namespace brisance::vtk {
namespace {

class VtkRead : public testing::Test {
 protected:
  std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "brisance_vtk_read.vtp";
  void TearDown() override { std::filesystem::remove(path); }
};

TEST_F(VtkRead, GivesBackWhatWasWritten) {
  const std::vector<double> points = {0, 1, 2, 0.1, 1e300, -0.0}, velocity = {1, 2, 3, 4, 5, 6};
  write_vtp(path, points,
            {Column("velocity", 3, velocity), Column("mass", std::vector<double>{1. / 3, 2}),
             Column("id", std::vector<std::int64_t>{7, 1LL << 40}),
             Column("material", std::vector<std::int32_t>{0, 1})});
  const auto columns = read_vtp(path);
  ASSERT_EQ(columns.size(), 5U);
  EXPECT_EQ(columns[0].name, "points");
  EXPECT_EQ(columns[0].values, points);
  EXPECT_EQ(columns[1].name, "velocity");
  EXPECT_EQ(columns[1].components, 3);
  EXPECT_EQ(columns[1].values, velocity);
  EXPECT_EQ(columns[2].values, (std::vector<double>{1. / 3, 2}));
  EXPECT_EQ(columns[3].values, (std::vector<double>{7, 1099511627776.}));
  EXPECT_EQ(columns[4].values, (std::vector<double>{0, 1}));
}

TEST_F(VtkRead, ReadsAFileWithoutParticles) {
  write_vtp(path, {}, {Column("mass", std::vector<double>{})});
  const auto columns = read_vtp(path);
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_TRUE(columns[0].values.empty());
  EXPECT_TRUE(columns[1].values.empty());
}

TEST_F(VtkRead, RefusesAFileThatIsCutOffAnywhere) {
  write_vtp(path, {1, 2, 3}, {Column("mass", std::vector<double>{4})});
  const std::string whole = read_file(path);
  const std::size_t data_end = whole.rfind("\n</AppendedData>");
  for (std::size_t size = 0; size < data_end; size += 7) {
    std::ofstream(path, std::ios::binary | std::ios::trunc).write(whole.data(), size);
    EXPECT_THROW(read_vtp(path), std::runtime_error) << size << " bytes";
  }
}

}  // namespace
}  // namespace brisance::vtk
