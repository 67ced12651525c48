// The reference on moving cells, held against answers in closed form and against a code of its own.
#include "drivers/lagrange.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "drivers/exact_detonation.hpp"
#include "test/explosive.hpp"

namespace brisance {
namespace {

Layer gas(double thickness, double density, double energy, double gamma = 1.4) {
  Layer layer;
  layer.thickness = thickness;
  layer.density = density;
  layer.energy = energy;
  layer.gamma = gamma;
  return layer;
}
Layer air(double thickness) { return gas(thickness, 1.29, 2e5); }

Layer steel(double thickness, double yield = 500e6) {
  Layer layer;
  layer.law = Layer::Law::steel;
  layer.thickness = thickness;
  layer.density = 7850;
  layer.steel = {7850, 200e9, 0.29};
  layer.yield = yield;
  return layer;
}

Layer tnt(double thickness) {
  Layer layer;
  layer.law = Layer::Law::explosive;
  layer.thickness = thickness;
  layer.products = std::make_shared<const Jwl>(check(test::tnt(), Jwl::valid_parameters()));
  layer.density = 1630;
  layer.energy = layer.products->energy0;
  layer.detonation_speed = 6930;
  return layer;
}

/// When a shock reaches the outer wall of layers about an axis, and the greatest velocity of the
/// second layer until then.
struct Arrival {
  double time = 0, velocity = 0;
};
Arrival arrival(const std::vector<Layer>& layers) {
  Lagrangian::Data data;
  data.layers = layers;
  data.cylindrical = true;
  data.cell_size = 1.25e-3;
  Lagrangian reference(data);
  const double at_rest = 0.4 * 1.29 * 2e5;
  Arrival result;
  while (reference.cells().back().pressure < 2 * at_rest && reference.time() < 1e-3) {
    reference.step(1e-3);
    result.velocity = std::max(result.velocity, reference.mean_velocity(1));
  }
  result.time = reference.time();
  EXPECT_NEAR(reference.energy_error(), 0, 1e-12);
  return result;
}

// 400 cells; an error of first order in the cell, 5e-3 of L1 is what good schemes reach.
TEST(Lagrangian, HasSodsTube) {
  Lagrangian::Data data;
  data.layers = {gas(0.5, 1, 2.5), gas(0.5, 0.125, 2)};
  data.cell_size = 1. / 400;
  Lagrangian tube(data);
  tube.advance_to(0.2);
  const Riemann exact(Riemann::Data{{1, 0, 1}, {0.125, 0, 0.1}, 1.4, 0.5});
  double density = 0, pressure = 0, length = 0;
  for (std::size_t i = 0; i < tube.cells().size(); ++i) {
    const auto& cell = tube.cells()[i];
    const MatterState s = exact.at({tube.centre(i), 0, 0}, 0.2);
    density += cell.volume * std::fabs(cell.mass / cell.volume - s.rho) / s.rho;
    pressure += cell.volume * std::fabs(cell.pressure - s.p) / s.p;
    length += cell.volume;
  }
  EXPECT_NEAR(length, 1, 1e-12);
  EXPECT_LT(density, 0.005);
  EXPECT_LT(pressure, 0.005);
  EXPECT_NEAR(tube.energy_error(), 0, 1e-13);
}

TEST(Lagrangian, HasTheDetonationOfChapmanJouguetAndTaylor) {
  Lagrangian::Data data;
  data.layers = {tnt(0.1)};
  data.high_wall = false;
  data.cell_size = 0.1 / 800;
  Lagrangian slab(data);
  slab.advance_to(1.4e-5);
  const Detonation exact(Detonation::Data{*data.layers[0].products, 0});
  double error = 0, scale = 0;
  const double front = exact.chapman_jouguet().D * 1.4e-5;
  for (std::size_t i = 0; i < slab.cells().size(); ++i) {
    if (slab.centre(i) > 0.98 * front) break;
    const double p = exact.at({slab.centre(i), 0, 0}, 1.4e-5).p;
    error += std::fabs(slab.cells()[i].pressure - p);
    scale += p;
  }
  EXPECT_LT(error / scale, 0.01);
  EXPECT_NEAR(slab.energy_error(), 0, 1e-13);
}

// Gas of 1 MPa presses on a plate of 0.1 m that stays elastic: its stress follows at the speed of
// longitudinal waves.
TEST(Lagrangian, SendsElasticWavesAtTheirSpeed) {
  Lagrangian::Data data;
  data.layers = {gas(0.1, 1.2, 1e6 / 0.4 / 1.2), steel(0.1)};
  data.cell_size = 2.5e-4;
  Lagrangian plate(data);
  const double t = 1e-5, speed = data.layers[1].steel.wave_speed();
  plate.advance_to(t);
  double front = 0;
  for (std::size_t i = 400; i < 800; ++i)
    if (plate.cells()[i].pressure - plate.cells()[i].along > 0.5e6) front = plate.centre(i);
  EXPECT_NEAR((front - 0.1) / (speed * t), 1, 2 * 2.5e-4 / (speed * t));
  const auto& loaded = plate.cells()[450];
  EXPECT_NEAR(loaded.pressure - loaded.along, 1e6, 2e4);
  EXPECT_NEAR((loaded.pressure - loaded.hoop) / (loaded.pressure - loaded.along), 0.29 / 0.71,
              1e-3);
}

// A thick steel ring that a gas of pressure P fills settles about the static answer (Lame 1852):
// hoop less radial stress at radius r is 2 P a^2 b^2 / ((b^2 - a^2) r^2). It swings about that
// with a period of some 2 pi R / sqrt(E / rho); the mean over several of them is the static one.
TEST(Lagrangian, HasLamesStressInARing) {
  Lagrangian::Data data;
  const double a = 0.1, b = 0.15, P = 1e6;
  // A gas so stiff by its mass that its pressure hardly changes: gamma 1.01 and cold.
  data.layers = {gas(a, 1.2, P / 0.01 / 1.2, 1.01), steel(b - a)};
  data.cylindrical = true;
  data.high_wall = false;
  data.cell_size = 5e-3;
  Lagrangian ring(data);
  double sum = 0, time = 0;
  const double period = 2 * 3.14159265358979 * 0.125 / std::sqrt(200e9 / 7850), end = 20 * period;
  while (ring.time() < end) {
    const double before = ring.time();
    ring.step(end);
    const auto& cell = ring.cells()[25];
    sum += (ring.time() - before) * (cell.hoop - cell.along);
    time += ring.time() - before;
  }
  const double r = ring.centre(25);
  EXPECT_NEAR(sum / time / (2 * P * a * a * b * b / ((b * b - a * a) * r * r)), 1, 0.03);
}

// Numbers of an independent reference of its own scheme and grid, which rounds them to a unit.
TEST(Lagrangian, ThrowsAPlateOfSteel) {
  Lagrangian::Data data;
  data.layers = {tnt(0.1), steel(0.025), air(0.275)};
  data.cell_size = 3.125e-4;
  Lagrangian plate(data);
  plate.advance_to(50e-6);
  EXPECT_NEAR(plate.mean_velocity(1) / 1141, 1, 2e-3);
  plate.advance_to(100e-6);
  EXPECT_NEAR(plate.mean_velocity(1) / 1610, 1, 2e-3);
  EXPECT_NEAR(plate.energy_error(), 0, 1e-13);
}

TEST(Lagrangian, ConvergesToOneVelocityOfAPlate) {
  std::vector<double> velocity;
  for (const double cell : {1.25e-3, 0.625e-3, 0.3125e-3}) {
    Lagrangian::Data data;
    data.layers = {tnt(0.1), steel(0.025), air(0.275)};
    data.cell_size = cell;
    Lagrangian plate(data);
    plate.advance_to(100e-6);
    velocity.push_back(plate.mean_velocity(1));
  }
  EXPECT_LT(std::fabs(velocity[2] - velocity[1]), 0.8 * std::fabs(velocity[1] - velocity[0]));
}

// Unlit explosive bears no pressure: what the air does to the plate must not light it.
TEST(Lagrangian, LightsNothingAheadOfTheFront) {
  Lagrangian::Data data;
  data.layers = {tnt(0.1), steel(0.025), air(0.275)};
  data.cell_size = 0.1 / 1280;
  Lagrangian plate(data);
  plate.advance_to(1e-5);
  const double front = 6930 * 1e-5 + 5 * data.cell_size;
  for (std::size_t i = 0; i < 1280; ++i)
    if (plate.centre(i) > front) {
      EXPECT_EQ(plate.cells()[i].burned, 0);
    }
}

TEST(Lagrangian, ThrowsARingOfSteelAndHasBlastsAboutAnAxis) {
  const Arrival cased = arrival({tnt(0.1), steel(0.025), air(0.525)});
  EXPECT_NEAR(cased.velocity / 1327, 1, 2e-3);
  EXPECT_NEAR(cased.time / 398e-6, 1, 5e-3);
  EXPECT_NEAR(arrival({tnt(0.1), air(0.55)}).time / 119e-6, 1, 1.5e-2);
  EXPECT_NEAR(arrival({tnt(0.075), steel(0.025), air(0.55)}).velocity / 1120, 1, 2e-3);
  EXPECT_NEAR(arrival({tnt(0.075), air(0.575)}).time / 130.5e-6, 1, 1e-2);
}

}  // namespace
}  // namespace brisance
