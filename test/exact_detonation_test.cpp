#include "drivers/exact_detonation.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "test/explosive.hpp"

namespace brisance {
namespace {

Detonation tnt(double wall = 0) {
  return Detonation(Detonation::Data{Jwl(check(test::tnt(), Jwl::valid_parameters())), wall});
}

double value(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m.value;
  return std::nan("");
}

/// One particle in each of `cells` cells that has what the solution has there, its pressure times
/// `factor`, over a slab of 0.1 m.
ParticleTable table_of(const Detonation& exact, int cells, double t, double factor = 1) {
  ParticleTable table;
  table.cells[0] = cells;
  table.cell_size = 0.1 / cells;
  for (int k = 0; k < cells; ++k) {
    const MatterState s = exact.at({table.layer_centre(0, k), 0, 0}, t);
    table.x.push_back(table.layer_centre(0, k));
    table.vx.push_back(s.v[0]);
    table.volume.push_back(table.cell_size);
    table.mass.push_back(s.rho * table.cell_size);
    table.pressure.push_back(factor * s.p);
    table.energy.push_back(s.e);
  }
  return table;
}

// To the digits of a reference that integrates the isentrope on its own.
TEST(Detonation, OfTntHasItsFrontFanAndPlateau) {
  const Detonation exact = tnt();
  EXPECT_NEAR(exact.chapman_jouguet().D, 6929.66, 0.005);
  EXPECT_NEAR(exact.plateau(), 5.643e9, 5e5);
  EXPECT_NEAR(exact.tail_speed(), 3615, 0.5);
}

// The front is sonic, so that the fan begins at it.
TEST(Detonation, JoinsItsParts) {
  const Detonation exact = tnt(0.01);
  const double t = 1e-5, front = 0.01 + exact.chapman_jouguet().D * t;
  EXPECT_NEAR(exact.at({front - 1e-9, 0, 0}, t).p / exact.chapman_jouguet().p, 1, 1e-5);
  EXPECT_NEAR(exact.at({front - 1e-9, 0, 0}, t).v[0], exact.chapman_jouguet().u, 0.1);
  EXPECT_EQ(exact.at({front + 1e-9, 0, 0}, t).p, 0);
  EXPECT_EQ(exact.at({front + 1e-9, 0, 0}, t).e, 6e9 / 1630);
  const double tail = 0.01 + exact.tail_speed() * t;
  EXPECT_NEAR(exact.at({tail + 1e-9, 0, 0}, t).p / exact.plateau(), 1, 1e-5);
  EXPECT_EQ(exact.at({tail - 1e-9, 0, 0}, t).v[0], 0);
}

// What the front has swept, by the midpoint rule over 20000 cells: the jumps lie within one of
// them.
TEST(Detonation, KeepsMassMomentumAndEnergy) {
  const Detonation exact = tnt();
  const double t = 1.2e-5, length = 0.09, h = length / 20000;
  double mass = 0, momentum = 0, energy = 0;
  for (int k = 0; k < 20000; ++k) {
    const MatterState s = exact.at({(k + 0.5) * h, 0, 0}, t);
    mass += h * s.rho;
    momentum += h * s.rho * s.v[0];
    energy += h * s.rho * (s.e + 0.5 * s.v[0] * s.v[0]);
  }
  EXPECT_NEAR(mass / (1630 * length), 1, 1e-4);
  EXPECT_NEAR(momentum / (exact.plateau() * t), 1, 3e-4);  // what the wall has given
  EXPECT_NEAR(energy / (6e9 * length), 1, 1e-4);
}

// A front known to a cell, over 2000 cells of which it has crossed 1940.
TEST(Detonation, FindsNoErrorInItself) {
  const Detonation exact = tnt();
  const auto measures = exact.measures(table_of(exact, 2000, 1.4e-5), 1.4e-5);
  EXPECT_NEAR(value(measures, "detonation speed error"), 0, 0.5 / 1940);
  EXPECT_NEAR(value(measures, "L1 fan"), 0, 1e-12);
  EXPECT_NEAR(value(measures, "plateau error"), 0, 1e-12);
  EXPECT_NEAR(value(measures, "L1 plateau"), 0, 1e-12);
  EXPECT_NEAR(value(measures, "peak error"), 0, 2e-3);
}

TEST(Detonation, MeasuresByHowMuchPressuresAreOff) {
  const Detonation exact = tnt();
  const auto measures = exact.measures(table_of(exact, 2000, 1.4e-5, 1.02), 1.4e-5);
  EXPECT_NEAR(value(measures, "L1 fan"), 0.02, 1e-12);
  EXPECT_NEAR(value(measures, "plateau error"), 0.02, 1e-12);
  EXPECT_NEAR(value(measures, "L1 plateau"), 0.02, 1e-12);
  EXPECT_NEAR(value(measures, "peak error"), 0.02, 2e-3);
  EXPECT_NEAR(value(measures, "peak of points error"), 0.02, 2e-3);
}

// A run that is 0.1 % late in everything.
TEST(Detonation, MeasuresASlowFront) {
  const Detonation exact = tnt();
  const auto measures = exact.measures(table_of(exact, 2000, 1.4e-5 * 0.999), 1.4e-5);
  EXPECT_NEAR(value(measures, "detonation speed error"), -1e-3, 0.5 / 1940);
  EXPECT_NEAR(value(measures, "front position"), -1.94, 0.5);
}

}  // namespace
}  // namespace brisance
