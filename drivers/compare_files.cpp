// What is compared of two runs, file by file.
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "drivers/compare.hpp"
#include "drivers/files.hpp"
#include "drivers/input.hpp"
#include "drivers/vtk.hpp"
#include "drivers/vtk_read.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using Columns = std::vector<vtk::ReadColumn>;

std::string at_time(double time) {
  char text[40];
  std::snprintf(text, sizeof text, "t = %.6g s", time);
  return text;
}

const vtk::ReadColumn* find(const Columns& columns, const std::string& name) {
  for (const auto& column : columns)
    if (column.name == name) return &column;
  return nullptr;
}

void tell_once(std::vector<std::string>& apart, const std::string& text) {
  if (std::find(apart.begin(), apart.end(), text) == apart.end()) apart.push_back(text);
}

/// Names that only one has; calls f for those of both.
void match_names(const std::vector<std::string>& a, const std::vector<std::string>& b,
                 const std::string& what, std::vector<std::string>& apart,
                 const std::function<void(const std::string&)>& f) {
  const auto in = [](const auto& all, const auto& name) {
    return std::find(all.begin(), all.end(), name) != all.end();
  };
  for (const auto& name : a) {
    if (in(b, name))
      f(name);
    else
      tell_once(apart, "only in A: " + what + " '" + name + "'");
  }
  for (const auto& name : b)
    if (!in(a, name)) tell_once(apart, "only in B: " + what + " '" + name + "'");
}

std::vector<std::string> names_of(const Columns& columns) {
  std::vector<std::string> names;
  for (const auto& column : columns) names.push_back(column.name);
  return names;
}

/// All columns of two sets of rows; pairs: rows that belong together; where: of a row of A.
void compare_columns(const Columns& a, const Columns& b,
                     const std::vector<std::pair<std::size_t, std::size_t>>& pairs,
                     const std::function<std::string(std::size_t)>& where, FileDifference& file) {
  match_names(names_of(a), names_of(b), "column", file.apart, [&](const std::string& name) {
    const vtk::ReadColumn &one = *find(a, name), &other = *find(b, name);
    ColumnDifference& column = file.column(name);
    const int n = one.components;
    if (n != other.components)
      return tell_once(file.apart, "column '" + name + "' has numbers of components that differ");
    for (const auto& [i, j] : pairs)
      for (int k = 0; k < n; ++k)
        column.add(one.values[i * n + k], other.values[j * n + k], [&, row = i] {
          return where(row) + (n == 3 ? std::string(", ") + "xyz"[k] : std::string());
        });
  });
}

/// The rows of a particle file by material and number, in which two runs need not agree.
std::vector<std::size_t> by_number(const Columns& columns) {
  const auto &material = find(columns, "material")->values, &id = find(columns, "id")->values;
  std::vector<std::size_t> order(id.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(material[a], id[a]) < std::pair(material[b], id[b]);
  });
  return order;
}

void compare_particles(const fs::path& a, const fs::path& b, double time,
                       const std::vector<std::string>& materials, FileDifference& file) {
  const Columns one = vtk::read_vtp(a), other = vtk::read_vtp(b);
  const auto key = [](const Columns& columns, std::size_t row) {
    return std::pair(find(columns, "material")->values[row], find(columns, "id")->values[row]);
  };
  const auto rows = by_number(one), others = by_number(other);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0, j = 0; i < rows.size() && j < others.size();) {
    const auto p = key(one, rows[i]), q = key(other, others[j]);
    if (p == q) pairs.emplace_back(rows[i], others[j]);
    i += p <= q;
    j += q <= p;
  }
  if (const auto left = rows.size() - pairs.size(); left > 0)
    file.apart.push_back("only in A: " + std::to_string(left) + " particles at " + at_time(time));
  if (const auto left = others.size() - pairs.size(); left > 0)
    file.apart.push_back("only in B: " + std::to_string(left) + " particles at " + at_time(time));
  compare_columns(
      one, other, pairs,
      [&](std::size_t row) {
        const auto [material, id] = key(one, row);
        return at_time(time) + ", particle " + std::to_string(static_cast<long>(id)) + " of " +
               materials.at(static_cast<std::size_t>(material));
      },
      file);
}

