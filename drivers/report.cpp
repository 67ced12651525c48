// The lines at the end of a run, for people.
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drivers/output_choice.hpp"
#include "drivers/progress.hpp"
#include "drivers/summary.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// A line under a word in the margin; without a word it goes on with the one before.
std::string line(const std::string& word, const std::string& text) {
  return format("%-9s", word.c_str()) + text;
}

std::string method_of(const List& scheme, const std::string& quadrature) {
  return get<std::string>(scheme, "shape") + " shapes, " + get<std::string>(scheme, "transfer") +
         quadrature;
}

void add_model(Lines& lines, const List& scene, const Balance& b) {
  const List& grid = scene.sublist("grid");
  std::string cells;
  for (const int n : get<std::vector<int>>(grid, "cells"))
    cells += (cells.empty() ? "" : " x ") + std::to_string(n);
  lines.push_back(line("model", get<std::string>(scene, "geometry") + ", " + cells +
                                    format(" cells of %g m, %ld particles",
                                           get<double>(grid, "cell size"), b.particles)));
  const bool is_line = get<std::string>(scene, "geometry") == "line";
  bool fluids = false, solids = false;
  for (const auto& material : b.materials) {
    (material.solid ? solids : fluids) = true;
    const List& given = scene.sublist("materials").sublist(material.name);
    lines.push_back(line("", material.name + " (" + get<std::string>(given, "law") + "): " +
                                 format("%ld particles, %.4g kg/%s", material.particles,
                                        material.totals.mass, is_line ? "m2" : "m")));
  }
  const List& scheme = scene.sublist("scheme");
  std::string method = "preset " + get<std::string>(scene, "preset") + ", " +
                       get<std::string>(scheme, "integration");
  if (fluids)
    method += "; fluids: " +
              method_of(scheme, ", " + get<std::string>(scheme, "quadrature") + " quadrature");
  if (solids) method += "; solids: " + method_of(scheme.sublist("solids"), "");
  lines.push_back(line("scheme", method));
}

void add_books(Lines& lines, const Ledger& ledger, const Balance& b) {
  lines.push_back(line("kept", format("mass to %.1e, momentum to %.1e, energy to %.1e of all",
                                      std::fabs(ledger.mass_error(b)), ledger.momentum_error(b),
                                      std::fabs(ledger.energy_error(b)))));
  if (b.floors > 0)
    lines.push_back(line("", format("an energy was held at its lower bound %ld times", b.floors)));
  if (b.left > 0) lines.push_back(line("", ledger.departures(b)));
}

void add_row(Lines& lines, const TimeRow& row, double all) {
  lines.push_back(line("", format("  %-26s %5.1f %% %10.3g s", row.name.c_str(),
                                  100 * row.seconds / all, row.seconds) +
                               (row.calls > 1 ? format(" %9.0f calls", row.calls) : "")));
}

/// Kernels that take less than a hundredth stand together.
void add_time(Lines& lines, const TimeSpent& spent, bool resumed) {
  lines.push_back(line("time", readable_duration(spent.seconds) + " by the clock" +
                                   (resumed ? " since the restart" : "") +
                                   (spent.kernels.empty() ? "" : ": kernels, then the rest")));
  TimeRow others{"other kernels"};
  double in_kernels = 0;
  for (const TimeRow& row : alike_together(spent.kernels)) {
    in_kernels += row.seconds;
    if (row.seconds >= 0.01 * spent.seconds) {
      add_row(lines, row, spent.seconds);
    } else {
      others.seconds += row.seconds;
      others.calls += row.calls;
    }
  }
  if (others.calls > 0) add_row(lines, others, spent.seconds);
  for (TimeRow row : spent.parts) {
    if (row.name == "steps" && !spent.kernels.empty()) {
      row.name = "steps, between kernels";
      row.seconds = std::max(row.seconds - in_kernels, 0.0);
    }
    add_row(lines, row, spent.seconds);
  }
}

void add_checks(Lines& lines, const std::vector<Verdict>& verdicts) {
  if (verdicts.empty()) return;
  const auto reached =
      std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.reached(); });
  lines.push_back(
      line("checks", format("%ld of %zu reached", static_cast<long>(reached), verdicts.size())));
  for (const Verdict& v : verdicts)
    lines.push_back(
        line("", format("  %-26s %12.4g %-6s %-20s %s", v.quantity.c_str(), v.measured,
                        v.unit.c_str(), v.limit().c_str(), v.reached() ? "reached" : "missed")));
}

double bytes_in(const fs::path& folder) {
  double bytes = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.is_regular_file(ignored)) bytes += static_cast<double>(entry.file_size(ignored));
  return bytes;
}

void add_files(Lines& lines, const fs::path& folder) {
  if (folder.empty()) return;
  std::string names;
  for (const char* name : {"particles.pvd", "grid.pvd", "history.csv", "gauges.csv",
                           "fragments.csv", "exact.csv", "checkpoints", "summary.json", "log.txt"})
    if (fs::exists(folder / name)) names += (names.empty() ? "" : ", ") + std::string(name);
  lines.push_back(
      line("files", "results in " + folder.string() + ": " + names + "; " +
                        readable_bytes(bytes_in(folder) + bytes_in(folder / "checkpoints"))));
  lines.push_back(
      line("look", "brisance plot '" + folder.string() + "'; the .pvd files open in ParaView"));
}

}  // namespace

std::vector<std::string> report(const List& scene, const Outcome& outcome, const Ledger& ledger,
                                const Balance& b, const fs::path& folder) {
  Lines lines;
  const std::string title = get<std::string>(scene, "title");
  lines.push_back(scene.name() + (title.empty() ? "" : ": " + title));
  add_model(lines, scene, b);
  lines.push_back(line("run", outcome.status +
                                  format(" at t = %.6g s after %ld steps, ", b.time, b.step) +
                                  readable_number(outcome.particle_steps / outcome.wall_seconds) +
                                  " particle-steps/s"));
  add_books(lines, ledger, b);
  add_time(lines, outcome.spent, outcome.resumed);
  add_checks(lines, outcome.verdicts);
  add_files(lines, folder);
  return lines;
}

}  // namespace brisance
