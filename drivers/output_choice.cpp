#include "drivers/output_choice.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drivers/output_times.hpp"
#include "drivers/progress.hpp"
#include "drivers/scene.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

using Names = std::vector<std::string>;

/// A column that is always there: numbers in a row of the particles and of the grid, and whether
/// those are whole numbers, which have no precision; so many bytes then.
struct Common {
  const char* name;
  int of_particles, of_cells, whole_bytes;
};
constexpr Common common[] = {{"velocity", 3, 3, 0}, {"mass", 1, 0, 0},     {"volume", 1, 0, 0},
                             {"density", 1, 1, 0},  {"pressure", 1, 1, 0}, {"energy", 1, 1, 0},
                             {"material", 1, 0, 4}, {"id", 1, 0, 8},       {"fill", 0, 1, 0}};

/// Every name once.
Names fields_of(const List& materials, int dim) {
  Names all;
  for (const auto& name : list_names(materials))
    for (const auto& field : field_names(materials.sublist(name), dim))
      if (std::find(all.begin(), all.end(), field) == all.end()) all.push_back(field);
  return all;
}

}  // namespace

std::string readable_bytes(double bytes) {
  return readable_number(bytes) + (bytes < 999.5 ? " B" : "B");
}

std::string OutputSize::text() const {
  char number[40];
  std::snprintf(number, sizeof number, "about %.0f times ", times);
  std::string files;
  if (particle_file > 0) files += readable_bytes(particle_file) + " (particles)";
  if (grid_file > 0)
    files += (files.empty() ? "" : " and ") + readable_bytes(grid_file) + " (grid)";
  if (files.empty()) return "no particles and no grid";
  return number + files + ": " + readable_bytes(all()) + " in all";
}

List OutputChoice::valid_parameters(const List& materials, int dim) {
  Names choices;
  for (const Common& column : common) choices.push_back(column.name);
  for (const auto& field : fields_of(materials, dim)) choices.push_back(field);
  List valid;
  declare(valid, "interval", 0.0, at_least_zero(),
          "simulated time between outputs; 0: a tenth of the run, or by steps [s]");
  declare(valid, "steps", 0, at_least(0),
          "steps between outputs, in place of a time; 0: not by steps [-]");
  declare(valid, "history interval", 0.0, at_least_zero(),
          "simulated time between further lines of history.csv; 0: only at outputs [s]");
  declare(valid, "particles", true, anything(), "particles, as .vtp [-]");
  declare(valid, "grid", true, anything(), "nodes and cells, as .vti [-]");
  declare(valid, "columns", Names{}, one_of(choices),
          "what is written of each particle and cell, beside its place; none named: everything "
          "[-]");
  declare(valid, "precision", "double", one_of({"double", "single"}),
          "of the numbers in both files: 16 digits in 8 bytes, or 7 digits in 4 [-]");
  declare(valid, "largest size", 100.0, positive(),
          "of all particles and grids; a run that would write more is refused before it starts "
          "[GB]");
  return valid;
}

void OutputChoice::check(const List& output) {
  if (OutputTimes::by_steps(output) && get<double>(output, "interval") > 0)
    refuse(output, "steps", "must be 0 where 'interval' is given: outputs go by time or by steps");
}

OutputChoice::OutputChoice(const List& scene)
    : fields_(fields_of(scene.sublist("materials"), dimension(scene))),
      end_(get<double>(scene.sublist("time"), "end")) {
  const List& output = scene.sublist("output");
  columns_ = get<Names>(output, "columns");
  particles_ = get<bool>(output, "particles");
  grid_ = get<bool>(output, "grid");
  single_ = get<std::string>(output, "precision") == "single";
  interval_ = get<double>(output, "interval");
  steps_ = get<int>(output, "steps");
}

bool OutputChoice::has(const std::string& column) const {
  return columns_.empty() || std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

OutputSize OutputChoice::size(double particles, double cells, double steps, double start) const {
  const double number = single_ ? 4 : 8;
  // A point is its place, and two integers that make it a vertex.
  double of_particle = 3 * number + 8, of_cell = 0;
  for (const Common& column : common) {
    if (!has(column.name)) continue;
    of_particle += column.of_particles * (column.whole_bytes > 0 ? column.whole_bytes : number);
    of_cell += column.of_cells * number;
  }
  for (const auto& field : fields_) of_particle += has(field) ? number : 0;
  OutputSize size;
  size.particle_file = particles_ ? particles * of_particle : 0;
  size.grid_file = grid_ ? cells * of_cell : 0;
  const double by_time = std::ceil((end_ - start) / (interval_ > 0 ? interval_ : end_ / 10) - 1e-9),
               between = steps_ > 0 ? std::ceil(steps / steps_ - 1e-9) : std::min(by_time, steps);
  size.times = 1 + between;
  return size;
}

void OutputChoice::expect_within_limit(const List& scene, const OutputSize& size) {
  const List& output = scene.sublist("output");
  if (size.all() <= 1e9 * get<double>(output, "largest size")) return;
  refuse(output, "largest size",
         "the run would write more, " + size.text() +
             "; write less often, name 'columns', set 'precision' to single, or raise this");
}

}  // namespace brisance
