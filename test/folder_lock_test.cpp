// One run at a time in a folder, whichever command it comes from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/folder_lock.hpp"
#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

using test::Folder;

TEST(FolderLock, LetsOneRunInAtATime) {
  const Folder folder("lock");
  {
    const FolderLock first(folder.path);
    EXPECT_THROW(FolderLock(folder.path), std::runtime_error);
  }
  EXPECT_NO_THROW(FolderLock(folder.path));
}

TEST(FolderLock, IsHeldByVerifyInTheFolderOfEachScene) {
  const Folder folder("verify_lock");
  const FolderLock busy(folder.path / "sod");
  const test::Ran ran =
      test::run_program("verify '" + test::input("sod") + "' --out '" + folder.path.string() + "'");
  EXPECT_EQ(ran.status, 1) << ran.err;
  EXPECT_THAT(ran.out, testing::HasSubstr("is in use by another run"));
  EXPECT_FALSE(std::filesystem::exists(folder.path / "sod/summary.json"));
}

}  // namespace
}  // namespace brisance
