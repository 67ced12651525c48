#pragma once
// One run at a time in a folder.
#include <filesystem>
#include <optional>

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

/// Whether a run has the folder now; nothing where that cannot be told: no lock was ever made
/// there, or the file system knows none.
std::optional<bool> is_in_use(const std::filesystem::path& folder);

}  // namespace brisance
