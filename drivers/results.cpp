#include "drivers/results.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "drivers/files.hpp"
#include "drivers/input.hpp"
#include "version.hpp"

namespace brisance {
namespace {

std::vector<double> interleaved(const std::vector<double>& x, const std::vector<double>& y,
                                const std::vector<double>& z) {
  std::vector<double> all;
  all.reserve(3 * x.size());
  for (std::size_t k = 0; k < x.size(); ++k) all.insert(all.end(), {x[k], y[k], z[k]});
  return all;
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

/// A number as JSON has it: null for what is not finite.
nlohmann::json json(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

}  // namespace

Results::Results(const std::filesystem::path& folder, const List& scene, const Ledger& ledger)
    : folder_(folder),
      scene_(scene.name()),
      title_(get<std::string>(scene, "title")),
      geometry_(get<std::string>(scene, "geometry")),
      cell_size_(get<double>(scene.sublist("grid"), "cell size")),
      particles_(get<bool>(scene.sublist("output"), "particles")),
      grid_(get<bool>(scene.sublist("output"), "grid")),
      particle_series_(folder / "particles.pvd"),
      grid_series_(folder / "grid.pvd"),
      history_(ledger.head()) {
  make_folder(folder_);
  write_input(scene, (folder_ / "input.xml").string(),
              "The complete input of this run, defaults included. brisance " +
                  std::string(version::number));
}

std::string Results::numbered(const std::string& name) const {
  char number[16];
  std::snprintf(number, sizeof number, "_%06zu",
                name == "grid" ? grid_series_.entries().size() : particle_series_.entries().size());
  return name + number + (name == "grid" ? ".vti" : ".vtp");
}

void Results::add(const Snapshot& shot) {
  const ParticleTable& t = shot.table;
  if (particles_) {
    std::vector<vtk::Column> columns = {
        vtk::Column("velocity", 3, interleaved(t.vx, t.vy, t.vz)),
        vtk::Column("mass", t.mass),
        vtk::Column("volume", t.volume),
        vtk::Column("density", t.density),
        vtk::Column("pressure", t.pressure),
        vtk::Column("energy", t.energy),
        vtk::Column("material", std::vector<std::int32_t>(t.material.begin(), t.material.end())),
        vtk::Column("id", shot.id)};
    for (const auto& field : t.fields) columns.emplace_back(field.name, field.values);
    const std::string file = numbered("particles");
    vtk::write_vtp(folder_ / file, interleaved(t.x, t.y, t.z), columns);
    particle_series_.add(shot.time, folder_ / file);
  }
  if (grid_) {
    const auto sums = sums_per_cell(t);
    std::vector<double> fill, density, pressure, energy, velocity;
    double cell = 1;
    for (int d = 0; d < t.dim; ++d) cell *= t.cell_size;
    for (const Sums& s : sums) {
      const bool empty = s.empty();
      fill.push_back(s.volume / cell);
      density.push_back(empty ? 0 : s.mean_density());
      pressure.push_back(empty ? 0 : s.mean_pressure());
      energy.push_back(empty ? 0 : s.mean_energy());
      for (const double v : empty ? std::array<double, 3>{} : s.mean_velocity())
        velocity.push_back(v);
    }
    const std::string file = numbered("grid");
    vtk::write_vti(folder_ / file, box_of(t), {},
                   {vtk::Column("fill", fill), vtk::Column("density", density),
                    vtk::Column("pressure", pressure), vtk::Column("energy", energy),
                    vtk::Column("velocity", 3, velocity)});
    grid_series_.add(shot.time, folder_ / file);
  }
}

void Results::add(const Ledger& ledger, const Balance& balance) {
  note(ledger, balance);
  write_file(folder_ / "history.csv", history_);
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
  write_file(folder_ / "exact.csv", text);
}

void Results::write_summary(const Outcome& outcome, const Ledger& ledger, const Balance& b) {
  nlohmann::ordered_json j;
  j["scene"] = scene_;
  j["title"] = title_;
  j["geometry"] = geometry_;
  j["cell_size"] = cell_size_;
  j["version"] = version::number;
  j["commit"] = version::commit;
  j["status"] = outcome.status;
  j["steps"] = b.step;
  j["time"] = b.time;
  j["particles"] = b.particles;
  j["wall_seconds"] = json(outcome.wall_seconds);
  j["cpu_seconds"] = json(outcome.cpu_seconds);
  j["particle_steps_per_second"] = json(outcome.particle_steps / outcome.wall_seconds);
  if (outcome.asleep) {
    j["asleep"] = json(outcome.share_asleep());
    j["asleep_impulse"] = json(outcome.asleep->impulse);
  }
  j["mass_error"] = json(ledger.mass_error(b));
  j["momentum_error"] = json(ledger.momentum_error(b));
  j["energy_error"] = json(ledger.energy_error(b));
  j["floors"] = b.floors;
  j["outflow_mass"] = json(b.outflow.mass);
  for (const Measure& m : outcome.measures)
    j["measures"][m.name] = {{"value", json(m.value)}, {"unit", m.unit}};
  j["checks"] = nlohmann::ordered_json::array();
  for (const Verdict& v : outcome.verdicts)
    j["checks"].push_back({{"quantity", v.quantity},
                           {"value", json(v.measured)},
                           {"unit", v.unit},
                           {"limit", v.limit()},
                           {"verdict", v.reached() ? "reached" : "missed"}});
  write_file(folder_ / "summary.json", j.dump(2) + "\n");
}

}  // namespace brisance
