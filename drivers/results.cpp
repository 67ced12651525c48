#include "drivers/results.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdio>
#include <sstream>
#include <type_traits>

#include "drivers/at_once.hpp"
#include "drivers/input.hpp"
#include "version.hpp"

namespace brisance {
namespace {

using Doubles = std::vector<double>;

std::string numbered(const std::string& name, std::size_t place, const std::string& extension) {
  char number[32];
  std::snprintf(number, sizeof number, "_%06zu", place);
  return name + number + extension;
}

vtk::Box box_of(const ParticleTable& t) {
  vtk::Box box;
  box.origin = t.origin;
  for (int d = 0; d < 3; ++d) {
    box.spacing[d] = t.cell_size;
    box.cells[d] = d < t.dim ? t.cells[d] : 0;
  }
  return box;
}

/// A series that is resumed may have had files beyond its end: a run that is cut off leaves some.
void keep_series(Archive& archive, const std::string& name, const std::string& extension,
                 vtk::Series& series) {
  const Archive::Part part(archive, name);
  Archive::Doubles times;
  std::string files;
  for (const auto& entry : series.entries()) {
    times.push_back(entry.time);
    files += entry.file + "\n";
  }
  archive.keep("times", times);
  archive.keep("files", files);
  if (!archive.reading()) return;
  std::vector<vtk::Series::Entry> entries;
  std::istringstream lines(files);
  std::string file;
  for (const double time : times)
    if (std::getline(lines, file)) entries.push_back({time, file});
  const auto folder = series.path().parent_path();
  for (std::size_t k = entries.size();
       std::filesystem::remove(folder / numbered(name, k, extension)); ++k) {
  }
  series.resume(std::move(entries));
}

template <class T>
T rounded(double value) {
  // What is too large for a float must not become infinite.
  if constexpr (std::is_same_v<T, float>) value = std::clamp<double>(value, -FLT_MAX, FLT_MAX);
  return static_cast<T>(value);
}

/// Rows of the numbers of several vectors, which outlive the column; an empty one is 0 everywhere.
template <class T>
vtk::Column rows_of(const std::string& name, const std::vector<const Doubles*>& parts) {
  const std::size_t width = parts.size();
  return vtk::Column::made<T>(name, static_cast<int>(width), parts.front()->size(),
                              [parts, width](std::size_t begin, std::size_t end, T* to) {
                                for (std::size_t k = 0; k < width; ++k) {
                                  const Doubles& from = *parts[k];
                                  for (std::size_t row = begin; row < end; ++row)
                                    to[(row - begin) * width + k] =
                                        from.empty() ? T(0) : rounded<T>(from[row]);
                                }
                              });
}

/// The columns of one file, as far as they were chosen and as precise. What they are made of
/// outlives them.
class Columns {
 public:
  explicit Columns(const OutputChoice& choice) : choice_(choice) {}

  vtk::Column column(const std::string& name, const std::vector<const Doubles*>& parts) const {
    return choice_.single() ? rows_of<float>(name, parts) : rows_of<double>(name, parts);
  }
  void add(const std::string& name, const std::vector<const Doubles*>& parts) {
    if (choice_.has(name)) all.push_back(column(name, parts));
  }
  template <class T>
  void add_whole(const std::string& name, const std::vector<T>& values) {
    if (!choice_.has(name)) return;
    const T* from = values.data();
    all.push_back(vtk::Column::made<T>(name, 1, values.size(),
                                       [from](std::size_t begin, std::size_t end, T* to) {
                                         std::copy(from + begin, from + end, to);
                                       }));
  }

  /// What f tells of each cell: an array of numbers; 0 for an empty one.
  template <class F>
  void add_cells(const std::string& name, const std::vector<Sums>& cells, const F& f) {
    if (choice_.has(name))
      all.push_back(choice_.single() ? of_cells<float>(name, cells, f)
                                     : of_cells<double>(name, cells, f));
  }

  std::vector<vtk::Column> all;

 private:
  const OutputChoice& choice_;

