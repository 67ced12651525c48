#include "materials/linear_fluid.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/kernels.hpp"
#include "drivers/scene.hpp"
#include "materials/fluid.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

constexpr double B = 1.09e10, rho0 = 1000;
using Liquid = Fluid<LinearFluid>;
Liquid liquid() { return {LinearFluid(B, rho0), {}, {}}; }

Strain strain_between(double before, double after) {
  Strain in;
  in.dt = 1e-6;
  in.rho0 = before;
  in.rho1 = after;
  in.rate[0] = (before / after - 1) / in.dt;
  in.volume_change = 1 / after - 1 / before;
  in.h = 0.01;
  return in;
}

/// Compression by steps that multiply the density alike.
void compress(const Liquid& law, double from, double to, int steps, Liquid::History& h) {
  const auto rho = [&](int k) {
    return from * std::pow(to / from, k / static_cast<double>(steps));
  };
  for (int k = 0; k < steps; ++k)
    law.update(strain_between(rho(k), rho(k + 1)), law.state(rho(k), h).stress, h);
}

TEST(LinearFluidLaw, PressesAndPullsByTheLogarithmOfCompression) {
  for (const double compression : {0.9, 1., 1.2})
    for (const double energy : {0., 1e5})
      EXPECT_DOUBLE_EQ(liquid().state(compression * rho0, {energy}).stress[0],
                       -B * std::log(compression));
}

TEST(LinearFluidLaw, HasTheSameStiffnessAtEveryDensity) {
  for (const double rho : {900., 1000., 1200.}) {
    const double c = liquid().sound_speed(rho, {});
    EXPECT_NEAR(rho * c * c / B, 1, 1e-15 * 4);
  }
  EXPECT_NEAR(liquid().sound_speed(rho0, {}), 3301.515, 5e-4);  // Hu & Chen's liquid
}

// A step back undoes a step of the trapezoid rule: round-off of 2000 sums is left.
TEST(LinearFluidLaw, ReturnsFromClosedCycles) {
  for (const double turn : {0.9, 1.1}) {
    Liquid::History h;
    compress(liquid(), rho0, turn * rho0, 1000, h);
    const double there = h.energy;
    EXPECT_GT(there, 0);
    compress(liquid(), turn * rho0, rho0, 1000, h);
    EXPECT_NEAR(h.energy / there, 0, 2000 * 1e-16 * 2);
    EXPECT_EQ(liquid().state(rho0, h).stress[0], 0);
  }
}

// The trapezoid rule of n steps errs by dv^3 n p'' / 12, p'' = B / v^2: by y / 6n^2 of B v y^2 / 2.
TEST(LinearFluidLaw, StoresTheWorkOfItsPressure) {
  for (const double turn : {0.9, 1.1}) {
    Liquid::History h;
    compress(liquid(), rho0, turn * rho0, 1000, h);
    EXPECT_NEAR(h.energy / liquid().eos.elastic_energy(turn * rho0), 1,
                1.2 * std::fabs(std::log(turn)) / 6e6);
  }
  // y^2/2 (1 + 2y/3 + ...) of B/rho0, y = ln(rho0/rho); differences of y with y^2/2 cost 1e-16/y.
  const double y = -1e-4;
  EXPECT_NEAR(
      liquid().eos.elastic_energy(rho0 * std::exp(-y)) / (B / rho0 * (y * y / 2 + y * y * y / 3)),
      1, y * y / 4 + 1e-11);
}

TEST(LinearFluidLaw, StartsWithTheElasticEnergyOfItsDensity) {
  EXPECT_EQ(liquid().initial(1010, 123, false).energy, liquid().eos.elastic_energy(1010));
  EXPECT_EQ(liquid().initial(1010, 123, true).energy, 123);
}

