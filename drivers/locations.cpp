#include "drivers/locations.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace brisance {
namespace {

namespace fs = std::filesystem;

fs::path first_with(const std::string& file, const std::vector<fs::path>& folders) {
  for (const auto& folder : folders)
    if (fs::exists(folder / file)) return folder / file;
  throw std::runtime_error("'" + file + "' of the program is missing; install or build it again");
}

fs::path installed() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  return program.parent_path() / BRISANCE_DATA_DIR;
}

}  // namespace

fs::path data_folder() {
  return first_with("inputs", {installed(), BRISANCE_SOURCE_DIR}).parent_path();
}

fs::path script_file(const std::string& name) {
  return first_with(name, {installed(), fs::path(BRISANCE_SOURCE_DIR) / "drivers"});
}

fs::path program_file() { return fs::read_symlink("/proc/self/exe"); }

}  // namespace brisance