  template <class T, class F>
  static vtk::Column of_cells(const std::string& name, const std::vector<Sums>& cells, const F& f) {
    using Value = decltype(f(cells.front()));
    return vtk::Column::made<T>(
        name, std::tuple_size_v<Value>, cells.size(),
        [&cells, f](std::size_t begin, std::size_t end, T* to) {
          for (std::size_t c = begin; c < end; ++c)
            for (const double number : cells[c].empty() ? Value{} : f(cells[c]))
              *to++ = rounded<T>(number);
        });
  }
};

}  // namespace

Results::Results(const std::filesystem::path& folder, const List& scene, const Ledger& ledger,
                 Backlog& backlog)
    : folder_(folder),
      backlog_(backlog),
      choice_(scene),
      particle_series_(folder / "particles.pvd", &backlog),
      grid_series_(folder / "grid.pvd", &backlog),
      history_(ledger.head()) {
  make_folder(folder_);
  write_input(scene, (folder_ / "input.xml").string(),
              "The complete input of this run, defaults included. brisance " +
                  std::string(version::number));
}

void Results::add(const Snapshot& shot) {
  at_once(
      [&] {
        if (choice_.particles()) add_particles(shot);
      },
      [&] {
        if (choice_.grid()) add_grid(shot);
      });
}

void Results::add_particles(const Snapshot& shot) {
  const ParticleTable& t = shot.table;
  Columns columns(choice_);
  columns.add("velocity", {&t.vx, &t.vy, &t.vz});
  columns.add("mass", {&t.mass});
  columns.add("volume", {&t.volume});
  columns.add("density", {&t.density});
  columns.add("pressure", {&t.pressure});
  columns.add("energy", {&t.energy});
  columns.add_whole("material", t.material);
  columns.add_whole("id", shot.id);
  for (const auto& field : t.fields) columns.add(field.name, {&field.values});
  const std::string file = numbered("particles", particle_series_.entries().size(), ".vtp");
  vtk::write_vtp(folder_ / file, columns.column("Points", {&t.x, &t.y, &t.z}), columns.all,
                 &backlog_);
  particle_series_.note(shot.time, folder_ / file);
}

void Results::add_grid(const Snapshot& shot) {
  const ParticleTable& t = shot.table;
  const std::vector<Sums> cells = sums_per_cell(t);
  double size = 1;
  for (int d = 0; d < t.dim; ++d) size *= t.cell_size;
  Columns columns(choice_);
  columns.add_cells("fill", cells, [size](const Sums& s) { return std::array{s.volume / size}; });
  columns.add_cells("density", cells, [](const Sums& s) { return std::array{s.mean_density()}; });
  columns.add_cells("pressure", cells, [](const Sums& s) { return std::array{s.mean_pressure()}; });
  columns.add_cells("energy", cells, [](const Sums& s) { return std::array{s.mean_energy()}; });
  columns.add_cells("velocity", cells, [](const Sums& s) { return s.mean_velocity(); });
  const std::string file = numbered("grid", grid_series_.entries().size(), ".vti");
  vtk::write_vti(folder_ / file, box_of(t), {}, columns.all, &backlog_);
  grid_series_.note(shot.time, folder_ / file);
}

void Results::write_tables() const {
  particle_series_.write();
  grid_series_.write();
  write_file(folder_ / "history.csv", history_, &backlog_);
}

void Results::keep(Archive& archive) {
  const Archive::Part part(archive, "results");
  archive.keep("history.csv", history_);
  keep_series(archive, "particles", ".vtp", particle_series_);
  keep_series(archive, "grid", ".vti", grid_series_);
  if (archive.reading()) write_file(folder_ / "history.csv", history_, &backlog_);
}

void Results::write_exact(const ExactSolution& exact, const Snapshot& shot) {
  const ParticleTable& t = shot.table;
  const bool radial = exact.radial();
  const double length = t.cells[0] * t.cell_size * (radial ? 0.5 : 1);
  const Place centre = exact.centre();
  std::string text =
      radial ? "r,density,velocity,pressure,energy\n" : "x,density,velocity,pressure,energy\n";
  constexpr int points = 2000;
  for (int k = 0; k < points; ++k) {
    const double along = length * (k + 0.5) / points;
    Place x = radial ? centre : t.origin;
    x[0] += along;
    for (int d = 1; d < t.dim && !radial; ++d) x[d] += 0.5 * t.cells[d] * t.cell_size;
    const MatterState s = exact.at(x, shot.time);
    char line[256];
    std::snprintf(line, sizeof line, "%.9g,%.9g,%.9g,%.9g,%.9g\n", radial ? along : x[0], s.rho,
                  s.v[0], s.p, s.e);
    text += line;
  }
  write_file(folder_ / "exact.csv", text, &backlog_);
}

}  // namespace brisance
