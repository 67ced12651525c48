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
  const auto find = [&](const std::string& name) -> const vtk::ReadColumn& {
    for (const auto& c : columns)
      if (c.name == name) return c;
    throw std::runtime_error("'" + entry->file + "' has no column '" + name + "'");
  };
  const auto names = material_names(folder);
  std::string head = "material,id,x,y,z,vx,vy,vz,mass,volume,density,pressure,energy";
  struct Source {
    const vtk::ReadColumn* column;
    int component;
  };
  std::vector<Source> sources = {
      {&find("points"), 0},   {&find("points"), 1},   {&find("points"), 2}, {&find("velocity"), 0},
      {&find("velocity"), 1}, {&find("velocity"), 2}, {&find("mass"), 0},   {&find("volume"), 0},
      {&find("density"), 0},  {&find("pressure"), 0}, {&find("energy"), 0}};
  const std::vector<std::string> common = {"points",   "velocity", "mass",     "volume", "density",
                                           "pressure", "energy",   "material", "id"};
  for (const auto& c : columns) {
    if (std::find(common.begin(), common.end(), c.name) != common.end()) continue;
    for (int k = 0; k < c.components; ++k) {
      head += "," + c.name + (c.components > 1 ? "_" + std::to_string(k) : "");
      sources.push_back({&c, k});
    }
  }
  const auto &material = find("material"), &id = find("id");
  AtomicFile file(csv);
  file.write(head + "\n");
  char number[32];
  for (std::size_t row = 0; row < id.values.size(); ++row) {
    std::string line = names.at(static_cast<std::size_t>(material.values[row]));
    std::snprintf(number, sizeof number, ",%.0f", id.values[row]);
    line += number;
    for (const Source& s : sources) {
      std::snprintf(number, sizeof number, ",%.17g",
                    s.column->values[row * s.column->components + s.component]);
      line += number;
    }
    file.write(line + "\n");
  }
  file.commit();
  std::printf("%zu particles at t = %.6g s in %s\n", id.values.size(), entry->time, csv.c_str());
  return 0;
}

}  // namespace brisance
