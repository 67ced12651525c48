#include "drivers/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "drivers/files.hpp"

namespace brisance {

FolderLock::FolderLock(const std::filesystem::path& folder) {
  make_folder(folder);
  handle_ = ::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (handle_ < 0) return;  // a read-only folder is refused by whoever writes there first
  if (::flock(handle_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(handle_);
  throw std::runtime_error("the folder '" + folder.string() + "' is in use by another run");
}

FolderLock::~FolderLock() {
  if (handle_ >= 0) ::close(handle_);
}

}  // namespace brisance
