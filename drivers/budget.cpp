#include "drivers/budget.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <set>

#include "core/types.hpp"

namespace brisance {
namespace {

constexpr double most_steps = 1e8;
constexpr double speed_of_light = 299792458;  // [m/s]
constexpr double without_limit = std::numeric_limits<double>::infinity();

/// A file that holds one number; otherwise ("max", or no such file) without limit.
double number_in(const char* file) {
  double value;
  return std::ifstream(file) >> value ? value : without_limit;
}

void check_memory(const List& list, const std::string& parameter, double bytes, double available) {
  if (bytes <= available) return;
  char text[100];
  std::snprintf(text, sizeof text, "needs %.3g GB of memory or more, and %.3g GB are free",
                bytes / 1e9, available / 1e9);
  refuse(list, parameter, text);
}

}  // namespace

// Linux: /proc/meminfo (proc(5)) and the limit of a control group, version 2.
double available_memory() {
  double available = without_limit, kilobytes;
  std::ifstream info("/proc/meminfo");
  for (std::string line; std::getline(info, line);)
    if (std::sscanf(line.c_str(), "MemAvailable: %lf", &kilobytes) == 1)
      available = 1024 * kilobytes;
  // Of what a group uses, caches are given back on demand, so that its limit counts alone.
  return std::min(available, number_in("/sys/fs/cgroup/memory.max"));
}

void check_grid_memory(const List& scene, double available) {
  const List& grid = scene.sublist("grid");
  const auto cells = get<std::vector<int>>(grid, "cells");
  const auto dim = static_cast<double>(cells.size());
  double nodes = 1, all = 1;
  for (const int n : cells) {
    nodes *= n + 3.0;
    all *= n;
  }
  std::set<int> per_cell;
  const List& bodies = scene.sublist("bodies");
  for (const auto& name : list_names(bodies))
    per_cell.insert(get<int>(bodies.sublist(name), "particles per cell"));
  // Velocities before and after with the mass, sums of each thread, and who owns each place.
  double bytes = nodes * 8 * (2 * dim + 1 + (dim + 1) * (1 + Space().concurrency()));
  for (const int n : per_cell) bytes += 4 * all * std::pow(n, dim);
  check_memory(grid, "cells", bytes, available);
}

void check_particle_memory(const List& scene, double particles, double available) {
  const auto dim =
      static_cast<double>(get<std::vector<int>>(scene.sublist("grid"), "cells").size());
  // Place, velocity, its gradient, mass, volume, stress and number; the bin.
  check_memory(scene.sublist("bodies"), "", particles * (8 * (2 * dim + dim * dim + 4) + 4),
               available);
}

void check_start(const List& scene, double dt, double fastest, double mass, double energy) {
  const bool finite =
      fastest < 1e299 && dt > 0 && mass > 0 && std::isfinite(mass) && std::isfinite(energy);
  if (!finite)
    refuse(scene.sublist("bodies"), "",
           "has values too large or too small: mass, energy or speed of sound is no number");
  char text[160];
  if (fastest > speed_of_light) {
    std::snprintf(text, sizeof text,
                  "start with signals of %.3g m/s, faster than light; a value of them or of their "
                  "materials is far too large or too small",
                  fastest);
    refuse(scene.sublist("bodies"), "", text);
  }
  if (energy > mass * speed_of_light * speed_of_light) {
    std::snprintf(text, sizeof text,
                  "start with %.3g J/kg, more than mass can hold; a value of them is far too large",
                  energy / mass);
    refuse(scene.sublist("bodies"), "", text);
  }
  const List& time = scene.sublist("time");
  const double steps = get<double>(time, "end") / dt;
  if (steps <= most_steps) return;
  std::snprintf(text, sizeof text, "takes about %.2g steps of %.2g s, more than %.0e", steps, dt,
                most_steps);
  refuse(time, "end", text);
}

}  // namespace brisance
