#pragma once
// Where the scenes and scripts that belong to the program lie.
#include <filesystem>
#include <string>

namespace brisance {

/// The folder that holds inputs/ and the scripts: beside an installed program, else the
/// source tree.
std::filesystem::path data_folder();

/// One of the scripts that make pictures.
std::filesystem::path script_file(const std::string& name);

/// The running program itself.
std::filesystem::path program_file();

}  // namespace brisance
