#include "drivers/time_spent.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace brisance {
namespace {

constexpr const char* part_names[] = {"set-up", "steps",       "watches",          "output",
                                      "tables", "checkpoints", "wait for the disk"};

/// What it costs to look at one launch, measured on one thread. [s]
constexpr double cost_of_look = 1e-7;
/// Of the time of a run, that goes into it.
constexpr double bearable = 0.002;

/// Labels that begin or end alike, and what they are called together. The first that fits counts.
constexpr std::pair<std::string_view, const char*> beginnings[] = {
    {"Kokkos::", "fill and sum arrays"},
    {"find bins", "sort particles"},
    {"count bins", "sort particles"},
    {"places of bins", "sort particles"},
    {"order of", "sort particles"},
    {"lay tiles", "sort particles"},
    {"permute", "sort particles"},
    {"put ends of chunks aside", "sort particles"},
    {"longest of rows", "split particles"},
    {"count parts", "split particles"},
    {"place parts", "split particles"},
    {"copy parts", "split particles"},
    {"lay out parts", "split particles"},
    {"half step", "half step"},
    {"scatter tensor force", "scatter force"},
    {"finish tensor midpoint", "finish midpoint"},
    {"fill halo", "halo"},
    {"fold halo", "halo"},
    {"scatter mean", "scatter means"},
    {"nodal mean", "nodal means"}};
constexpr std::pair<std::string_view, const char*> endings[] = {
    {" sleepers", "sleepers"}, {" spring", "springs"}, {" springs", "springs"}};

std::string together(std::string_view name) {
  for (const auto& [start, all] : beginnings)
    if (name.substr(0, start.size()) == start) return all;
  for (const auto& [end, all] : endings)
    if (name.size() > end.size() && name.substr(name.size() - end.size()) == end) return all;
  return std::string(name);
}

void sort(std::vector<TimeRow>& rows) {
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TimeRow& a, const TimeRow& b) { return a.seconds > b.seconds; });
}

}  // namespace

std::vector<TimeRow> alike_together(const std::vector<TimeRow>& kernels) {
  std::vector<TimeRow> rows;
  for (const TimeRow& kernel : kernels) {
    const bool second = is_second_launch(kernel.name);
    const std::string name =
        together(second ? kernel.name.substr(0, kernel.name.size() - 4) : kernel.name);
    auto row = std::find_if(rows.begin(), rows.end(),
                            [&](const TimeRow& known) { return known.name == name; });
    if (row == rows.end()) row = rows.insert(row, {name});
    row->seconds += kernel.seconds;
    if (!second) row->calls += kernel.calls;
  }
  sort(rows);
  return rows;
}

void TimeKeeper::measure(double seconds) {
  kernels_.stop();
  measured_seconds_ += seconds;
  ++measured_steps_;
  long launches = 0;
  for (const auto& kernel : kernels_.all()) launches += kernel.launches;
  const double cost = static_cast<double>(launches - launches_) * cost_of_look;
  launches_ = launches;
  skip_ = static_cast<long>(std::min(cost / (bearable * seconds), 1000.0));
}

TimeSpent TimeKeeper::so_far() const {
  TimeSpent all;
  all.seconds = since(started_);
  all.measured_steps = static_cast<double>(measured_steps_);
  double left = all.seconds;
  for (int part = 0; part < count; ++part) {
    left -= spent_[part];
    if (calls_[part] > 0)
      all.parts.push_back({part_names[part], spent_[part], static_cast<double>(calls_[part])});
  }
  all.parts.push_back({"the rest", std::max(left, 0.0), 1});
  if (measured_steps_ == 0) return all;
  const double longer = spent_[steps] / measured_seconds_,
               more = static_cast<double>(calls_[steps]) / all.measured_steps;
  for (const auto& kernel : kernels_.all())
    all.kernels.push_back(
        {kernel.name, longer * kernel.seconds, more * static_cast<double>(kernel.launches)});
  sort(all.kernels);
  return all;
}

}  // namespace brisance