void compare_grids(const fs::path& a, const fs::path& b, double time, FileDifference& file) {
  const vtk::ReadGrid one = vtk::read_vti(a), other = vtk::read_vti(b);
  if (one.cells != other.cells) return tell_once(file.apart, "the grids differ in their cells");
  std::size_t count = 1;
  for (const int n : one.cells) count *= static_cast<std::size_t>(std::max(1, n));
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t k = 0; k < count; ++k) pairs.emplace_back(k, k);
  compare_columns(
      one.columns, other.columns, pairs,
      [&](std::size_t row) {
        const auto nx = static_cast<std::size_t>(one.cells[0]);
        return at_time(time) + ", cell (" + std::to_string(row % nx) + ", " +
               std::to_string(row / nx) + ")";
      },
      file);
}

/// A series that at least one has.
FileDifference compare_series(const std::string& name, const fs::path& a, const fs::path& b) {
  FileDifference file{name, "", {}, {}};
  const auto entries = [&](const fs::path& folder) {
    return vtk::Series::resumed(folder / (name + ".pvd"), std::numeric_limits<double>::max())
        .entries();
  };
  const auto one = entries(a), other = entries(b);
  const auto times = [](const auto& all) {
    std::vector<double> values;
    for (const auto& entry : all) values.push_back(entry.time);
    return values;
  };
  const auto materials =
      list_names(read_input((a / "input.xml").string()).list->sublist("materials"));
  std::size_t count = 0;
  match_times(times(one), times(other), "output", file.apart, [&](std::size_t i, std::size_t j) {
    const fs::path first = a / one[i].file, second = b / other[j].file;
    if (name == "particles")
      compare_particles(first, second, one[i].time, materials, file);
    else
      compare_grids(first, second, one[i].time, file);
    ++count;
  });
  file.count = std::to_string(count) + " times";
  return file;
}

FileDifference compare_measures(const fs::path& a, const fs::path& b) {
  FileDifference file{"summary.json", "measures", {}, {}};
  const auto measures = [](const fs::path& folder) {
    std::map<std::string, double> values;
    const auto summary = nlohmann::json::parse(read_file(folder / "summary.json"));
    for (const auto& [name, measure] : summary.at("measures").items())
      values[name] =
          measure.at("value").is_null() ? std::nan("") : measure.at("value").get<double>();
    return values;
  };
  const auto names = [](const auto& all) {
    std::vector<std::string> list;
    for (const auto& [name, value] : all) list.push_back(name);
    return list;
  };
  const auto one = measures(a), other = measures(b);
  match_names(names(one), names(other), "measure", file.apart, [&](const std::string& name) {
    file.column(name).add(one.at(name), other.at(name), [] { return "the end"; });
  });
  return file;
}

}  // namespace

std::vector<FileDifference> compare_runs(const fs::path& a, const fs::path& b) {
  std::vector<FileDifference> files;
  std::set<std::string> all;
  for (const auto& folder : {a, b})
    for (const auto& entry : fs::directory_iterator(folder)) {
      const auto extension = entry.path().extension();
      const std::string name = entry.path().filename().string();
      if (extension == ".csv" || extension == ".pvd" || name == "summary.json") all.insert(name);
    }
  for (const auto& name : all) {
    if (!fs::exists(a / name) || !fs::exists(b / name))
      files.push_back(
          {name, "not compared", {}, {fs::exists(a / name) ? "only in A" : "only in B"}});
    else if (name == "summary.json")
      files.push_back(compare_measures(a, b));
    else if (fs::path(name).extension() == ".pvd")
      files.push_back(compare_series(fs::path(name).stem().string(), a, b));
    else
      files.push_back(compare_tables(name, read_file(a / name), read_file(b / name)));
  }
  return files;
}

}  // namespace brisance
