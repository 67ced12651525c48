#include "drivers/ledger.hpp"

#include <cctype>
#include <cmath>
#include <cstdio>

#include "drivers/archive_state.hpp"

namespace brisance {
namespace {

double ratio(double error, double scale) { return scale > 0 ? error / scale : error; }

}  // namespace

Ledger::Ledger(const Balance& start)
    : start_(start.totals),
      springs_(start.springs.value_or(0)),
      sprung_(start.springs.has_value()) {
  for (const auto& m : start.materials) {
    materials_.push_back(m.name);
    solids_ = solids_ || m.solid;
  }
}

void Ledger::keep(Archive& archive) {
  const Archive::Part part(archive, "start");
  brisance::keep(archive, "totals", start_);
  archive.keep("springs", springs_);
}

double Ledger::mass_error(const Balance& now) const {
  return ratio(now.totals.mass + now.outflow.mass - start_.mass, start_.mass);
}

double Ledger::momentum_error(const Balance& now) const {
  double sum = 0;
  for (int d = 0; d < 3; ++d) {
    const double missing =
        now.totals.momentum[d] + now.outflow.momentum[d] + now.wall_impulse[d] - start_.momentum[d];
    sum += missing * missing;
  }
  return ratio(std::sqrt(sum), std::sqrt(2 * start_.mass * start_.total()));
}

double Ledger::energy_error(const Balance& now) const {
  const double before = start_.total() + springs_;
  return ratio(now.totals.total() + now.outflow.total() + now.springs.value_or(0) - before, before);
}

std::string column_name(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

std::vector<MeasureDoc> balance_measures(const std::vector<std::string>& materials, bool solids) {
  std::vector<MeasureDoc> docs = {
      {"mass error", "-", "mass gained, over the mass at the start"},
      {"momentum error", "-",
       "size of the momentum gained beyond what walls gave, over sqrt(2 mass energy)"},
      {"energy error", "-", "total energy gained, over that at the start"},
      {"floors", "-", "how often an energy was held at its lower bound"}};
  for (const char* axis : {"x", "y"})
    docs.push_back({std::string(axis) + " impulse on walls", "N s",
                    "momentum that walls have taken, per metre or square metre"});
  for (const auto& name : materials) {
    for (const char* axis : {"x", "y"})
      docs.push_back({std::string(axis) + " velocity of " + name, "m/s",
                      "mean by mass, of what is inside the grid"});
    docs.push_back({"mean speed of " + name, "m/s", "mean by mass, whatever the direction"});
    for (const char* kind : {"kinetic", "internal"})
      docs.push_back({std::string(kind) + " energy of " + name, "J",
                      "of what is inside the grid, per metre or square metre"});
  }
  if (solids) {
    docs.push_back({"mechanical energy", "-",
                    "kinetic and elastic energy, over the total energy at the start"});
    for (const char* kind : {"plastic", "damage", "decohesion"})
      docs.push_back({std::string(kind) + " energy", "J", "dissipated, per metre or square metre"});
  }
  return docs;
}

std::vector<Measure> Ledger::measures(const Balance& now) const {
  const Energies& work = now.totals.work;
  std::map<std::string, double> values = {
      {"mass error", mass_error(now)},
      {"momentum error", momentum_error(now)},
      {"energy error", energy_error(now)},
      {"floors", static_cast<double>(now.floors)},
      {"x impulse on walls", now.wall_impulse[0]},
      {"y impulse on walls", now.wall_impulse[1]},
      {"mechanical energy", ratio(now.totals.kinetic + work.elastic, start_.total())},
      {"plastic energy", work.plastic},
      {"damage energy", work.damage},
      {"decohesion energy", work.decohesion}};
  for (const auto& m : now.materials) {
    const Totals& t = m.totals;
    values["x velocity of " + m.name] = ratio(t.momentum[0], t.mass);
    values["y velocity of " + m.name] = ratio(t.momentum[1], t.mass);
    values["mean speed of " + m.name] = ratio(t.motion, t.mass);
    values["kinetic energy of " + m.name] = t.kinetic;
    values["internal energy of " + m.name] = t.internal;
  }
  return with_values(balance_measures(materials_, solids_), values);
}

std::string Ledger::departures(const Balance& now) const {
  char text[120];
  std::snprintf(text, sizeof text, "left the grid: %ld particles with %.3g kg, %.3g %% of all",
                now.left, now.outflow.mass, 100 * ratio(now.outflow.mass, start_.mass));
  return text;
}

std::string Ledger::head() const {
  std::string text =
      "step,time,dt,particles,mass,momentum_x,momentum_y,momentum_z,kinetic,internal,total,"
      "mass_error,momentum_error,energy_error,outflow_mass,"
      "outflow_particles,outflow_momentum_x,outflow_momentum_y,outflow_momentum_z,"
      "outflow_kinetic,outflow_internal,wall_impulse_x,wall_impulse_y,wall_impulse_z";
  if (solids_) text += ",elastic,plastic,damage,decohesion";
  for (const auto& name : materials_)
    for (const char* quantity :
         {"mass_", "momentum_x_", "momentum_y_", "momentum_z_", "absolute_momentum_x_",
          "absolute_momentum_y_", "absolute_momentum_z_", "kinetic_", "internal_"})
      text += "," + (quantity + column_name(name));
  if (sprung_) text += ",springs";
  return text + "\n";
}

std::string Ledger::line(const Balance& b) const {
  const Totals& t = b.totals;
  std::string text = std::to_string(b.step);
  const auto add = [&](const char* format, double value) {
    char number[40];
    std::snprintf(number, sizeof number, format, value);
    text += number;
  };
  for (const double value : {b.time, b.dt}) add(",%.17g", value);
  text += "," + std::to_string(b.particles);
  for (const double value :
       {t.mass, t.momentum[0], t.momentum[1], t.momentum[2], t.kinetic, t.internal, t.total()})
    add(",%.17g", value);
  for (const double value : {mass_error(b), momentum_error(b), energy_error(b)})
    add(",%.6g", value);
  add(",%.17g", b.outflow.mass);
  text += "," + std::to_string(b.left);
  for (const double value :
       {b.outflow.momentum[0], b.outflow.momentum[1], b.outflow.momentum[2], b.outflow.kinetic,
        b.outflow.internal, b.wall_impulse[0], b.wall_impulse[1], b.wall_impulse[2]})
    add(",%.17g", value);
  if (solids_)
    for (const double value : {t.work.elastic, t.work.plastic, t.work.damage, t.work.decohesion})
      add(",%.17g", value);
  for (const auto& m : b.materials)
    for (const double value :
         {m.totals.mass, m.totals.momentum[0], m.totals.momentum[1], m.totals.momentum[2],
          m.totals.absolute_momentum[0], m.totals.absolute_momentum[1],
          m.totals.absolute_momentum[2], m.totals.kinetic, m.totals.internal})
      add(",%.17g", value);
  if (sprung_) add(",%.17g", *b.springs);
  return text + "\n";
}

}  // namespace brisance
