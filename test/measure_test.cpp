#include "drivers/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "drivers/exact.hpp"

namespace brisance {
namespace {

// Particles in regular rows, `per_cell` to a cell and direction, in the exact state of their place.
ParticleTable sampled(const ExactSolution& exact, double t, int dim, int cells, int per_cell,
                      double low, double high) {
  ParticleTable table;
  table.dim = dim;
  table.cell_size = (high - low) / cells;
  const double spacing = table.cell_size / per_cell;
  const int n = cells * per_cell;
  for (int d = 0; d < dim; ++d) {
    table.cells[d] = cells;
    table.origin[d] = low;
  }
  for (int j = 0; j < (dim > 1 ? n : 1); ++j)
    for (int i = 0; i < n; ++i) {
      const Place x{low + (i + 0.5) * spacing, dim > 1 ? low + (j + 0.5) * spacing : 0, 0};
      const MatterState gas = exact.at(x, t);
      const double volume = std::pow(spacing, dim);
      table.x.push_back(x[0]);
      table.vx.push_back(gas.v[0]);
      if (dim > 1) {
        table.y.push_back(x[1]);
        table.vy.push_back(gas.v[1]);
      }
      table.mass.push_back(gas.rho * volume);
      table.volume.push_back(volume);
      table.density.push_back(gas.rho);
      table.pressure.push_back(gas.p);
      table.energy.push_back(gas.e);
    }
  return table;
}

double value_of(const std::string& name, const ExactSolution& exact, const ParticleTable& table,
                double t) {
  for (const Measure& m : exact.measures(table, t))
    if (m.name == name) return m.value;
  throw std::runtime_error("no measure named " + name);
}

const Riemann::Data strong{{1, 0, 1}, {0.125, 0, 0.001}, 1.4, 0.5};
constexpr double t_strong = 0.143;

Riemann::Data mirrored(Riemann::Data data) {
  std::swap(data.left, data.right);
  data.left.u *= -1;
  data.right.u *= -1;
  data.interface = 1 - data.interface;
  return data;
}

TEST(TubeMeasuresTest, ExactParticlesHaveNoError) {
  const Riemann exact(strong);
  // 20 particles a cell are the very points of which the exact means are made.
  const ParticleTable table = sampled(exact, t_strong, 1, 200, 20, 0, 1);
  for (const char* name : {"L1 density", "L1 velocity", "L1 pressure", "L1 energy", "fan noise",
                           "contact overshoot", "energy overshoot"})
    EXPECT_NEAR(value_of(name, exact, table, t_strong), 0, 1e-13) << name;
}

TEST(TubeMeasuresTest, PlantedErrorsOfTheFieldsAreReported) {
  const Riemann exact(strong);
  const ParticleTable table = sampled(exact, t_strong, 1, 200, 20, 0, 1);
  ParticleTable heavy = table, hot = table, pressed = table, fast = table;
  for (double& m : heavy.mass) m *= 1.01;
  for (double& e : hot.energy) e *= 0.98;
  for (double& p : pressed.pressure) p *= 1.03;
  for (double& v : fast.vx) v *= 1.04;
  EXPECT_NEAR(value_of("L1 density", exact, heavy, t_strong), 0.01, 1e-12);
  EXPECT_NEAR(value_of("L1 energy", exact, hot, t_strong), 0.02, 1e-12);
  EXPECT_NEAR(value_of("L1 pressure", exact, pressed, t_strong), 0.03, 1e-12);
  EXPECT_NEAR(value_of("L1 velocity", exact, fast, t_strong), 0.04, 1e-12);
  EXPECT_NEAR(value_of("L1 density", exact, fast, t_strong), 0, 1e-12);
}

TEST(TubeMeasuresTest, AnEmptyCellIsWhollyWrong) {
  const Riemann still(Riemann::Data{{2, 3, 1}, {2, 3, 1}, 1.4, 0.5});
  ParticleTable table = sampled(still, 0.1, 1, 10, 1, 0, 1);
  table.mass[4] = table.volume[4] = 0;
  for (const char* name : {"L1 density", "L1 velocity", "L1 pressure", "L1 energy"})
    EXPECT_NEAR(value_of(name, still, table, 0.1), 0.1, 1e-14);
}

TEST(TubeMeasuresTest, OnlyTheMeasuredRegionAndCellsWithMatterCount) {
  Riemann::Data data{{1, 0, 1}, {0, 0, 0}, 1.4, 0.5};
  const Riemann open(data);
  ParticleTable table = sampled(open, 0.05, 1, 100, 20, 0, 1);  // no matter beyond x = 0.796
  EXPECT_NEAR(value_of("L1 density", open, table, 0.05), 0, 1e-13);
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table.x[k] < 0.25) table.mass[k] = table.volume[k] = 0;
  EXPECT_GT(value_of("L1 density", open, table, 0.05), 0.4);
  data.measured_from = 0.25;
  EXPECT_NEAR(value_of("L1 density", Riemann(data), table, 0.05), 0, 1e-13);
}

// A straight ramp of four cells in place of a jump, its middle `shift` cells ahead of the exact
// shock. The two cells around the middle lie within it, so that their means and the line between
// them are exact.
ParticleTable with_ramp(const Riemann& exact, double t, int k, double shift) {
  ParticleTable table = sampled(exact, t, 1, 200, 4, 0, 1);
  const double sign = k == 0 ? -1 : 1, h = table.cell_size;
  const double middle = exact.position(exact.wave(k).head, t) + sign * shift * h;
  const double ahead = exact.sample(exact.wave(k).head + sign).p, behind = exact.star_pressure();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double from_middle = sign * (table.x[i] - middle) / h;
    if (std::abs(from_middle) > 8) continue;
    const double share = std::max(0., std::min(1., 0.5 - from_middle / 4));
    table.pressure[i] = ahead + share * (behind - ahead);
  }
  return table;
}

