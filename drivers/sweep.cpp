#include "drivers/sweep.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>

#include "drivers/input.hpp"
#include "drivers/runtime.hpp"
#include "drivers/scene.hpp"
#include "drivers/sweep_axes.hpp"

namespace brisance {
namespace {

constexpr std::size_t longest_name = 200;

/// What the schema says of a parameter that is there.
Described described_at(const List& valid, const std::string& path) {
  const List* here = &valid;
  std::string name = path;
  for (std::size_t slash; (slash = name.find('/')) != name.npos; name.erase(0, slash + 1))
    here = &here->sublist(name.substr(0, slash));
  return described(*here, name);
}

/// "[m]" -> "m"
std::string bare(const std::string& unit) {
  return unit.size() > 2 ? unit.substr(1, unit.size() - 2) : "-";
}

/// Measures by their names, with the units that the scene's schema knows.
std::vector<Quantity> measures_of(const List& valid, const List& list, const char* parameter) {
  const List& known = valid.sublist("checks");
  std::vector<Quantity> quantities;
  for (const auto& name : parts_of(get<std::string>(list, parameter))) {
    if (!find_list(known, name))
      refuse(list, parameter,
             "'" + name + "' is not measured in the scene" + did_you_mean(name, list_names(known)));
    quantities.push_back({name, bare(described(known.sublist(name), "least").unit)});
  }
  return quantities;
}

bool is_number(const std::string& text) {
  double value;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

class Expansion {
 public:
  explicit Expansion(const std::string& file)
      : file_(file),
        document_(read_input(file)),
        sweep_(located([&] { return check(*document_.list, valid_sweep(*document_.list)); })),
        base_((std::filesystem::path(file).parent_path() / get<std::string>(sweep_, "base"))
                  .lexically_normal()
                  .string()) {}

  BatchPlan plan() {
    return located([&] {
      const auto axes = axes_of(sweep_);
      const auto common = changes_of(sweep_);
      plan_.name = std::filesystem::path(file_).stem().string();
      for (const auto& changes : combinations(sweep_, axes)) add(axes, common, changes);
      return plan_;
    });
  }

 private:
  template <class F>
  auto located(const F& f) -> decltype(f()) {
    try {
      return f();
    } catch (const InputError& error) {
      throw document_.locate(error);
    }
  }

  Document base() const {
    try {
      Document scene = read_input(base_);
      if (is_sweep(*scene.list)) throw InputError("", "", "", "is a sweep, not a scene", base_);
      return scene;
    } catch (const InputError& error) {
      if (error.line > 0) throw;
      refuse(sweep_, "base", error.rule + " ('" + base_ + "')");
    }
  }

  void add(const std::vector<Axis>& axes, const std::vector<Change>& common,
           const std::vector<Change>& own) {
    PlannedRun run;
    run.name = name_of(axes, own);
    run.source = file_;
    if (run.name.size() > longest_name)
      refuse(sweep_.sublist("vary"), "", "gives folders of too long names: call its lists shorter");
    for (const auto& other : plan_.runs)
      if (other.name == run.name)
        refuse(sweep_.sublist("vary"), "", "gives two runs of the name '" + run.name + "'");
    std::vector<Change> changes = common;
    changes.insert(changes.end(), own.begin(), own.end());
    Document scene = base();
    try {
      for (const auto& change : changes)
        apply_override(scene, change.option(), valid_scene(*scene.list));
      List complete = complete_scene(*scene.list);
      complete.setName(std::filesystem::path(run.name).string());
      run.input = input_text(complete, "");
      run.threads = paying_threads(complete);
    } catch (const InputError& error) {
      throw told(scene.locate(error), changes, run.name);
    }
    const List valid = valid_scene(*scene.list);
    for (std::size_t k = 0; k < axes.size(); ++k)
      run.varied.push_back(
          {{axes[k].name, bare(described_at(valid, own[k].path).unit)}, own[k].value});
    if (plan_.runs.empty()) choose_results(valid, axes, run);
    plan_.runs.push_back(std::move(run));
  }

  /// An error of a scene, told where the sweep has caused it.
  InputError told(const InputError& error, const std::vector<Change>& changes,
                  const std::string& run) const {
    for (const auto& change : changes) {
      if (error.file != "--set '" + change.option() + "'") continue;
      const bool path = error.value.empty();  // of which no part is known, whatever the value
      const std::string there =
          error.parameter.empty() ? error.list : error.list + "/" + error.parameter;
      const bool axis = change.parameter != "changes";
      return {change.list, path && axis ? "parameter" : change.parameter,
              "'" +
                  (!axis  ? change.option()
                   : path ? change.path
                          : change.value) +
                  "'",
              "'" + there + "' " + error.rule};
    }
    return {error.list,  error.parameter,
            error.value, error.rule + " (in run '" + run + "' of " + file_ + ")",
            error.file,  error.line};
  }

  void choose_results(const List& valid, const std::vector<Axis>& axes, const PlannedRun& run) {
    plan_.results = measures_of(valid, sweep_, "results");
    const List* plot = find_list(sweep_, "plot");
    if (!plot) return;
    Picture picture{plan_.name + ".png", get<std::string>(sweep_, "title"), {}, {}, {}};
    picture.y = measures_of(valid, *plot, "y");
    if (picture.y.empty()) refuse(*plot, "y", "must name a measure");
    const std::string x = get<std::string>(*plot, "x");
    std::vector<std::string> known;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      known.push_back(axes[k].name);
      if (axes[k].name != x) {
        picture.by.push_back(run.varied[k].first);
        continue;
      }
      picture.x = run.varied[k].first;
      for (const auto& change : axes[k].changes)
        if (!is_number(change.value)) refuse(*plot, "x", "must be varied over numbers");
    }
    if (picture.x.name.empty()) refuse(*plot, "x", "is not varied" + did_you_mean(x, known));
    for (const auto& y : picture.y) {
      const auto same = [&](const Quantity& r) { return r.name == y.name; };
      if (std::none_of(plan_.results.begin(), plan_.results.end(), same))
        plan_.results.push_back(y);
    }
    plan_.pictures.push_back(picture);
  }

  std::string file_;
  Document document_;
  List sweep_;
  std::string base_;
  BatchPlan plan_;
};

}  // namespace

BatchPlan expand_sweep(const std::string& file) { return Expansion(file).plan(); }

}  // namespace brisance
