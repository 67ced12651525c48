// A checkpoint that is broken on the disk is told, not used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <chrono>

#include "drivers/checkpoint.hpp"
#include "drivers/files.hpp"
#include "drivers/hdf5.hpp"
#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::checkpoints_in;
using test::Folder;
using test::run_into;
using test::shortened;
using testing::HasSubstr;

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

// A clock that was set back, or a copy that lost its times.
TEST_F(Broken, TheClockDoesNotTellWhichIsTheNewest) {
  const auto all = checkpoints_in(folder.path);
  auto when = fs::file_time_type::clock::now() + std::chrono::hours(24 * 365);
  for (const auto& file : all) fs::last_write_time(file, when -= std::chrono::hours(24 * 1000));
  const Found found = find_checkpoint(folder.path);
  EXPECT_EQ(found.file, all.back());
  EXPECT_TRUE(found.notes.empty());
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

}  // namespace
}  // namespace brisance