TEST(TubeMeasuresTest, AShiftedShockIsReportedInCells) {
  for (const double shift : {-2., -0.37, 0., 0.25, 1.13}) {
    const Riemann right(strong), left(mirrored(strong));
    EXPECT_NEAR(value_of("shock position", right, with_ramp(right, t_strong, 1, shift), t_strong),
                shift, 1e-9);
    EXPECT_NEAR(value_of("shock position", left, with_ramp(left, t_strong, 0, shift), t_strong),
                shift, 1e-9);
  }
}

TEST(TubeMeasuresTest, OfTwoShocksTheWorseIsReported) {
  const Riemann exact(Riemann::Data{{1, 1, 1e-3}, {1, -1, 1e-3}, 1.4, 0.5});
  EXPECT_NEAR(value_of("shock position", exact, with_ramp(exact, 0.4, 0, -0.6), 0.4), -0.6, 1e-9);
}

TEST(TubeMeasuresTest, ASharpShockIsFoundWithinATenthOfACell) {
  // The line between the means of two cells, one of them cut by the jump at a fraction f of it,
  // passes half the jump up to (3 - 2 sqrt 2) / 2 = 0.086 of a cell from it; 20 particles a cell
  // know f to 1/40.
  const Riemann exact(strong);
  for (double t = 0.1; t < 0.2; t += 0.0071) {
    const ParticleTable table = sampled(exact, t, 1, 200, 20, 0, 1);
    EXPECT_NEAR(value_of("shock position", exact, table, t), 0, 0.086 + 0.025);
  }
}

TEST(TubeMeasuresTest, ALostShockHasNotMoved) {
  const Riemann exact(strong);
  ParticleTable table = sampled(exact, t_strong, 1, 200, 2, 0, 1);
  for (double& p : table.pressure) p = 0.001;
  EXPECT_NEAR(value_of("shock position", exact, table, t_strong), -0.203534 / 0.005, 1e-4 / 0.005);
}

