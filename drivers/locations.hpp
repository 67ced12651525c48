#pragma once
// Where the scenes and scripts that belong to the program lie.
#include <filesystem>

namespace brisance {

/// The folder that holds inputs/ and the plotting script: beside an installed program, else the
/// source tree.
std::filesystem::path data_folder();

/// The script that makes pictures.
std::filesystem::path plot_script();

}  // namespace brisance
