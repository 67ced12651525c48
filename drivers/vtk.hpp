#pragma once
// Particles and grids in the XML formats of VTK, as ParaView opens them: data appended raw behind
// the XML header, 64-bit sizes. Host code on the standard library alone. Every file is written by
// temporary file and rename, and forced to the disk at once or with all that is in a backlog.
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "drivers/vtk_column.hpp"

namespace brisance {

class Backlog;

}  // namespace brisance

namespace brisance::vtk {

/// Particles: PolyData of one vertex per point. `points` holds x, y, z of each [m]; every column
/// one row per point. No points at all is a valid file. Throws std::invalid_argument for columns of
/// another length.
void write_vtp(const std::filesystem::path& path, const std::vector<double>& points,
               const std::vector<Column>& columns, Backlog* later = nullptr);
/// The same for points of another type: "Points" in rows of three.
void write_vtp(const std::filesystem::path& path, const Column& points,
               const std::vector<Column>& columns, Backlog* later = nullptr);

/// A box of equal cells; 0 cells along a direction make it flat there, as a 1-D or 2-D grid is.
struct Box {
  std::array<double, 3> origin{};          // low corner [m]
  std::array<double, 3> spacing{1, 1, 1};  // cell size [m]
  std::array<int, 3> cells{1, 1, 1};

  std::size_t count_points() const;
  std::size_t count_cells() const;
};

/// A grid: ImageData with values at the nodes and in the cells, x fastest.
void write_vti(const std::filesystem::path& path, const Box& box,
               const std::vector<Column>& point_columns, const std::vector<Column>& cell_columns,
               Backlog* later = nullptr);

/// The `.pvd` file that gives a time to each file of a series. It is always whole, so that a run
/// that is stopped leaves a readable series.
class Series {
 public:
  struct Entry {
    double time;
    std::string file;  // relative to the folder of the .pvd
  };

  /// A new series; nothing is written before the first addition.
  explicit Series(std::filesystem::path path, Backlog* later = nullptr)
      : path_(std::move(path)), later_(later) {}

  /// Goes on with the series that a run left behind, without its entries at or after `time` [s]; if
  /// there is no file, a new one. Throws std::runtime_error if the file is no series of ours.
  static Series resumed(std::filesystem::path path, double time);

  /// Takes up these entries in place of its own, and writes them.
  void resume(std::vector<Entry> entries);

  /// Adds a file that lies in or below the folder of the .pvd, which is written by the next
  /// write(). Throws std::invalid_argument for times out of order.
  void note(double time, const std::filesystem::path& file);
  /// Adds it and writes the .pvd.
  void add(double time, const std::filesystem::path& file) {
    note(time, file);
    write();
  }
  /// The .pvd; nothing where there is no entry.
  void write() const;

  const std::vector<Entry>& entries() const { return entries_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Backlog* later_;
  std::vector<Entry> entries_;
};

}  // namespace brisance::vtk