TEST(TubeMeasuresTest, FanNoiseSeesScatterButNoShift) {
  for (const Riemann::Data& data : {strong, mirrored(strong)}) {
    const Riemann exact(data);
    const ParticleTable table = sampled(exact, t_strong, 1, 200, 20, 0, 1);
    ParticleTable shifted = table, scattered = table;
    const double jump = exact.star_velocity();
    for (std::size_t k = 0; k < table.size(); ++k) {
      shifted.vx[k] += 0.05 * jump;
      scattered.vx[k] += (k % 2 ? 0.01 : -0.01) * jump;
    }
    EXPECT_NEAR(value_of("fan noise", exact, shifted, t_strong), 0, 1e-13);
    // The running mean of some 60 alternating values is up to 1/60 of one of them, of 30 at the
    // ends 1/30.
    EXPECT_NEAR(value_of("fan noise", exact, scattered, t_strong), 0.01, 0.01 / 30);
  }
}

TEST(TubeMeasuresTest, OvershootIsSoughtAroundTheContactAndNotInTheFan) {
  const Riemann exact(strong);
  ParticleTable table = sampled(exact, t_strong, 1, 200, 4, 0, 1);
  const auto at = [](double x) { return static_cast<std::size_t>(x * 800); };
  table.pressure[at(0.54)] *= 1.5;  // the rounded corner of the fan
  table.pressure[at(0.66)] = 1.07 * exact.star_pressure();
  table.energy[at(0.68)] = 1.2 * 1.6024857;  // the plateau to the left is the hotter one
  EXPECT_NEAR(value_of("contact overshoot", exact, table, t_strong), 0.07, 1e-14);
  EXPECT_NEAR(value_of("energy overshoot", exact, table, t_strong), 0.2, 1e-7);
}

TEST(TubeMeasuresTest, ATubeInThePlaneIsMeasuredAlongItsDirection) {
  Riemann::Data data = strong;
  data.direction = 1;
  const Riemann exact(data);
  ParticleTable table = sampled(exact, t_strong, 2, 40, 5, 0, 1);
  // Two points of 5 and 20 in a cell with a jump disagree by 1/8 of it at most: 3 cells of 40 and
  // jumps of < 1.2.
  for (const char* name : {"L1 density", "L1 velocity", "L1 pressure", "L1 energy"})
    EXPECT_LT(value_of(name, exact, table, t_strong), 3. / 40 / 8 * 1.2 / 0.3) << name;
  for (double& v : table.vx) v = 0.1;  // motion across the tube is an error
  EXPECT_GT(value_of("L1 velocity", exact, table, t_strong), 0.05);
}

TEST(TubeMeasuresTest, ADirectionThatTheGridDoesNotResolveIsRefused) {
  Riemann::Data data = strong;
  const ParticleTable table = sampled(Riemann(data), t_strong, 1, 20, 2, 0, 1);
  data.direction = 1;
  EXPECT_EQ(Riemann(data).least_dim(), 2);
  EXPECT_THROW(Riemann(data).measures(table, t_strong), std::runtime_error);
}

TEST(SmoothMeasuresTest, ErrorsAreRelativeToTheDisturbance) {
  const AcousticWave wave(AcousticWave::Data{1e-4, 1, 1, 1 / 1.4, 3, 1.4, 0});
  ParticleTable table = sampled(wave, 0.7, 1, 64, 3, 0, 1);
  EXPECT_NEAR(value_of("L1 velocity", wave, table, 0.7), 0, 1e-10);
  for (double& v : table.vx) v = 3 + 1.05 * (v - 3);
  for (double& r : table.density) r = 1 + 0.9 * (r - 1);
  EXPECT_NEAR(value_of("L1 velocity", wave, table, 0.7), 0.05, 1e-10);
  EXPECT_NEAR(value_of("L1 density", wave, table, 0.7), 0.1, 1e-10);

  const Vortex vortex(Vortex::Data{5, 1, 10, 1, 1, 1.4, {{5, 5, 0}}, {{1, 0.5, 0}}});
  table = sampled(vortex, 2, 2, 32, 2, 0, 10);
  EXPECT_NEAR(value_of("L1 velocity", vortex, table, 2), 0, 1e-13);
  for (double& v : table.vx) v = 1 + 1.02 * (v - 1);
  for (double& v : table.vy) v = 0.5 + 1.02 * (v - 0.5);
  EXPECT_NEAR(value_of("L1 velocity", vortex, table, 2), 0.02, 1e-12);

  const Uniform still(Uniform::Data{1, 1 / 1.4, 1.4, {}});  // sound speed 1
  table = sampled(still, 2, 2, 8, 2, 0, 1);
  for (double& v : table.vy) v = 0.01;
  EXPECT_NEAR(value_of("L1 velocity", still, table, 2), 0.01, 1e-14);
  EXPECT_NEAR(value_of("L1 energy", still, table, 2), 0, 1e-14);
}

