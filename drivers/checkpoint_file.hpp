#pragma once
// One checkpoint as an HDF5 file, for example to `h5py.File(name)`:
//   attributes of the root   format (1), program, commit, scene, title; step, time [s], threads
//   input                    the complete scene as XML text
//   material NAME/COLUMN     state of the particles, (components, particles), in their order; also
//                            id, count, floors
//   contents                 paths of all of the following, one on each line
//   everything else          what the parts of a run remember, see each `keep`: numbers in float64
//                            and int64, texts (history.csv so far) as bytes
// All numbers are chunked and carry HDF5's own checksum (fletcher32). Behind HDF5's content stand
// 32 bytes: "brisance complete", padded with zeros to 24, and a checksum (64-bit FNV-1a) of all
// that precedes it. It is both the mark of a complete file and what finds a bit flipped in HDF5's
// own tables, which have no checksums.
#include <filesystem>
#include <string>

#include "drivers/archive.hpp"

namespace brisance {

/// What a checkpoint tells of itself.
struct CheckpointHead {
  std::int64_t format = 1;
  std::string program, commit;  ///< that wrote it
  std::string scene, title;
  std::int64_t step = 0, threads = 1;
  double time = 0;    // [s]
  std::string input;  ///< XML of the complete scene
};

/// Writes the file in one piece or not at all, and safe on the disk. Uses up the archive: needs
/// about twice the memory of what is written. Throws std::runtime_error with one line, also where
/// the disk has not enough room.
void write_checkpoint(const std::filesystem::path& path, const CheckpointHead& head,
                      Archive&& archive);

struct Checkpoint {
  CheckpointHead head;
  Archive archive;
};

/// Throws std::runtime_error that says why the file is none, "is cut off", "is damaged".
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// The mark and the checksum that belong behind a content.
std::string seal_of(const std::string& content);

}  // namespace brisance
