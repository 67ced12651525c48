// What is on the disk, and when: what a crash of the machine must not take. The calls of fsync of
// this process are watched.
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <mutex>

#include "test/program.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::run_into;
using test::shortened;

/// What has been forced to the disk, in this order, while one of these lives.
class Watched {
 public:
  static Watched* now;
  std::vector<fs::path> forced;
  std::vector<std::string> faults;  ///< of checkpoints that came before what they build on
  int checkpoints = 0;

  Watched() { now = this; }
  ~Watched() { now = nullptr; }

  void see(const fs::path& path) {
    if (path.filename().string().find(".h5.tmp") != std::string::npos) see_checkpoint(path);
    forced.push_back(path);
  }
  std::ptrdiff_t times(const fs::path& path) const {
    return std::count(forced.begin(), forced.end(), path);
  }

 private:
  void see_checkpoint(const fs::path& path) {
    ++checkpoints;
    const fs::path run = path.parent_path().parent_path();
    for (const auto& entry : fs::directory_iterator(run)) {
      const std::string kind = entry.path().extension();
      if ((kind == ".vtp" || kind == ".vti") && times(entry.path()) == 0)
        faults.push_back(entry.path().filename());
    }
    // Their names are in the folder, which is forced after them.
    const auto output = [&](const fs::path& one) {
      return one.parent_path() == run && one.has_extension();
    };
    const auto file = std::find_if(forced.rbegin(), forced.rend(), output);
    if (std::find(forced.rbegin(), file, run) == file) faults.push_back("the folder");
  }
};
Watched* Watched::now = nullptr;

void see(int handle) {
  static std::mutex one_by_one;
  const std::lock_guard<std::mutex> lock(one_by_one);
  if (Watched::now) Watched::now->see(fs::read_symlink("/proc/self/fd/" + std::to_string(handle)));
}

}  // namespace
}  // namespace brisance

/// In place of that of the library.
extern "C" int fsync(int handle) {
  brisance::see(handle);
  return static_cast<int>(::syscall(SYS_fsync, handle));
}

namespace brisance {
namespace {

// A run that goes on from a checkpoint does not write again what was written before it.
TEST(Durability, ACheckpointComesAfterTheOutputsBeforeIt) {
  const Folder folder("before");
  Watched watched;
  run_into(folder.path, shortened("bomb_cased", 24, 4));
  EXPECT_GE(watched.checkpoints, 3);
  EXPECT_EQ(watched.faults, std::vector<std::string>());
}

TEST(Durability, AtItsEndARunIsOnTheDiskWithEachOutputOnce) {
  const Folder folder("end");
  List scene = shortened("bomb_cased", 24, 4);
  scene.remove("checkpoint");
  Watched watched;
  run_into(folder.path, scene);
  EXPECT_EQ(watched.checkpoints, 0);
  int files = 0;
  for (const auto& entry : fs::directory_iterator(folder.path)) {
    const fs::path file = entry.path(), before = file.string() + ".tmp";  // as it is written
    if (file.extension() == ".txt" || file.filename() == ".lock") continue;
    EXPECT_EQ(watched.times(file) + watched.times(before), 1) << file;
    ++files;
  }
  EXPECT_GT(files, 10);
  EXPECT_EQ(watched.forced.back(), folder.path);
}

}  // namespace
}  // namespace brisance
