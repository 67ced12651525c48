#include "drivers/plausible.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/body_checks.hpp"

namespace brisance {
namespace {

using Doubles = std::vector<double>;

/// Far more than anyone looks at, and every one is a line in memory.
constexpr double most_intervals = 1e7;

/// Volumes of cells and squares of lengths must be numbers, and neighbours apart in the digits of a
/// double, with some to spare for a place within the cell.
void check_grid(const List& grid) {
  const double h = get<double>(grid, "cell size");
  if (!(h > 1e-50 && h < 1e50)) refuse(grid, "cell size", "must be > 1e-50 and < 1e50");
  const auto origin = get<Doubles>(grid, "origin");
  for (const double x : origin)
    if (std::fabs(x) > 1e9 * h) refuse(grid, "origin", "must be nearer to 0 than 1e9 cells");
}

void check_ranges(const List& ranges) {
  for (const auto& name : list_names(ranges)) {
    const List& range = ranges.sublist(name);
    if (get<double>(range, "least") > get<double>(range, "most"))
      refuse(range, "least", "must not be above 'most'");
  }
}

void check_interval(const List& scene, const List& list, const std::string& name) {
  const double interval = get<double>(list, name);
  if (interval > 0 && get<double>(scene.sublist("time"), "end") / interval > most_intervals)
    refuse(list, name, "must be 0 or at least a 1e7th of the run");
}

/// Waves may come from outside, but not from farther off than the grid is long.
void check_source(const List& grid, const List& list, const std::string& name) {
  const auto place = get<Doubles>(list, name), origin = get<Doubles>(grid, "origin");
  const auto cells = get<std::vector<int>>(grid, "cells");
  double longest = 0;
  for (const int n : cells) longest = std::max(longest, n * get<double>(grid, "cell size"));
  for (std::size_t d = 0; d < place.size(); ++d) {
    const double high = origin[d] + cells[d] * get<double>(grid, "cell size");
    if (place[d] < origin[d] - longest || place[d] > high + longest)
      refuse(list, name, "is farther from the grid than that is long");
  }
}

void check_sources(const List& grid, const List& sources) {
  for (const auto& name : list_names(sources)) {
    const List& source = sources.sublist(name);
    if (const List* line = find_list(source, "line"))
      for (const char* end : {"from", "to"}) check_source(grid, *line, end);
    else if (const List* plane = find_list(source, "plane"))
      check_source(grid, *plane, "point");
    else
      check_source(grid, source, "point");
  }
}

}  // namespace

void check_plausible(const List& scene) {
  const List& grid = scene.sublist("grid");
  check_grid(grid);
  check_extents(scene);
  if (const List* checks = find_list(scene, "checks")) check_ranges(*checks);
  if (const List* convergence = find_list(scene, "convergence"))
    for (const char* name : {"order", "every"})
      if (const List* ranges = find_list(*convergence, name)) check_ranges(*ranges);
  for (const char* name : {"interval", "history interval"})
    check_interval(scene, scene.sublist("output"), name);
  if (const List* gauges = find_list(scene, "gauges")) check_interval(scene, *gauges, "interval");
  if (const List* ignition = find_list(scene, "ignition"))
    check_sources(grid, ignition->sublist("sources"));
}

}  // namespace brisance
