#include "drivers/gauges.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "drivers/files.hpp"
#include "drivers/ledger.hpp"

namespace brisance {
namespace {

constexpr const char* any_material = "any";
constexpr double not_given = std::numeric_limits<double>::lowest();
constexpr double arrival_share = 0.05;

double interval_of(const List& scene) {
  const double given = get<double>(scene.sublist("gauges"), "interval");
  return given > 0 ? given : get<double>(scene.sublist("time"), "end") / 1000;
}

List valid_gauge(const std::vector<std::string>& materials, int dim) {
  List valid;
  std::vector<std::string> choices = {any_material};
  choices.insert(choices.end(), materials.begin(), materials.end());
  declare_required<std::vector<double>>(valid, "place", anything() && entries(dim),
                                        "where it is at the start [m]");
  declare(valid, "rides", false, anything(), "whether it moves with matter, or stays [-]");
  declare(valid, "radius", 0.0, at_least_zero(),
          "distance between the knots of the quadratic spline that weighs the matter around it; it "
          "sees 1.5 times as far along each direction; 0: a cell [m]");
  declare(valid, "material", any_material, one_of(choices),
          "whose particles count; any: fluids, or where it sees none of them, everything [-]");
  declare(valid, "reference pressure", not_given, anything(),
          "from which overpressure counts; not given: what it sees at the start [Pa]");
  declare(valid, "arrival", 0.0, at_least_zero(),
          "overpressure that counts as arrival; 0: a twentieth of the reference pressure or of the "
          "peak, whichever is more [Pa]");
  return valid;
}

/// Refuses what does not fit the rest of a complete scene.
void check_gauges(const List& scene) {
  const List& list = scene.sublist("gauges");
  const List& grid = scene.sublist("grid");
  const auto gauges = list_names(list);
  if (gauges.empty()) refuse(scene, "gauges", "must name a gauge");
  const auto origin = get<std::vector<double>>(grid, "origin");
  const auto cells = get<std::vector<int>>(grid, "cells");
  std::vector<std::string> columns;
  for (const auto& name : gauges) {
    const auto place = get<std::vector<double>>(list.sublist(name), "place");
    for (std::size_t d = 0; d < place.size(); ++d) {
      const double high = origin[d] + cells[d] * get<double>(grid, "cell size");
      if (place[d] < origin[d] || place[d] > high)
        refuse(list.sublist(name), "place", "must lie in the grid");
    }
    if (std::count(columns.begin(), columns.end(), column_name(name)) > 0)
      refuse(list.sublist(name), "", "has the same columns in gauges.csv as another");
    columns.push_back(column_name(name));
  }
}

}  // namespace

List Gauges::valid_parameters(const List* given, const std::vector<std::string>& materials,
                              int dim) {
  List valid;
  declare(valid, "interval", 0.0, at_least_zero(),
          "simulated time between samples, each taken at the first step that reaches its time; 0: "
          "a thousandth of the run [s]");
  if (!given) return valid;
  for (const auto& name : list_names(*given))
    declare_list(valid, name, "a gauge") = valid_gauge(materials, dim);
  return valid;
}

std::vector<MeasureDoc> Gauges::measure_docs(const std::vector<std::string>& gauges) {
  std::vector<MeasureDoc> docs;
  for (const auto& name : gauges) {
    docs.push_back({name + " arrival", "s", "when the overpressure first counts as arrived"});
    docs.push_back({name + " peak overpressure", "Pa", "the greatest of all samples"});
    docs.push_back({name + " time of peak", "s", "when that was"});
    docs.push_back({name + " impulse", "Pa s", "integral of the overpressure over the run"});
  }
  return docs;
}

Gauges::Gauges(const List& scene)
    : dim_(static_cast<int>(get<std::vector<int>>(scene.sublist("grid"), "cells").size())),
      end_(get<double>(scene.sublist("time"), "end")),
      cadence_(interval_of(scene)),
      table_("time") {
  check_gauges(scene);
  const auto materials = list_names(scene.sublist("materials"));
  const List& list = scene.sublist("gauges");
  const char* const axes[] = {"x_", "y_", "z_"};
  for (const auto& name : list_names(list)) {
    const List& given = list.sublist(name);
    Window window;
    const auto place = get<std::vector<double>>(given, "place");
    std::copy(place.begin(), place.end(), window.place.begin());
    window.radius = get<double>(given, "radius");
    if (window.radius == 0) window.radius = get<double>(scene.sublist("grid"), "cell size");
    const auto material =
        std::find(materials.begin(), materials.end(), get<std::string>(given, "material"));
    if (material != materials.end())
      window.material = static_cast<int>(material - materials.begin());
    window.rides = get<bool>(given, "rides");
    any_rides_ = any_rides_ || window.rides;
    windows_.push_back(window);

    const double reference = get<double>(given, "reference pressure");
    const bool is_given = reference > not_given;
    gauges_.push_back({name, is_given ? reference : 0, is_given, get<double>(given, "arrival")});

    const std::string column = column_name(name);
    for (int d = 0; d < dim_; ++d) table_ += "," + (axes[d] + column);
    for (const char* quantity : {"pressure_", "overpressure_", "impulse_", "positive_impulse_"})
      table_ += "," + (quantity + column);
    for (int d = 0; d < dim_; ++d) table_ += ",velocity_" + (axes[d] + column);
    table_ += ",points_" + column;
  }
  table_ += "\n";
}

void Gauges::follow(Simulation& simulation) {
  const bool start = times_.empty();
  if (any_rides_ && !start) simulation.carry(windows_);
  const double time = simulation.time();
  if (cadence_.due(time) || start || time >= end_) sample(simulation);
}

void Gauges::write(const std::filesystem::path& folder, Backlog* later) const {
  write_file(folder / "gauges.csv", table_, later);
}

void Gauges::keep(Archive& archive) {
  const Archive::Part part(archive, "gauges");
  archive.keep("times", times_);
  archive.keep("table", table_);
  cadence_.keep(archive);
  for (std::size_t k = 0; k < gauges_.size(); ++k) {
    Gauge& gauge = gauges_[k];
    const Archive::Part of_gauge(archive, "gauge " + gauge.name);
    Archive::Doubles place(windows_[k].place.begin(), windows_[k].place.end());
    archive.keep("place", place);
    std::copy_n(place.begin(), std::min(place.size(), windows_[k].place.size()),
                windows_[k].place.begin());
    archive.keep("reference", gauge.reference);
    archive.keep("impulse", gauge.impulse);
    archive.keep("positive impulse", gauge.positive);
    archive.keep("overpressure", gauge.overpressure);
  }
}

void Gauges::sample(const Simulation& simulation) {
  const double time = simulation.time(), since = times_.empty() ? 0 : time - times_.back();
  const auto seen = simulation.probe(windows_);
  times_.push_back(time);
  char number[40];
  const auto add = [&](double value) {
    std::snprintf(number, sizeof number, ",%.12g", value);
    table_ += number;
  };
  std::snprintf(number, sizeof number, "%.17g", time);
  table_ += number;
  for (std::size_t k = 0; k < gauges_.size(); ++k) {
    Gauge& gauge = gauges_[k];
    gauge.add(seen[k], since);
    for (int d = 0; d < dim_; ++d) add(windows_[k].place[d]);
    for (const double value :
         {seen[k].pressure, gauge.overpressure.back(), gauge.impulse, gauge.positive})
      add(value);
    for (int d = 0; d < dim_; ++d) add(seen[k].velocity[d]);
    add(seen[k].points);
  }
  table_ += "\n";
}

/// Impulses by the trapezoidal rule. Who sees nothing feels no overpressure.
void Gauges::Gauge::add(const Seen& seen, double since) {
  if (overpressure.empty() && !reference_given) reference = seen.pressure;
  const double now = seen.points > 0 ? seen.pressure - reference : 0,
               before = overpressure.empty() ? 0 : overpressure.back();
  impulse += 0.5 * since * (before + now);
  positive += 0.5 * since * (std::max(before, 0.0) + std::max(now, 0.0));
  overpressure.push_back(now);
}

std::size_t Gauges::Gauge::peak() const {
  return std::max_element(overpressure.begin(), overpressure.end()) - overpressure.begin();
}

/// A share of a low reference alone would be reached by the foot of a shock that is spread over
/// cells, or by noise.
double Gauges::Gauge::threshold() const {
  return arrival > 0 ? arrival : arrival_share * std::max(reference, overpressure[peak()]);
}

/// Linear between samples; never: not a number.
double Gauges::Gauge::arrival_time(const std::vector<double>& times) const {
  const double level = threshold();
  const auto first = std::find_if(overpressure.begin(), overpressure.end(),
                                  [&](double p) { return p >= level && p > 0; });
  if (first == overpressure.end()) return std::nan("");
  const std::size_t k = first - overpressure.begin();
  if (k == 0) return times[0];
  const double share = (level - overpressure[k - 1]) / (overpressure[k] - overpressure[k - 1]);
  return times[k - 1] + share * (times[k] - times[k - 1]);
}

std::vector<Measure> Gauges::measures() const {
  std::vector<std::string> names;
  std::map<std::string, double> values;
  for (const Gauge& gauge : gauges_) {
    names.push_back(gauge.name);
    values[gauge.name + " arrival"] = gauge.arrival_time(times_);
    values[gauge.name + " peak overpressure"] = gauge.overpressure[gauge.peak()];
    values[gauge.name + " time of peak"] = times_[gauge.peak()];
    values[gauge.name + " impulse"] = gauge.impulse;
  }
  return with_values(measure_docs(names), values);
}

}  // namespace brisance
