#include "drivers/files.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <stdexcept>

namespace brisance {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  fs::path folder = fs::path(testing::TempDir()) / ("brisance_files_" + std::to_string(::getpid()));

  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  std::size_t files_here() const {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }

  template <class Action>
  static std::string error_of(Action action) {
    try {
      action();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
};

/// What a full disk is like: no file of this process may grow beyond `bytes`.
class SmallFilesOnly {
 public:
  explicit SmallFilesOnly(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~SmallFilesOnly() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

/// Root may write everywhere: for a while the process is nobody.
class Powerless {
 public:
  Powerless() : root_(::geteuid() == 0), ok_(!root_ || ::seteuid(65534) == 0) {}
  ~Powerless() {
    if (root_ && ok_ && ::seteuid(0) != 0) ADD_FAILURE() << "cannot become root again";
  }
  bool ok() const { return ok_; }

 private:
  bool root_, ok_;
};

TEST_F(Files, WhatWaitsForTheDiskIsThereAtOnce) {
  Backlog backlog;
  write_file(folder / "a.txt", "old", &backlog);
  write_file(folder / "a.txt", "new", &backlog);
  write_file(folder / "b.txt", "gone soon", &backlog);
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
  EXPECT_FALSE(backlog.empty());
  fs::remove(folder / "b.txt");
  backlog.force();
  EXPECT_TRUE(backlog.empty());
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
}

TEST_F(Files, WhatCannotBeForcedToTheDiskIsSaid) {
  Backlog backlog;
  const fs::path endless = folder / std::string(300, 'x');  // longer than any name may be
  backlog.add(endless);
  EXPECT_EQ(error_of([&] { backlog.force(); }),
            "cannot write '" + endless.string() + "': File name too long");
}

TEST_F(Files, AFileAppearsOnlyWhenCommitted) {
  const auto path = folder / "a.txt";
  AtomicFile file(path);
  file.write("one ");
  file.write("two");
  EXPECT_EQ(file.size(), 7u);
  EXPECT_FALSE(fs::exists(path));
  file.commit();
  EXPECT_EQ(read_file(path), "one two");
  EXPECT_EQ(files_here(), 1u);
}

TEST_F(Files, AFileThatIsNotCommittedLeavesTheOldOneAndNoTrace) {
  const auto path = folder / "a.txt";
  write_file(path, "old");
  {
    AtomicFile file(path);
    file.write("new");
  }
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(files_here(), 1u);
}

TEST_F(Files, PartsSmallAndLargeKeepTheirOrder) {
  std::string expected;
  AtomicFile file(folder / "a.bin");
  // Around the size of the buffer (1 MiB), and zero bytes too.
  for (const std::size_t size :
       {3u, 1u << 20, (1u << 20) + 1, 5u, 0u, 3u << 20, 700000u, 700000u}) {
    const std::string part(size, static_cast<char>(expected.size() % 251));
    file.write(part);
    expected += part;
  }
  file.commit();
  EXPECT_TRUE(read_file(folder / "a.bin") == expected);
}

TEST_F(Files, NoRoomIsOneLineAndLeavesTheOldFile) {
  const auto path = folder / "a.bin";
  write_file(path, "old");
  std::string error;
  {
    const SmallFilesOnly limit(1 << 16);
    error = error_of([&] { write_file(path, std::string(1 << 18, 'x')); });
  }
  EXPECT_EQ(error.find("cannot write '" + path.string() + "': "), 0u) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos);
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(files_here(), 1u);
}

TEST_F(Files, AFullDiskIsNamed) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full to write to";
  // The temporary file is a link to a device on which there is never any room.
  fs::create_symlink("/dev/full", folder / "a.bin.tmp");
  EXPECT_EQ(error_of([&] { write_file(folder / "a.bin", "some"); }),
            "cannot write '" + (folder / "a.bin").string() + "': the disk is full");
  EXPECT_EQ(files_here(), 0u);
}

TEST_F(Files, AReadOnlyFolderIsNamed) {
  const auto path = folder / "a.txt";
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  {
    const Powerless nobody;
    if (!nobody.ok()) GTEST_SKIP() << "runs as root, who may write everywhere";
    EXPECT_NE(error_of([&] { write_file(path, "x"); }).find(path.string() + "': "),
              std::string::npos);
    EXPECT_NE(error_of([&] { make_folder(folder / "b"); }).find("read-only"), std::string::npos);
  }
  fs::permissions(folder, fs::perms::owner_all);
}

TEST_F(Files, AMissingFolderIsNamed) {
  EXPECT_EQ(error_of([&] { write_file(folder / "no" / "a.txt", "x"); }),
            "cannot write '" + (folder / "no" / "a.txt").string() + "': there is no such folder");
}

TEST_F(Files, AFolderInTheWayIsNamedAndNothingLeftBehind) {
  fs::create_directories(folder / "a");
  EXPECT_NE(error_of([&] { write_file(folder / "a", "x"); }).find("a folder of that name"),
            std::string::npos);
  EXPECT_EQ(files_here(), 1u);
}

TEST_F(Files, AFileNameAloneIsWrittenIntoTheCurrentFolder) {
  const auto before = fs::current_path();
  fs::current_path(folder);
  write_file("plain.txt", "x");
  fs::current_path(before);
  EXPECT_EQ(read_file(folder / "plain.txt"), "x");
}

TEST_F(Files, ReadingAMissingFileIsOneLine) {
  const auto error = error_of([&] { read_file(folder / "none"); });
  EXPECT_EQ(error.find("cannot read '" + (folder / "none").string() + "': "), 0u) << error;
}

TEST_F(Files, AFolderIsMadeWithItsParentsAndMayExist) {
  make_folder(folder / "a" / "b");
  make_folder(folder / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder / "a" / "b"));
  write_file(folder / "a" / "c", "x");
  EXPECT_NE(error_of([&] { make_folder(folder / "a" / "c"); }).find("a file of that name"),
            std::string::npos);
  EXPECT_NE(error_of([&] { make_folder(folder / "a" / "c" / "d"); }).find("a file of that name"),
            std::string::npos);
}

}  // namespace
}  // namespace brisance
