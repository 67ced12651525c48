#pragma once
// Reads back the particle files that vtk.hpp writes, and no others.
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

}  // namespace brisance::vtk
