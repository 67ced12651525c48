#include "drivers/tradeoff_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

#include "drivers/files.hpp"

namespace brisance {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
const char* const head =
    "scene,family,preset,resolution [-],particles per cell,CFL,shape,preset alone,status,error "
    "[-],core time [s],cost over front [-],commit";

std::string number(double value) {
  if (!std::isfinite(value)) return "";
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

bool is_as_good(const TradeoffPoint& a, const TradeoffPoint& b) {
  return a.valid() && a.scene == b.scene && a.error <= b.error;
}

std::string line_of(const TradeoffPoint& p) {
  char text[200];
  std::snprintf(text, sizeof text, "%9.3g %12.3g %11.2f   %-9s %6g   %-9s %4g  %s%s\n",
                100 * p.error, p.cost, p.excess, p.setting.preset.c_str(), p.setting.resolution,
                p.setting.particles.c_str(), p.setting.cfl, p.setting.shape.c_str(),
                p.preset_alone ? "  (preset)" : "");
  return text;
}

}  // namespace

void compare_with_front(TradeoffPoints& points) {
  for (auto& point : points) {
    point.excess = none;
    if (!point.valid()) continue;
    double cheapest = point.cost;
    for (const auto& other : points)
      if (is_as_good(other, point)) cheapest = std::min(cheapest, other.cost);
    point.excess = point.cost / cheapest;
  }
}

void write_points(const std::filesystem::path& csv, const TradeoffPoints& points) {
  std::string text = std::string(head) + "\n";
  for (const auto& p : points) {
    const Setting& s = p.setting;
    text += p.scene + "," + p.family + "," + s.preset + "," + number(s.resolution) + "," +
            s.particles + "," + number(s.cfl) + "," + s.shape + "," +
            (p.preset_alone ? "yes" : "no") + "," + p.status + "," + number(p.error) + "," +
            number(p.cost) + "," + number(p.excess) + "," + p.commit + "\n";
  }
  write_file(csv, text);
}

TradeoffPoints read_points(const std::filesystem::path& csv) {
  TradeoffPoints points;
  std::istringstream lines(read_file(csv));
  int at = 1;
  const auto refuse_line = [&](const std::string& why) {
    throw InputError("", "", "", why, csv.string(), at);
  };
  std::string line;
  if (!std::getline(lines, line) || line != head)
    refuse_line("is no table of the command 'tradeoff' of this version");
  while (std::getline(lines, line)) {
    ++at;
    const auto cells = cells_of(line);
    if (cells.size() != 13) refuse_line("must have 13 columns");
    const auto value = [&](std::size_t column) {
      const std::string& cell = cells[column];
      double result = none;
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), result);
      if (!cell.empty() && (error != std::errc() || end != cell.data() + cell.size()))
        refuse_line("column " + std::to_string(column + 1) + " must be a number");
      return result;
    };
    points.push_back({cells[0],
                      cells[1],
                      {cells[2], value(3), cells[4], value(5), cells[6]},
                      cells[7] == "yes",
                      cells[8],
                      value(9),
                      value(10),
                      value(11),
                      cells[12]});
  }
  return points;
}

std::string front_table(const TradeoffPoints& points, const std::string& scene) {
  std::vector<TradeoffPoint> front, presets;
  int failed = 0, runs = 0;
  for (const auto& point : points) {
    if (point.scene != scene) continue;
    ++runs;
    if (!point.valid())
      ++failed;
    else if (point.excess <= 1)
      front.push_back(point);
    else if (point.preset_alone)
      presets.push_back(point);
  }
  std::string text = scene + ": " + std::to_string(runs) + " settings";
  if (failed > 0) text += ", " + std::to_string(failed) + " of them without a result";
  text += "\n  error, %  core time, s  over front   preset    resolution  particles  CFL  shape\n";
  const auto dearer = [](const auto& a, const auto& b) { return a.cost > b.cost; };
  for (auto* group : {&front, &presets}) {
    std::sort(group->begin(), group->end(), dearer);
    if (group == &presets && !presets.empty()) text += "presets beside the front:\n";
    for (const auto& point : *group) text += line_of(point);
  }
  return text;
}

}  // namespace brisance
