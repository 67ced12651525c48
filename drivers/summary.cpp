#include "drivers/summary.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "version.hpp"

namespace brisance {
namespace {

using Json = nlohmann::ordered_json;

/// A number as JSON has it: null for what is not finite.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json model_of(const List& scene, const Balance& b) {
  Json model;
  model["preset"] = get<std::string>(scene, "preset");
  model["cells"] = get<std::vector<int>>(scene.sublist("grid"), "cells");
  model["materials"] = Json::array();
  for (const auto& material : b.materials) {
    const List& given = scene.sublist("materials").sublist(material.name);
    model["materials"].push_back({{"name", material.name},
                                  {"law", get<std::string>(given, "law")},
                                  {"particles", material.particles},
                                  {"mass", number(material.totals.mass)}});
  }
  return model;
}

Json rows_of(const std::vector<TimeRow>& rows, double all) {
  Json list = Json::array();
  for (const TimeRow& row : rows)
    list.push_back({{"name", row.name},
                    {"seconds", number(row.seconds)},
                    {"share", number(row.seconds / all)},
                    {"calls", std::round(row.calls)}});
  return list;
}

}  // namespace

std::string summary_text(const List& scene, const Outcome& outcome, const Ledger& ledger,
                         const Balance& b) {
  Json j;
  j["scene"] = scene.name();
  j["title"] = get<std::string>(scene, "title");
  j["geometry"] = get<std::string>(scene, "geometry");
  j["cell_size"] = get<double>(scene.sublist("grid"), "cell size");
  j["version"] = version::number;
  j["commit"] = version::commit;
  j["model"] = model_of(scene, b);
  j["status"] = outcome.status;
  j["steps"] = b.step;
  j["time"] = b.time;
  j["particles"] = b.particles;
  j["wall_seconds"] = number(outcome.wall_seconds);
  j["cpu_seconds"] = number(outcome.cpu_seconds);
  j["particle_steps_per_second"] = number(outcome.particle_steps / outcome.wall_seconds);
  const TimeSpent& spent = outcome.spent;
  j["time_spent"] = {{"seconds", number(spent.seconds)},
                     {"since_restart", outcome.resumed},
                     {"parts", rows_of(spent.parts, spent.seconds)},
                     {"kernels", rows_of(spent.kernels, spent.seconds)},
                     {"measured_steps", spent.measured_steps}};
  if (outcome.asleep) {
    j["asleep"] = number(outcome.share_asleep());
    j["asleep_impulse"] = number(outcome.asleep->impulse);
  }
  j["mass_error"] = number(ledger.mass_error(b));
  j["momentum_error"] = number(ledger.momentum_error(b));
  j["energy_error"] = number(ledger.energy_error(b));
  j["floors"] = b.floors;
  j["outflow_mass"] = number(b.outflow.mass);
  for (const Measure& m : outcome.measures)
    j["measures"][m.name] = {{"value", number(m.value)}, {"unit", m.unit}};
  j["checks"] = Json::array();
  for (const Verdict& v : outcome.verdicts)
    j["checks"].push_back({{"quantity", v.quantity},
                           {"value", number(v.measured)},
                           {"unit", v.unit},
                           {"limit", v.limit()},
                           {"verdict", v.reached() ? "reached" : "missed"}});
  return j.dump(2) + "\n";
}

}  // namespace brisance
