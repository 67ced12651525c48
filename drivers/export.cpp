#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "drivers/commands.hpp"
#include "drivers/files.hpp"
#include "drivers/vtk.hpp"
#include "drivers/vtk_read.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

void require_run(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw std::runtime_error("'" + folder.string() + "' is not a folder");
  if (!fs::exists(folder / "input.xml"))
    throw std::runtime_error("'" + folder.string() + "' holds no run: it has no input.xml");
}

/// The names of the materials of a run, in the order of their numbers.
std::vector<std::string> material_names(const fs::path& folder) {
  return list_names(load_scene({(folder / "input.xml").string(), {}, {}}).sublist("materials"));
}

/// The columns of a particle file as those of a table, as far as the run has written them: material
/// and number first, then what all particles have, then what materials add.
class Table {
 public:
  Table(const std::vector<vtk::ReadColumn>& columns, std::vector<std::string> materials)
      : materials_(std::move(materials)) {
    static const std::vector<std::pair<std::string, std::vector<std::string>>> common = {
        {"points", {"x", "y", "z"}},
        {"velocity", {"vx", "vy", "vz"}},
        {"mass", {"mass"}},
        {"volume", {"volume"}},
        {"density", {"density"}},
        {"pressure", {"pressure"}},
        {"energy", {"energy"}},
        {"material", {}},
        {"id", {}}};
    for (const auto& [name, heads] : common) {
      const auto found = std::find_if(columns.begin(), columns.end(),
                                      [&, key = name](const auto& c) { return c.name == key; });
      if (found == columns.end()) continue;
      if (name == "material") material_ = &*found;
      if (name == "id") id_ = &*found;
      for (std::size_t k = 0; k < heads.size(); ++k)
        sources_.push_back({heads[k], &*found, static_cast<int>(k)});
    }
    for (const auto& c : columns) {
      const bool known = std::any_of(common.begin(), common.end(),
                                     [&](const auto& one) { return one.first == c.name; });
      for (int k = 0; k < c.components && !known; ++k)
        sources_.push_back({c.name + (c.components > 1 ? "_" + std::to_string(k) : ""), &c, k});
    }
    rows_ = columns.front().values.size() / 3;  // the points
  }

  std::size_t rows() const { return rows_; }

  std::string head() const {
    std::string text = std::string(material_ ? ",material" : "") + (id_ ? ",id" : "");
    for (const Source& s : sources_) text += "," + s.head;
    return text.substr(1);
  }

  std::string line(std::size_t row) const {
    std::string text;
    if (material_) text += "," + materials_.at(static_cast<std::size_t>(material_->values[row]));
    char number[32];
    const auto add = [&](const char* format, double value) {
      std::snprintf(number, sizeof number, format, value);
      text += number;
    };
    if (id_) add(",%.0f", id_->values[row]);
    for (const Source& s : sources_)
      add(",%.17g", s.column->values[row * s.column->components + s.component]);
    return text.substr(1);
  }

 private:
  struct Source {
    std::string head;
    const vtk::ReadColumn* column;
    int component;
  };
  std::vector<std::string> materials_;
  std::vector<Source> sources_;
  const vtk::ReadColumn *material_ = nullptr, *id_ = nullptr;
  std::size_t rows_ = 0;
};

}  // namespace

int export_command(const std::string& folder, const std::string& csv, double time) {
  require_run(folder);
  const auto series =
      vtk::Series::resumed(fs::path(folder) / "particles.pvd", std::numeric_limits<double>::max());
  if (series.entries().empty())
    throw std::runtime_error("'" + folder +
                             "' holds no particles: its scene has output/particles = false");
  auto entry = std::prev(series.entries().end());
  if (time >= 0)
    entry = std::min_element(series.entries().begin(), series.entries().end(),
                             [&](const auto& a, const auto& b) {
                               return std::fabs(a.time - time) < std::fabs(b.time - time);
                             });
  const auto columns = vtk::read_vtp(fs::path(folder) / entry->file);
  const Table table(columns, material_names(folder));
  AtomicFile file(csv);
  file.write(table.head() + "\n");
  for (std::size_t row = 0; row < table.rows(); ++row) file.write(table.line(row) + "\n");
  file.commit();
  std::printf("%zu particles at t = %.6g s in %s\n", table.rows(), entry->time, csv.c_str());
  return 0;
}

}  // namespace brisance
