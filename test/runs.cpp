#include "test/runs.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cstdio>

#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "drivers/simulation.hpp"

namespace brisance::test {

namespace fs = std::filesystem;

namespace {

std::string text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", value);
  return digits;
}

}  // namespace

std::string input(const std::string& name) {
  return (data_folder() / "inputs" / (name + ".xml")).string();
}

List shortened(const std::string& name, double steps, int between) {
  const List whole = load_scene({input(name), {}, {}});
  const List* exact_list = find_list(whole, "exact");
  const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
  const double end = std::min(get<double>(whole.sublist("time"), "end"),
                              steps * make_simulation(whole, exact.get())->dt());
  return load_scene({input(name),
                     {},
                     {"time/end=" + text(end), "output/interval=" + text(end / 7),
                      "output/history interval=" + text(end / 15),
                      "checkpoint/steps=" + std::to_string(between), "checkpoint/keep=1000"}});
}

RunResult run_into(const fs::path& folder, const List& scene, Archive* resume) {
  RunOptions options;
  options.folder = folder;
  options.quiet = true;
  options.resume = resume;
  return run(scene, options);
}

std::vector<fs::path> checkpoints_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder / "checkpoints"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace brisance::test