TEST(LinearFluidLaw, LosesMotionToViscosityInTensionToo) {
  const Fluid<LinearFluid, Inviscid, ShockViscosity> law{LinearFluid(B, rho0), {}, {}};
  for (const double rho : {950., 1000., 1050.})
    for (const double compression : {0.9999, 1.0001}) {
      Liquid::History plain;
      decltype(law)::History h;
      const Strain in = strain_between(rho, rho * compression);
      const Sym3 stress = law.state(rho, h).stress;
      law.update(in, stress, h);
      liquid().update(in, stress, plain);
      EXPECT_GT(h.energy, plain.energy);
    }
}

/// The scene of test::scene() with a liquid of bulk modulus 1.4 and density 1; one or both of its
/// two bodies.
List liquid_scene(int dim, double first_density, bool all) {
  List given = test::scene(dim, {"bodies/first/density=" + std::to_string(first_density)});
  List& bodies = given.sublist("bodies");
  bodies.sublist("first").set("material", "liquid").remove("pressure");
  if (all) {
    given.sublist("materials").remove("gas");
    bodies.sublist("rest").set("material", "liquid").remove("pressure");
  }
  given.sublist("materials")
      .sublist("liquid")
      .set("law", "linear fluid")
      .set("bulk modulus", 1.4)
      .set("density", 1.);
  return complete_scene(given);
}

// Round-off of 100 steps.
TEST(LinearFluid, KeepsMassMomentumAndEnergyInTension) {
  for (const int dim : {1, 2})
    for (const bool all : {true, false}) {
      const auto simulation = make_simulation(liquid_scene(dim, 0.9, all), nullptr);
      const Ledger ledger(simulation->balance());
      for (int k = 0; k < 100; ++k) simulation->advance(100);
      const ParticleTable table = simulation->snapshot().table;
      const double least = *std::min_element(table.pressure.begin(), table.pressure.end());
      EXPECT_LT(least, all ? 0 : 1);  // the gas presses with 1
      EXPECT_NEAR(ledger.mass_error(simulation->balance()), 0, 1e-12);
      EXPECT_NEAR(ledger.momentum_error(simulation->balance()), 0, 1e-12);
      EXPECT_NEAR(ledger.energy_error(simulation->balance()), 0, 1e-12);
      EXPECT_EQ(simulation->balance().floors, 0);
    }
}

TEST(LinearFluid, PaysForNoRelaxation) {
  const auto simulation = make_simulation(liquid_scene(1, 1.1, true), nullptr);
  const auto kernels = kernels_of([&] { simulation->advance(1); });
  for (const char* kernel : {"scatter mean", "gather scalar", "fullness", "load heat"})
    EXPECT_EQ(kernels.count(kernel), 0u) << kernel;
  for (const auto& column : simulation->footprint().columns) EXPECT_NE(column.name, "compression");
}

/// What a body of density 1 and modulus 1.4 is completed to, or the refusal.
std::string body_with(const std::string& name, double value, const std::string& wanted) {
  List given = liquid_scene(1, 1, true);
  List& body = given.sublist("bodies").sublist("first");
  body.remove("density");
  body.remove("pressure");
  body.set(name, value);
  if (wanted == "both") body.set("density", 1.5);
  try {
    const List scene = complete_scene(given);
    const double found = get<double>(scene.sublist("bodies").sublist("first"), wanted);
    return std::to_string(found);
  } catch (const InputError& wrong) {
    return wrong.what();
  }
}

TEST(LinearFluid, OfABodyIsGivenByDensityOrPressure) {
  EXPECT_EQ(body_with("pressure", 1.4, "density"), std::to_string(std::exp(1.)));
  EXPECT_EQ(body_with("density", 2, "pressure"), std::to_string(1.4 * std::log(2.)));
  EXPECT_NE(body_with("pressure", 1.4, "both").find("must be 0.567651151, which belongs to its"),
            std::string::npos)
      << body_with("pressure", 1.4, "both");
  EXPECT_NE(body_with("specific energy", 1, "density").find("unknown"), std::string::npos);
}

}  // namespace
}  // namespace brisance