TEST(MeasureTest, OrderIsTheSlopeOfAPowerLaw) {
  const std::vector<double> h{0.1, 0.05, 0.025, 0.002};
  std::vector<double> error;
  for (const double x : h) error.push_back(7 * std::pow(x, 1.7));
  EXPECT_NEAR(order(h, error), 1.7, 1e-12);
  // By hand: log2 of the errors 0, -1, -3 at log2 h of 0, -1, -2; slope (1 * 4/3 + 1 * 5/3) / 2.
  EXPECT_NEAR(order({1, 0.5, 0.25}, {1, 0.5, 0.125}), 1.5, 1e-12);
  EXPECT_THROW(order({0.1}, {1}), std::runtime_error);
  EXPECT_THROW(order({0.1, 0.2}, {1}), std::runtime_error);
  EXPECT_THROW(order({0.1, 0.1}, {1, 2}), std::runtime_error);
  EXPECT_THROW(order({0.1, 0.2}, {1, 0}), std::runtime_error);
}

TEST(MeasureTest, LastFallIsTheOutermost) {
  const Profile profile{{0, 1, 2, 3, 5}, {0, 4, 1, 3, 1}};
  EXPECT_DOUBLE_EQ(last_fall(profile, 2, -1), 4);
  EXPECT_DOUBLE_EQ(last_fall(profile, 3.5, -1), 1 + 0.5 / 3);
  EXPECT_DOUBLE_EQ(last_fall(profile, 9, -1), -1);
  EXPECT_DOUBLE_EQ(last_fall({}, 9, -1), -1);
}

TEST(MeasureTest, CellsAreCountedXFirstAndStraysGoToTheNearest) {
  ParticleTable table;
  table.dim = 2;
  table.cell_size = 0.5;
  table.origin = {1, 2, 0};
  table.cells = {3, 2, 1};
  table.x = {1.1, 2.4, 9};
  table.y = {2.1, 2.9, -9};
  table.vx = {1, 2, 3};
  table.vy = {4, 5, 6};
  table.mass = {1, 2, 4};
  table.volume = {0.5, 0.5, 0.5};
  table.density = {2, 4, 8};
  table.pressure = {10, 20, 30};
  table.energy = {5, 6, 7};
  const auto cells = sums_per_cell(table);
  ASSERT_EQ(cells.size(), 6u);
  EXPECT_EQ(cells[0].mass, 1);
  EXPECT_EQ(cells[5].mass, 2);
  EXPECT_EQ(cells[2].mass, 4);
  EXPECT_TRUE(cells[1].empty());
  EXPECT_EQ(cells[2].mean_velocity()[1], 6);
  EXPECT_EQ(cells[5].mean_density(), 4);
  const auto layers = sums_per_layer(table, 1);
  EXPECT_EQ(layers[0].mass, 5);
  EXPECT_DOUBLE_EQ(layers[0].mean_energy(), (5 + 4 * 7) / 5.);
  EXPECT_DOUBLE_EQ(layers[0].mean_pressure(), 20);
}

}  // namespace
}  // namespace brisance
