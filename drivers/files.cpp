#include "drivers/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <future>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace brisance {
namespace {

constexpr std::size_t buffer_size = 1 << 20;  // [B]

std::string reason(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "the disk is full";
    case EROFS:
    case EACCES:
    case EPERM:
      return "the folder is read-only";
    case ENOENT:
    case ENOTDIR:
      return "there is no such folder";
    case EISDIR:
      return "there is a folder of that name";
    default:
      return std::generic_category().message(error);
  }
}

bool is_unknown(int error) { return error == EINVAL || error == ENOTSUP || error == ENOSYS; }

/// Some file systems know no fsync and say so; there is nothing more to be done on them.
bool sync(int handle) { return ::fsync(handle) == 0 || is_unknown(errno); }

/// The data alone; where that is not known they wait for fsync.
bool write_back(int handle, unsigned how) {
  return ::sync_file_range(handle, 0, 0, how) == 0 || is_unknown(errno);
}

[[noreturn]] void cannot_write(const std::filesystem::path& path, int error) {
  throw std::runtime_error("cannot write '" + path.string() + "': " + reason(error));
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// What was written under the names in a folder is safe only when the folder is on the disk, too.
void sync_folder(const std::filesystem::path& folder) {
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  sync(opened);
  ::close(opened);
}

/// f(handle) says whether it is done with each file.
template <class Paths, class F>
void each_open(const Paths& paths, const F& f) {
  for (const auto& path : paths) {
    const int handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0 && errno == ENOENT) continue;
    if (handle < 0) cannot_write(path, errno);
    const int error = f(handle) ? 0 : errno;
    ::close(handle);
    if (error != 0) cannot_write(path, error);
  }
}

}  // namespace

// The disk is given everything before anything is waited for. Once all data are there, the first
// fsync writes the journal for all files together; the others wait for little, and at the same
// time.
void Backlog::force() {
  each_open(paths_, [](int handle) { return write_back(handle, SYNC_FILE_RANGE_WRITE); });
  each_open(paths_, [](int handle) {
    return write_back(
        handle, SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER);
  });
  constexpr std::size_t at_once = 8;
  std::vector<std::filesystem::path> shares[at_once];
  std::size_t next = 0;
  for (const auto& path : paths_) shares[next++ % at_once].push_back(path);
  std::vector<std::future<void>> waiting;
  for (const auto& share : shares)
    if (!share.empty())
      waiting.push_back(std::async(std::launch::async, [&share] { each_open(share, sync); }));
  for (auto& one : waiting) one.get();
  std::set<std::filesystem::path> folders;
  for (const auto& path : paths_) folders.insert(folder_of(path));
  for (const auto& folder : folders) sync_folder(folder);
  paths_.clear();
}

AtomicFile::AtomicFile(const std::filesystem::path& path) : path_(path), temporary_(path) {
  temporary_ += ".tmp";
  handle_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (handle_ < 0) fail(errno);
  buffer_.reserve(buffer_size);
}

AtomicFile::~AtomicFile() {
  if (handle_ >= 0) discard();
}

// Behind a file that grows large its pages are used again, once they are on the disk: fresh ones
// take the system longer to get than to fill, and nobody reads so soon what has been written.
void AtomicFile::write(const void* data, std::size_t bytes) {
  size_ += bytes;
  for (const char* from = static_cast<const char*>(data); bytes > 0;) {
    const std::size_t some = std::min(bytes, buffer_size - buffer_.size());
    buffer_.append(from, some);
    from += some;
    bytes -= some;
    if (buffer_.size() < buffer_size) return;
    flush();
    ::posix_fadvise(handle_, 0, 0, POSIX_FADV_DONTNEED);
  }
}

void AtomicFile::commit(Backlog* later) {
  flush();
  if (!later && !sync(handle_)) fail(errno);
  const int closed = ::close(handle_);
  handle_ = -1;
  if (closed != 0 || std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
  if (later)
    later->add(path_);
  else
    sync_folder(folder_of(path_));
}

void AtomicFile::flush() {
  for (std::string_view left = buffer_; !left.empty();) {
    const ssize_t written = ::write(handle_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void AtomicFile::discard() {
  if (handle_ >= 0) ::close(handle_);
  handle_ = -1;
  ::unlink(temporary_.c_str());
}

void AtomicFile::fail(int error) {
  discard();
  cannot_write(path_, error);
}

void write_file(const std::filesystem::path& path, std::string_view text, Backlog* later) {
  AtomicFile file(path);
  file.write(text);
  file.commit(later);
}

std::string read_file(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error("cannot read '" + path.string() + "': " + why);
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) refuse(std::generic_category().message(errno));
  std::string text;
  char part[1 << 16];
  while (const std::size_t got = std::fread(part, 1, sizeof part, file.get())) {
    text.append(part, got);
  }
  if (std::ferror(file.get())) refuse(std::generic_category().message(errno));
  return text;
}

void expect_room(const std::filesystem::path& folder, const std::string& what, double bytes) {
  std::error_code unknown;
  const auto space = std::filesystem::space(folder, unknown);
  const double needed = 1.2 * bytes;
  if (unknown || static_cast<double>(space.available) >= needed) return;
  char text[100];
  std::snprintf(text, sizeof text, ": it takes %.0f MB and the disk has %.0f MB left",
                std::ceil(needed / 1e6), std::floor(static_cast<double>(space.available) / 1e6));
  throw std::runtime_error("cannot write " + what + text);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder, error)) {
    error = std::make_error_code(std::errc::file_exists);
  }
  if (!error) return;
  const bool is_file = error == std::errc::file_exists || error == std::errc::not_a_directory;
  throw std::runtime_error("cannot make the folder '" + folder.string() + "': " +
                           (is_file ? "there is a file of that name" : reason(error.value())));
}

}  // namespace brisance
