#pragma once
// One checkpoint as an HDF5 file; CHECKPOINT.md says what is in it. The seal behind HDF5's content
// is both the mark of a complete file and what finds a bit flipped in HDF5's own tables, which have
// no checksums.
#include <filesystem>
#include <string>
#include <string_view>

#include "drivers/archive.hpp"

namespace brisance {

/// What a checkpoint tells of itself.
struct CheckpointHead {
  std::int64_t format = 5;
  std::string program, commit;  ///< that wrote it
  std::string scene, title;
  std::int64_t step = 0, threads = 1;
  double time = 0;    // [s]
  std::string input;  ///< XML of the complete scene
};

/// Writes the file in one piece or not at all, and safe on the disk. Uses up the archive as it
/// goes, and needs little more memory than that. Throws std::runtime_error with one line, also
/// where the disk has not enough room.
void write_checkpoint(const std::filesystem::path& path, const CheckpointHead& head,
                      Archive&& archive);

/// The file that would be written, but for its seal.
std::string bytes_of(const CheckpointHead& head, Archive&& archive);

struct Checkpoint {
  CheckpointHead head;
  Archive archive;
};

/// Throws std::runtime_error that says why the file is none, "is cut off", "is damaged".
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// The same of the bytes of a file, seal included.
Checkpoint checkpoint_of(std::string content);

/// The mark and the checksum that belong behind a content.
std::string seal_of(std::string_view content);

}  // namespace brisance
