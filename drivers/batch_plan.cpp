#include "drivers/batch_plan.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <filesystem>

#include "drivers/commands.hpp"
#include "drivers/exact.hpp"
#include "drivers/input.hpp"
#include "drivers/runtime.hpp"
#include "drivers/scene.hpp"
#include "drivers/simulation.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_of(const std::vector<std::string>& words) {
  std::vector<std::string> files;
  for (const auto& word : words) {
    if (!fs::is_directory(word)) {
      files.push_back(word);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : fs::directory_iterator(word))
      if (entry.path().extension() == ".xml") inside.push_back(entry.path().string());
    if (inside.empty()) throw InputError("", "", "", "the folder holds no scene (*.xml)", word);
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

BatchPlan plan_of_scene(const std::string& file) {
  const List scene = load_scene({file, {}, {}});
  return {scene.name(),
          {{scene.name(), file, input_text(scene, ""), {}, paying_threads(scene)}},
          {},
          {}};
}

bool same_name(const Quantity& a, const Quantity& b) { return a.name == b.name; }

void append(std::vector<Quantity>& all, const std::vector<Quantity>& more) {
  for (const auto& one : more)
    if (std::none_of(all.begin(), all.end(), [&](const auto& a) { return same_name(a, one); }))
      all.push_back(one);
}

/// The measure as some scene of the batch knows it.
Quantity result_of(const BatchPlan& plan, const std::string& name) {
  std::vector<std::string> known;
  for (const auto& run : plan.runs) {
    const Document scene = parse_input(run.input, run.source);
    const List measures = valid_scene(*scene.list).sublist("checks");
    if (const List* found = find_list(measures, name)) {
      const std::string unit = described(*found, "least").unit;
      return {name, unit.substr(1, unit.size() - 2)};
    }
    if (known.empty()) known = list_names(measures);
  }
  throw InputError("", "", "'" + name + "'",
                   "no scene of the batch measures this" + did_you_mean(name, known), "--result");
}

}  // namespace

BatchPlan plan_batch(const std::vector<std::string>& words,
                     const std::vector<std::string>& results) {
  const auto files = files_of(words);
  BatchPlan plan;
  const fs::path only = fs::absolute(words.front()).lexically_normal();
  plan.name = words.size() > 1      ? "batch"
              : only.has_filename() ? only.stem().string()
                                    : only.parent_path().filename().string();
  for (const auto& file : files) {
    const bool sweep = is_sweep(*read_input(file).list);
    BatchPlan part = sweep ? expand_sweep(file) : plan_of_scene(file);
    for (auto& run : part.runs) {
      if (sweep && files.size() > 1) run.name = part.name + "/" + run.name;
      for (const auto& other : plan.runs)
        if (other.name == run.name)
          throw InputError("", "", "",
                           "gives a run of the name '" + run.name + "', as '" + other.source +
                               "' does: rename one",
                           file);
      plan.runs.push_back(std::move(run));
    }
    append(plan.results, part.results);
    plan.pictures.insert(plan.pictures.end(), part.pictures.begin(), part.pictures.end());
  }
  for (const auto& name : results) append(plan.results, {result_of(plan, name)});
  return plan;
}

void try_scene(const PlannedRun& run) {
  const Document document = parse_input(run.input, run.source);
  const List& scene = *document.list;
  try {
    const List* exact_list = find_list(scene, "exact");
    const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
    make_simulation(scene, exact.get());
  } catch (const InputError& error) {
    throw InputError(error.list, error.parameter, error.value,
                     error.rule + " (in run '" + run.name + "')", run.source);
  }
}

}  // namespace brisance
