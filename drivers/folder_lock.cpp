#include "drivers/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "drivers/files.hpp"

namespace brisance {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  make_folder(folder);
  handle_ = ::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (handle_ < 0) return;  // a read-only folder is refused by whoever writes there first
  // Whoever asks is_in_use() holds the lock for a moment.
  for (int k = 0; k < 5; ++k) {
    if (::flock(handle_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ::close(handle_);
  throw std::runtime_error("the folder '" + folder.string() + "' is in use by another run");
}

FolderLock::~FolderLock() {
  if (handle_ >= 0) ::close(handle_);
}

std::optional<bool> is_in_use(const std::filesystem::path& folder) {
  const int handle = ::open((folder / ".lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return {};
  std::optional<bool> answer;
  if (::flock(handle, LOCK_SH | LOCK_NB) == 0)
    answer = false;
  else if (errno == EWOULDBLOCK)
    answer = true;
  ::close(handle);
  return answer;
}

}  // namespace brisance
