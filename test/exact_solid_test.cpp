#include "drivers/exact_solid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brisance {
namespace {

const PlateMatter steel{7850, 200e9, 0.29};

/// Particles in the middle of thirds of cells that have what the exact solution has.
template <class Exact>
ParticleTable exact_table(const Exact& exact, double low, double high, int cells, double t) {
  ParticleTable table;
  table.cells[0] = cells;
  table.origin[0] = low;
  table.cell_size = (high - low) / cells;
  table.fields.push_back({"stress xx", "Pa", {}});
  for (int k = 0; k < 3 * cells; ++k) {
    const double x = low + (k + 0.5) * table.cell_size / 3;
    const MatterState s = exact.at({x, 0, 0}, t);
    table.x.push_back(x);
    table.vx.push_back(s.v[0]);
    table.volume.push_back(table.cell_size / 3);
    table.mass.push_back(s.rho * table.volume.back());
    table.density.push_back(s.rho);
    table.pressure.push_back(s.p);
    table.energy.push_back(s.e);
    table.fields[0].values.push_back(exact.stress(x, t));
  }
  return table;
}

double value(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m.value;
  return std::nan("");
}

// Given in the literature for these constants: 5778 and 4497 m/s.
TEST(PlateMatter, HasTheSpeedsOfItsWaves) {
  EXPECT_NEAR(steel.wave_speed(), 5778.16, 5e-3);
  EXPECT_NEAR(steel.plastic_speed(), 4496.71, 5e-3);
}

// rho v_t = s_x and s_t = M v_x by central differences of 1e-3 of a wavelength and period: good to
// (2 pi / 4000)^2 of the rates.
TEST(StandingWave, SatisfiesTheWaveEquation) {
  const StandingWave wave(StandingWave::Data{steel, 0.1, 1, 2});
  const double T = wave.period(), dx = 1e-3, dt = 1e-3 * T;
  const auto stress = [&](double x, double t) {
    return -wave.at({x, 0, 0}, t).p * steel.constrained() / steel.bulk();
  };
  const auto v = [&](double x, double t) { return wave.at({x, 0, 0}, t).v[0]; };
  const double rate = 2 * 2 * std::acos(-1.) / T;  // of velocity
  for (const double x : {0.3, 0.8})
    for (const double t : {0.1 * T, 1.3 * T}) {
      EXPECT_NEAR(steel.density * (v(x, t + dt) - v(x, t - dt)) / (2 * dt),
                  (stress(x + dx, t) - stress(x - dx, t)) / (2 * dx), 1e-5 * steel.density * rate);
      EXPECT_NEAR((stress(x, t + dt) - stress(x, t - dt)) / (2 * dt),
                  steel.constrained() * (v(x + dx, t) - v(x - dx, t)) / (2 * dx),
                  1e-5 * steel.density * steel.wave_speed() * rate);
    }
  EXPECT_NEAR(v(0.1, 0.2 * T), 0, 1e-15);
  EXPECT_NEAR(stress(1.1, 0.2 * T), 0, 1e-6);
}

// At half of a quarter period the phase is pi / 4; a wave that runs 1 % too fast is ahead by 1 %.
TEST(StandingWave, IsMeasuredByItsPhase) {
  const StandingWave wave(StandingWave::Data{steel, 0, 1, 2});
  for (const double ahead : {0., 0.01}) {
    ParticleTable table;
    table.fields.push_back({"stress xx", "Pa", {}});
    const double t = 3.125 * wave.period();
    for (int k = 0; k < 100; ++k) {
      const double x = (k + 0.5) / 100;
      const MatterState s = wave.at({x, 0, 0}, t * (1 + ahead));
      table.x.push_back(x);
      table.vx.push_back(s.v[0]);
      table.mass.push_back(78.5);
      table.volume.push_back(0.01);
      table.fields[0].values.push_back(-s.p * steel.constrained() / steel.bulk());
    }
    const auto measures = wave.measures(table, t);
    EXPECT_NEAR(value(measures, "wave speed error"), ahead, 1e-12);
    EXPECT_NEAR(value(measures, "amplitude error"), 0, 1e-12);
  }
}

// Sound crosses the plate in T; a quarter of it moves at first. Compression comes back as tension.
TEST(PlateImpact, CompressionComesBackAsTension) {
  const PlateImpact impact(PlateImpact::Data{steel, 0, 1, 0, 0.25, 2});
  const double T = 1 / steel.wave_speed(), plateau = steel.density * steel.wave_speed();
  EXPECT_NEAR(impact.stress(0.3, 0.1 * T), -plateau, 1e-6 * plateau);
  EXPECT_EQ(impact.at({0.1, 0, 0}, 0).v[0], 2);
  EXPECT_EQ(impact.at({0.5, 0, 0}, 0).v[0], 0);
  EXPECT_NEAR(impact.stress(0.85, 1.2 * T), plateau, 1e-6 * plateau);
  EXPECT_NEAR(impact.at({0.99, 0, 0}, 0.9 * T).v[0], 2, 1e-12);  // a free end moves twice as fast
  // Momentum stays that of the quarter.
  for (const double t : {0.3, 0.9, 1.4}) {
    double sum = 0;
    for (int k = 0; k < 4000; ++k) sum += impact.at({(k + 0.5) / 4000, 0, 0}, t * T).v[0] / 4000;
    EXPECT_NEAR(sum, 0.5, 1e-3);
  }
}

TEST(PlateImpact, FindsNoErrorInItself) {
  const PlateImpact impact(PlateImpact::Data{steel, 0, 1, 0, 0.25, 2});
  const double t = 1.35 / steel.wave_speed();
  const auto measures = impact.measures(exact_table(impact, 0, 1, 200, t), t);
  EXPECT_NEAR(value(measures, "L1 velocity"), 0, 1e-12);
  EXPECT_NEAR(value(measures, "L1 stress"), 0, 1e-12);
  EXPECT_NEAR(value(measures, "greatest tension"), 1, 1e-12);
  EXPECT_NEAR(value(measures, "tension front"), 0, 0.51);  // a jump somewhere in a cell
}

TEST(PlasticWave, HasTheElasticLimitOfHugoniot) {
  const PlasticWave wave(PlasticWave::Data{steel, 500e6, 40, 0});
  EXPECT_NEAR(wave.elastic_limit(), 845.2e6, 1e5);
  // Jumps of mass and momentum over both fronts, in the matter: [s] = rho c [v].
  const double t = 1e-5;
  const double between = 0.5 * (4497 + 5778 - 40) * t;
  EXPECT_NEAR(wave.stress(between, t) - wave.stress(0.01, t),
              steel.density * steel.plastic_speed() *
                  (wave.at({0.01, 0, 0}, t).v[0] - wave.at({between, 0, 0}, t).v[0]),
              1);
  EXPECT_NEAR(-wave.stress(between, t),
              steel.density * steel.wave_speed() * (wave.at({between, 0, 0}, t).v[0] + 40), 1);
  EXPECT_THROW(PlasticWave(PlasticWave::Data{steel, 500e6, 10, 0}), InputError);
}

TEST(PlasticWave, FindsNoErrorInItself) {
  const PlasticWave wave(PlasticWave::Data{steel, 500e6, 40, 0});
  const double t = 1.5e-5;
  const auto measures = wave.measures(exact_table(wave, 0, 0.1, 400, t), t);
  EXPECT_NEAR(value(measures, "L1 stress"), 0, 1e-12);
  EXPECT_NEAR(value(measures, "elastic limit error"), 0, 1e-12);
  // Half a cell of 0.25 mm over ways of 67 and 86 mm.
  EXPECT_NEAR(value(measures, "precursor speed error"), 0, 2e-3);
  EXPECT_NEAR(value(measures, "plastic wave speed error"), 0, 2e-3);
}

TEST(SolidMeasures, NeedASolid) {
  const PlateImpact impact(PlateImpact::Data{steel, 0, 1, 0, 0.25, 2});
  EXPECT_THROW(impact.measures(ParticleTable(), 1e-4), std::runtime_error);
}

}  // namespace
}  // namespace brisance
