#pragma once
// Reads back the files that vtk.hpp writes, and no others.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace brisance::vtk {

struct ReadColumn {
  std::string name;
  int components = 1;
  std::vector<double> values;
};

/// All arrays of a .vtp of ours, the points first, under the name "points". Throws
/// std::runtime_error with one line for a file that is not one.
std::vector<ReadColumn> read_vtp(const std::filesystem::path& path);

/// A .vti of ours: the numbers of cells along each direction (0: flat), and all arrays, cells with x
/// fastest.
struct ReadGrid {
  std::array<int, 3> cells{};
  std::vector<ReadColumn> columns;
};
ReadGrid read_vti(const std::filesystem::path& path);

}  // namespace brisance::vtk
