#include "drivers/exact_piston_gas.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brisance {
namespace {

/// Section 4.3.2 of Hu & Chen (2006).
PistonGas::Data paper(double frame = 0) {
  return {{7850, 200e9, 0.29}, 1.2, 1e6, 1.4, 26352, 0.1, 0.05, 0.05, frame};
}

double value(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m.value;
  return std::nan("");
}

/// One particle in the middle of each cell of 0.25 mm between -6 and 156 mm.
ParticleTable table_of(const PistonGas& exact, double t, double frame) {
  ParticleTable table;
  table.cells[0] = 648;
  table.cell_size = 0.25e-3;
  table.origin[0] = -0.006 + frame * t;
  table.fields.push_back({"stress xx", "Pa", {}});
  for (int k = 0; k < 648; ++k) {
    const double x = table.layer_centre(0, k);
    const MatterState s = exact.at({x, 0, 0}, t);
    if (s.rho == 0) continue;
    const bool steel = s.rho > 1000;
    table.material.push_back(steel ? 0 : 1);
    table.x.push_back(x);
    table.vx.push_back(s.v[0]);
    table.volume.push_back(table.cell_size);
    table.mass.push_back(s.rho * table.cell_size);
    table.pressure.push_back(s.p);
    table.energy.push_back(s.e);
    const double M_over_K = 3 * (1 - 0.29) / (1 + 0.29);
    table.fields[0].values.push_back(steel ? -s.p * M_over_K : 0);
  }
  return table;
}

// To the digits of an independent solution.
TEST(PistonGas, OfThePaperHasItsPressureAndSpeeds) {
  const PistonGas exact(paper());
  EXPECT_NEAR(exact.plateau(), 1.00047e9, 5e3);
  EXPECT_NEAR(exact.interface_speed(), 26329.97, 0.05);
  EXPECT_NEAR(exact.shock_speed(), 31632.8, 0.05);
  const auto features = exact.features(1.3e-6);
  EXPECT_NEAR(value(features, "shock position"), 0.05888, 5e-6);
  EXPECT_NEAR(value(features, "interface position"), 0.06577, 5e-6);
  EXPECT_NEAR(value(features, "steel wave position"), 0.07325, 5e-6);
}

// Rankine and Hugoniot, in the frame of the shock; the wave in the steel: [s] = rho c [v].
TEST(PistonGas, KeepsMassMomentumAndEnergyOverBothWaves) {
  const PistonGas exact(paper());
  const MatterState ahead = exact.at({0.055, 0, 0}, 1.3e-6),
                    behind = exact.at({0.06, 0, 0}, 1.3e-6), steel = exact.at({0.07, 0, 0}, 1.3e-6),
                    far = exact.at({0.08, 0, 0}, 1.3e-6);
  const double D = exact.shock_speed(), u = -behind.v[0];
  EXPECT_NEAR(behind.rho * (D - u) / (ahead.rho * D), 1, 1e-12);
  EXPECT_NEAR((behind.p - ahead.p) / (ahead.rho * D * u), 1, 1e-12);
  EXPECT_NEAR((behind.e + behind.p / behind.rho + 0.5 * (D - u) * (D - u)) /
                  (ahead.e + ahead.p / ahead.rho + 0.5 * D * D),
              1, 1e-12);
  EXPECT_NEAR(steel.v[0], behind.v[0], 1e-6);
  EXPECT_NEAR(7850 * 5778.16 * (steel.v[0] - far.v[0]) / behind.p, 1, 1e-5);
}

TEST(PistonGas, FindsNoErrorInItselfInAnyFrame) {
  for (const double frame : {0., 10000.}) {
    const PistonGas exact(paper(frame));
    const auto measures = exact.measures(table_of(exact, 1.3e-6, frame), 1.3e-6);
    for (const char* name :
         {"post-shock pressure error", "L1 post-shock pressure", "overshoot", "steel stress error"})
      EXPECT_NEAR(value(measures, name), 0, 1e-12) << name;
    for (const char* name : {"interface pressure", "interface stress", "worst steel point"})
      EXPECT_NEAR(value(measures, name), 1, 1e-12) << name;
    EXPECT_NEAR(value(measures, "shock position"), 0, 0.5);  // a jump somewhere in a cell
    EXPECT_NEAR(value(measures, "interpenetration"), -0.25e-3, 1e-12);
  }
}

TEST(PistonGas, SeesASteelParticleInTheGas) {
  const PistonGas exact(paper());
  ParticleTable table = table_of(exact, 1.3e-6, 0);
  for (std::size_t k = 1; k < table.size(); ++k)
    if (table.material[k] == 0 && table.material[k - 1] == 1) table.x[k] -= 0.6e-3;
  EXPECT_NEAR(value(exact.measures(table, 1.3e-6), "interpenetration"), 0.35e-3, 1e-12);
}

TEST(PistonGas, CannotDoWithoutCompressionOrSteel) {
  PistonGas::Data slow = paper();
  slow.speed = 0.01;  // less than the gas pushes the piston back
  EXPECT_THROW(PistonGas{slow}, InputError);
  EXPECT_THROW(PistonGas(paper()).measures(ParticleTable(), 1e-6), std::runtime_error);
}

}  // namespace
}  // namespace brisance
