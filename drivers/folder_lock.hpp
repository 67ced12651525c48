#pragma once
// One run at a time in a folder.
#include <filesystem>

namespace brisance {

/// Held until the end of the process at the latest, however it ends: the lock (flock on
/// FOLDER/.lock) is the system's, the file that is left behind means nothing. Makes the folder.
/// Throws std::runtime_error with one line when another run has it. On file systems that know no
/// locks there is none.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int handle_ = -1;
};

}  // namespace brisance
