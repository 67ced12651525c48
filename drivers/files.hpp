#pragma once
// Files that appear under their name complete or not at all.
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace brisance {

/// Files that bear their names but may not be on the disk yet: the end of the program, however
/// sudden, takes none of them, that of the machine could. To force each to the disk by itself takes
/// milliseconds, many at once hardly longer.
class Backlog {
 public:
  /// A file that is complete, from any thread. One that is added again counts once.
  void add(const std::filesystem::path& path) {
    const std::lock_guard<std::mutex> lock(adding_);
    paths_.insert(path);
  }
  bool empty() const { return paths_.empty(); }

  /// Forces all of them to the disk, with their names; nothing is left in it then. A file that is
  /// no longer there is passed over. Throws std::runtime_error with one line that names the file
  /// and the reason.
  void force();

 private:
  std::mutex adding_;
  std::set<std::filesystem::path> paths_;
};

/// Writes into PATH.tmp beside the file meant and renames it at commit(): whoever opens PATH sees
/// the old content or the new one, never a part. The folder must exist. Every failure - no folder,
/// read-only, disk full - throws std::runtime_error with one line that names the file and the
/// reason. Without commit() nothing is left behind.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const void* data, std::size_t bytes);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Bytes written so far.
  std::size_t size() const { return size_; }

  /// Puts the content under its name, and forces it to the disk: at once, or with all that is in a
  /// backlog.
  void commit(Backlog* later = nullptr);

 private:
  void flush();
  void discard();
  [[noreturn]] void fail(int error);

  std::filesystem::path path_, temporary_;
  std::string buffer_;
  std::size_t size_ = 0;
  int handle_ = -1;
};

/// The whole text as one atomic file.
void write_file(const std::filesystem::path& path, std::string_view text, Backlog* later = nullptr);

/// The content of a file; std::runtime_error with one line if it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Throws std::runtime_error with one line unless the disk has room for so much in a folder, and a
/// fifth more for what else is written meanwhile. `what` is to be written, for the message.
void expect_room(const std::filesystem::path& folder, const std::string& what, double bytes);

/// Makes a folder with its parents; it is fine if it exists. Throws one line naming the folder and
/// the reason.
void make_folder(const std::filesystem::path& folder);

}  // namespace brisance
