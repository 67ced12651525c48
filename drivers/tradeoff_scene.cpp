#include "drivers/tradeoff_scene.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/transfer.hpp"
#include "drivers/commands.hpp"
#include "drivers/input.hpp"
#include "drivers/scene.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

using Names = std::vector<std::string>;

const Names presets = {"paper", "fast", "balanced", "accurate"};

std::string short_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

template <class T>
void append_new(std::vector<T>& all, const T& one) {
  if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string family_of(const List& scene) {
  bool fluid = false, explosive = false, solid = false;
  const List& materials = scene.sublist("materials");
  for (const auto& name : list_names(materials)) {
    const auto law = get<std::string>(materials.sublist(name), "law");
    (law == Jwl::name ? explosive : is_fluid(law) ? fluid : solid) = true;
  }
  std::string kinds;
  for (const auto& [there, kind] :
       {std::pair(fluid, "fluid"), std::pair(explosive, "explosive"), std::pair(solid, "solid")})
    if (there) kinds += (kinds.empty() ? "" : " and ") + std::string(kind);
  return kinds + (dimension(scene) == 1 ? " on a line" : " in the plane");
}

double refined(int cells, double resolution) { return cells == 1 ? 1 : cells * resolution; }

bool whole(double number) {
  return number >= 1 && std::abs(number - std::round(number)) < 1e-9 * number;
}

double magnitude(const Record& record, const std::string& measure) {
  const auto found = record.measures.find(measure);
  return found == record.measures.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

}  // namespace

std::string Setting::name() const {
  return preset + ",x" + short_text(resolution) + ",particles_" + particles + ",CFL_" +
         short_text(cfl) + "," + shape;
}

List valid_tradeoff(const Names& measures) {
  List valid;
  declare_required<Names>(valid, "measures", one_of(measures),
                          "whose mean is the error of a run [-]");
  declare(valid, "against", "exact", one_of({"exact", "finest"}),
          "exact: the measures are errors; finest: their relative distances from those of the "
          "balanced preset at the last of the resolutions are [-]");
  declare(valid, "resolutions", std::vector<double>{0.5, 1, 2}, positive(),
          "cells along each direction, over those of the scene; ascending [-]");
  declare(valid, "particles per cell", std::vector<int>{1, 2, 3}, between(1, 16),
          "of all bodies, beside those of the scene [-]");
  declare(valid, "CFL", std::vector<double>{0.4, 0.8}, above(0) && at_most(0.95),
          "beside that of the preset [-]");
  declare(valid, "shapes", Names{"linear", "quadratic"},
          one_of({"linear", "GIMP", "quadratic", "cubic"}), "beside that of the preset [-]");
  return valid;
}

TradeoffScene::TradeoffScene(const std::string& file)
    : file_(file),
      scene_(std::make_shared<List>(load_scene({file, {}, {}}))),
      family_(family_of(*scene_)) {
  fluid_ = family_.rfind("solid ", 0) != 0;
  if (!measured()) return;
  const auto resolutions = get<std::vector<double>>(tradeoff(), "resolutions");
  if (get<Names>(tradeoff(), "measures").empty())
    refuse(tradeoff(), "measures", "must name a measure");
  if (resolutions.empty() || !std::is_sorted(resolutions.begin(), resolutions.end()))
    refuse(tradeoff(), "resolutions", "must be ascending, and one at least");
  for (const double resolution : resolutions)
    if (!allows(resolution))
      refuse(tradeoff(), "resolutions",
             "must make whole numbers of cells: " + short_text(resolution) + " does not");
}

std::string TradeoffScene::name() const { return scene_->name(); }

bool TradeoffScene::measured() const { return find_list(*scene_, "tradeoff") != nullptr; }

const List& TradeoffScene::tradeoff() const { return scene_->sublist("tradeoff"); }

const List& TradeoffScene::with_preset(const std::string& preset) const {
  auto& scene = with_[preset];
  if (!scene) scene = std::make_shared<List>(load_scene({file_, preset, {}}));
  return *scene;
}

std::string TradeoffScene::own_particles() const {
  std::vector<int> all;
  const List& bodies = scene_->sublist("bodies");
  for (const auto& name : list_names(bodies))
    append_new(all, get<int>(bodies.sublist(name), "particles per cell"));
  return all.size() == 1 ? std::to_string(all[0]) : "own";
}

Setting TradeoffScene::preset_alone(const std::string& preset, double resolution) const {
  const List& scene = with_preset(preset);
  const List& scheme = scene.sublist("scheme");
  return {preset, resolution, own_particles(), get<double>(scene.sublist("time"), "CFL"),
          get<std::string>(fluid_ ? scheme : scheme.sublist("solids"), "shape")};
}

std::vector<Setting> TradeoffScene::settings(bool quick) const {
  auto resolutions = get<std::vector<double>>(tradeoff(), "resolutions");
  if (quick) resolutions.resize(std::min<std::size_t>(2, resolutions.size()));
  std::vector<Setting> all;
  for (const auto& preset : presets) {
    Setting own = preset_alone(preset, 1);
    Names particles = {own.particles};
    std::vector<double> cfls = {own.cfl};
    if (!quick) {
      for (const int n : get<std::vector<int>>(tradeoff(), "particles per cell"))
        append_new(particles, std::to_string(n));
      for (const double cfl : get<std::vector<double>>(tradeoff(), "CFL")) append_new(cfls, cfl);
    }
    for (const double resolution : resolutions) {
      own.resolution = resolution;
      for (const auto& n : particles)
        for (const double cfl : cfls) all.push_back({preset, resolution, n, cfl, own.shape});
      if (quick) continue;
      for (const auto& shape : get<Names>(tradeoff(), "shapes"))
        append_new(all, {preset, resolution, own.particles, own.cfl, shape});
    }
  }
  return all;
}

bool TradeoffScene::allows(double resolution) const {
  for (const int n : get<std::vector<int>>(scene_->sublist("grid"), "cells"))
    if (!whole(refined(n, resolution))) return false;
  return true;
}

Names TradeoffScene::assignments(const Setting& setting) const {
  const List& scene = with_preset(setting.preset);
  const List &grid = scene.sublist("grid"), &bodies = scene.sublist("bodies");
  Names all;
  if (setting.resolution != 1) {
    if (!allows(setting.resolution))
      refuse(grid, "cells", "cannot be made " + short_text(setting.resolution) + " times as many");
    auto cells = get<std::vector<int>>(grid, "cells");
    for (int& n : cells) n = static_cast<int>(std::lround(refined(n, setting.resolution)));
    all.push_back("grid/cells=" + text_of(cells));
    all.push_back("grid/cell size=" + text_of(get<double>(grid, "cell size") / setting.resolution));
  }
  if (setting.particles != "own" && setting.particles != own_particles())
    for (const auto& name : list_names(bodies))
      all.push_back("bodies/" + name + "/particles per cell=" + setting.particles);
  if (setting.cfl != get<double>(scene.sublist("time"), "CFL"))
    all.push_back("time/CFL=" + text_of(setting.cfl));
  const std::string path = fluid_ ? "scheme/" : "scheme/solids/";
  const List& scheme = fluid_ ? scene.sublist("scheme") : scene.sublist("scheme").sublist("solids");
  if (setting.shape == get<std::string>(scheme, "shape")) return all;
  all.push_back(path + "shape=" + setting.shape);
  // What the shape needs, and nothing else.
  const auto quadrature = fluid_ ? get<std::string>(scheme, "quadrature") : "particle";
  if (!broken_rule({setting.shape, "FLIP", quadrature}).empty())
    all.push_back("scheme/quadrature=particle");
  if (!broken_rule({setting.shape, get<std::string>(scheme, "transfer"), "particle"}).empty())
    all.push_back(path + "transfer=FLIP");
  return all;
}

std::string TradeoffScene::command(const Setting& setting) const {
  std::string text = "brisance run " + file_ + " --preset " + setting.preset;
  for (const auto& assignment : assignments(setting)) text += " --set " + quoted(assignment);
  return text;
}

PlannedRun TradeoffScene::planned(const Setting& setting) const {
  PlannedRun run;
  run.name = name() + "/" + setting.name();
  run.source = file_;
  Names changes = assignments(setting);
  changes.insert(changes.end(), {"output/particles=false", "output/grid=false"});
  List scene = load_scene({file_, setting.preset, changes});
  for (const char* part : {"checks", "convergence", "tradeoff"}) scene.remove(part, false);
  scene.setName(setting.name());
  run.input = input_text(scene, "");
  return run;
}

bool TradeoffScene::reference(Setting& setting) const {
  if (get<std::string>(tradeoff(), "against") == "exact") return false;
  setting = preset_alone("balanced", get<std::vector<double>>(tradeoff(), "resolutions").back());
  return true;
}

double TradeoffScene::error(const Record& record, const Record* reference) const {
  double sum = 0, count = 0;
  for (const auto& measure : get<Names>(tradeoff(), "measures")) {
    const double value = magnitude(record, measure);
    if (reference) {
      const double fine = magnitude(*reference, measure);
      sum += std::abs(value - fine) / std::abs(fine);
    } else {
      sum += std::abs(value);
    }
    ++count;
  }
  const double mean = sum / count;
  return std::isfinite(mean) ? mean : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace brisance
