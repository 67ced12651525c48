#include <cmath>

#include "drivers/exact.hpp"

namespace brisance {
namespace {

// Sums over the particles, weighted by volume: how far they are from the exact solution, and how
// far that is from the undisturbed gas.
struct Deviation {
  double density = 0, velocity = 0, pressure = 0, energy = 0;

  void add(double volume, const MatterState& a, const MatterState& b) {
    density += volume * std::abs(a.rho - b.rho);
    velocity += volume * std::hypot(a.v[0] - b.v[0], a.v[1] - b.v[1], a.v[2] - b.v[2]);
    pressure += volume * std::abs(a.p - b.p);
    energy += volume * std::abs(a.e - b.e);
  }
};

struct Deviations {
  Deviation error, signal;
  double volume = 0;
};

Deviations deviations(const ParticleTable& table, const ExactSolution& exact,
                      const MatterState& undisturbed, double t) {
  Deviations sums;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const MatterState here = exact.at(table.place(k), t);
    const MatterState particle{table.density[k], table.pressure[k], table.energy[k],
                               table.motion(k)};
    sums.error.add(table.volume[k], particle, here);
    sums.signal.add(table.volume[k], here, undisturbed);
    sums.volume += table.volume[k];
  }
  return sums;
}

std::vector<MeasureDoc> disturbance_measures(const std::string& what) {
  const std::string over = "error over the particles, weighted by volume, over ";
  return {{"L1 density", "-", over + "the density's departure from " + what},
          {"L1 velocity", "-", over + "the velocity's departure from " + what}};
}

std::vector<Measure> disturbance_values(const std::vector<MeasureDoc>& docs, const Deviations& d) {
  return with_values(docs, {{"L1 density", relative(d.error.density, d.signal.density)},
                            {"L1 velocity", relative(d.error.velocity, d.signal.velocity)}});
}

}  // namespace

std::vector<MeasureDoc> AcousticWave::possible_measures() {
  return disturbance_measures("the undisturbed gas");
}

std::vector<Measure> AcousticWave::measures(const ParticleTable& table, double t) const {
  MatterState undisturbed{data_.density, data_.pressure, 0, {}};
  undisturbed.v[data_.direction] = data_.velocity;
  return disturbance_values(possible_measures(), deviations(table, *this, undisturbed, t));
}

std::vector<MeasureDoc> Vortex::possible_measures() {
  return disturbance_measures("the gas far away");
}

std::vector<Measure> Vortex::measures(const ParticleTable& table, double t) const {
  const MatterState undisturbed{data_.density, data_.pressure, 0, data_.velocity};
  return disturbance_values(possible_measures(), deviations(table, *this, undisturbed, t));
}

std::vector<MeasureDoc> Uniform::possible_measures() {
  const std::string over = "error over the particles, weighted by volume, over the exact ";
  return {{"L1 density", "-", over + "density"},
          {"L1 velocity", "-", over + "speed of sound"},
          {"L1 pressure", "-", over + "pressure"},
          {"L1 energy", "-", over + "specific energy"}};
}

std::vector<Measure> Uniform::measures(const ParticleTable& table, double t) const {
  const MatterState exact = at({}, t);
  const Deviations d = deviations(table, *this, exact, t);
  const double sound = std::sqrt(data_.gamma * data_.pressure / data_.density);
  return with_values(possible_measures(),
                     {{"L1 density", relative(d.error.density, d.volume * exact.rho)},
                      {"L1 velocity", relative(d.error.velocity, d.volume * sound)},
                      {"L1 pressure", relative(d.error.pressure, d.volume * exact.p)},
                      {"L1 energy", relative(d.error.energy, d.volume * exact.e)}});
}

}  // namespace brisance
