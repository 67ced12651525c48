#pragma once
// Scenes of inputs/ run for some steps, in this process, into a folder.
#include <filesystem>
#include <string>
#include <vector>

#include "drivers/run.hpp"

namespace brisance::test {

/// The file of a scene in inputs/, by its name.
std::string input(const std::string& name);

/// The scene for about so many steps, with outputs and lines of the history between checkpoints.
List shortened(const std::string& name, double steps, int between);

/// `resume` may be null.
RunResult run_into(const std::filesystem::path& folder, const List& scene,
                   Archive* resume = nullptr);

/// Those of a run, the oldest first.
std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder);

}  // namespace brisance::test
