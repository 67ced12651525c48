#include "drivers/tradeoff_choice.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace brisance {
namespace {

/// Runs that are cheaper tell of the program's start more than of steps. [s]
constexpr double least_cost = 0.1;
/// Costs within this factor are alike: measured twice, those of tubes differed by up to so much.
constexpr double alike = 1.5;

/// A number above 0 and what stands behind it.
std::pair<double, std::string> number_with_unit(const std::string& text, const std::string& option,
                                                const std::string& rule) {
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || !(value > 0) || !std::isfinite(value))
    throw InputError("", "", "", "'" + one_line(text) + "' " + rule, option);
  return {value, std::string(end, last)};
}

double with_unit(const std::string& text, const std::string& option, const std::string& rule,
                 const std::vector<std::pair<std::string, double>>& units) {
  const auto [value, unit] = number_with_unit(text, option, rule);
  for (const auto& [name, factor] : units)
    if (unit == name) return value * factor;
  throw InputError("", "", "", "'" + one_line(text) + "' " + rule, option);
}

std::optional<Choice> best(std::vector<Choice> all, const Wish& wish) {
  if (all.empty()) return {};
  const auto cheaper = [](const Choice& a, const Choice& b) { return a.cost < b.cost; };
  const auto better = [](const Choice& a, const Choice& b) { return a.error < b.error; };
  const auto first = [&](const auto& less) {
    return *std::min_element(all.begin(), all.end(), less);
  };
  Choice nearest = wish.error ? first(better) : first(cheaper);
  nearest.fulfils = false;
  const auto too_much = [&](const Choice& c) {
    return wish.error ? c.error > *wish.error : c.cost > *wish.budget;
  };
  all.erase(std::remove_if(all.begin(), all.end(), too_much), all.end());
  if (all.empty()) return nearest;
  return wish.error ? first(cheaper) : first(better);
}

}  // namespace

double error_from(const std::string& text) {
  return with_unit(text, "--target-error", "must be a number above 0, or one of per cent: 2%",
                   {{"", 1}, {"%", 0.01}});
}

double budget_from(const std::string& text) {
  return with_unit(text, "--budget", "must be a time above 0: 60, 60s, 5min, 2h",
                   {{"", 1}, {"s", 1}, {"min", 60}, {"h", 3600}});
}

std::optional<Choice> choose(const TradeoffPoints& points, const Wish& wish) {
  std::vector<Choice> all;
  for (const auto& point : points)
    if (point.valid()) all.push_back({point.setting, point.error, point.error, point.cost});
  return best(std::move(all), wish);
}

FamilyFit::FamilyFit(const TradeoffPoints& points, const std::string& family,
                     const TradeoffScene& scene) {
  for (const auto& point : points) {
    const bool known = std::find(scenes_.begin(), scenes_.end(), point.scene) != scenes_.end();
    if (point.family == family && !known) scenes_.push_back(point.scene);
  }
  for (const auto& point : points) {
    if (point.family != family || !point.valid() || !scene.allows(point.setting.resolution))
      continue;
    auto entry = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& e) { return e.setting == point.setting; });
    if (entry == entries_.end())
      entry = entries_.insert(entry, {point.setting, point.preset_alone, {}, {}});
    entry->errors.push_back(point.error);
    entry->costs.push_back(point.cost);
  }
  const auto partial = [&](const Entry& e) { return e.errors.size() < scenes_.size(); };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), partial), entries_.end());
  const auto sum = [](const Entry& e) {
    return std::accumulate(e.costs.begin(), e.costs.end(), 0.0);
  };
  std::stable_sort(entries_.begin(), entries_.end(),
                   [&](const Entry& a, const Entry& b) { return sum(a) < sum(b); });
  const auto slow = [](const Entry& e) {
    return *std::min_element(e.costs.begin(), e.costs.end()) >= least_cost;
  };
  const auto first = std::find_if(entries_.begin(), entries_.end(), slow);
  probe_ = static_cast<std::size_t>(first - entries_.begin());
  if (first == entries_.end() && probe_ > 0) --probe_;
}

std::optional<Setting> FamilyFit::probe() const {
  if (entries_.empty()) return {};
  return entries_[probe_].setting;
}

std::optional<Choice> FamilyFit::choose(double cost, const Wish& wish) const {
  std::vector<Choice> all, presets;
  for (const auto& entry : entries_) {
    double ratio = 0;
    for (std::size_t k = 0; k < entry.costs.size(); ++k)
      ratio = std::max(ratio, entry.costs[k] / entries_[probe_].costs[k]);
    const auto [low, high] = std::minmax_element(entry.errors.begin(), entry.errors.end());
    all.push_back({entry.setting, *high, *low, cost * ratio});
    if (entry.preset_alone) presets.push_back(all.back());
  }
  const auto chosen = best(std::move(all), wish), preset = best(std::move(presets), wish);
  const bool as_cheap =
      wish.error && preset && preset->fulfils && preset->cost <= alike * chosen->cost;
  return as_cheap ? preset : chosen;
}

}  // namespace brisance
