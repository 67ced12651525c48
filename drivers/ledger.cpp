#include "drivers/ledger.hpp"

#include <cmath>
#include <cstdio>

namespace brisance {
namespace {

double ratio(double error, double scale) { return scale > 0 ? error / scale : error; }

}  // namespace

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
  return ratio(now.totals.total() + now.outflow.total() - start_.total(), start_.total());
}

std::vector<MeasureDoc> conservation_measures() {
  return {{"mass error", "-", "mass gained, over the mass at the start"},
          {"momentum error", "-",
           "size of the momentum gained beyond what walls gave, over sqrt(2 mass energy)"},
          {"energy error", "-", "total energy gained, over that at the start"},
          {"floors", "-", "how often an energy was held at its lower bound"}};
}

std::vector<Measure> Ledger::measures(const Balance& now) const {
  return with_values(conservation_measures(), {{"mass error", mass_error(now)},
                                               {"momentum error", momentum_error(now)},
                                               {"energy error", energy_error(now)},
                                               {"floors", static_cast<double>(now.floors)}});
}

std::string Ledger::head() {
  return "step,time,dt,particles,mass,momentum_x,momentum_y,momentum_z,kinetic,internal,total,mass_"
         "error,"
         "momentum_error,energy_error,outflow_mass,wall_impulse_x,wall_impulse_y,wall_impulse_z\n";
}

std::string Ledger::line(const Balance& b) const {
  char text[1024];
  std::snprintf(text, sizeof text,
                "%ld,%.17g,%.17g,%ld,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.6g,%.6g,%.6g,%."
                "17g,%.17g,%.17g,"
                "%.17g\n",
                b.step, b.time, b.dt, b.particles, b.totals.mass, b.totals.momentum[0],
                b.totals.momentum[1], b.totals.momentum[2], b.totals.kinetic, b.totals.internal,
                b.totals.total(), mass_error(b), momentum_error(b), energy_error(b), b.outflow.mass,
                b.wall_impulse[0], b.wall_impulse[1], b.wall_impulse[2]);
  return text;
}

}  // namespace brisance
