// The piston and its container: what is known of it, and how its swing is measured.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "drivers/exact_piston.hpp"
#include "drivers/ledger.hpp"

namespace brisance {
namespace {

constexpr double pi = 3.14159265358979323846, A = 6.45e-4, v0 = 0.01;

/// Of Hu & Chen's section 4.3.1, with a spring of that share of the piston's mass.
PistonContainer container(double mass, double share = 0) {
  return PistonContainer(
      {1.75e4 / A, mass / A, share * mass / A, 0.508, 1000, 1.09e10, v0, "piston"});
}

TEST(PistonContainer, SwingsAsThePaperAndEquation20Have) {
  EXPECT_NEAR(container(17.51).frequency(), 886.831, 5e-4);  // the paper prints 886.8 and 281.2
  EXPECT_NEAR(container(175.1).frequency(), 281.227, 5e-4);
  EXPECT_NEAR(container(17.51).period(), 7.08499e-3, 5e-9);
  EXPECT_NEAR(container(175.1).period(), 22.34203e-3, 5e-8);
}

// Roots found by bisection of the same equation in another program, to two digits behind the point.
TEST(PistonContainer, KnowsAHeavySpring) {
  EXPECT_NEAR(container(17.51, 1e-4).frequency(), 886.82, 5e-3);
  EXPECT_NEAR(container(17.51, 1e-3).frequency(), 886.68, 5e-3);
  EXPECT_NEAR(container(17.51, 1e-2).frequency(), 882.00, 5e-3);
  EXPECT_NEAR(container(17.51, 0.19).frequency(), 874.20, 5e-3);
  EXPECT_NEAR(container(175.1, 1e-2).frequency(), 279.66, 5e-3);
  EXPECT_NEAR(container(175.1, 0.19).frequency(), 276.99, 5e-3);
}

// m u'' = -K u + p at the piston, and no motion at the closed end.
TEST(PistonContainer, IsInBalanceAtThePistonAndClosedAtTheOtherEnd) {
  const PistonContainer exact = container(17.51);
  const double w = exact.frequency();
  for (const double t : {0.0003, 0.002, 0.005}) {
    const double u = v0 / w * std::sin(w * t), p = exact.at({0.508, 0, 0}, t).p;
    EXPECT_NEAR((-1.75e4 * u / A + p) / (17.51 / A * -w * w * u), 1, 1e-12);
    EXPECT_EQ(exact.at({0, 0, 0}, t).v[0], 0);
    EXPECT_NEAR(exact.at({0.6, 0, 0}, t).v[0], v0 * std::cos(w * t), 1e-15);
  }
}

/// A swing of frequency 2 pi and velocity (1 - fall t) cos, recorded in uneven steps.
Oscillation swing(double end, double fall, double drift) {
  Oscillation o;
  for (int k = 0; k <= 1000 * end; ++k) {
    const double t = (k + 0.3 * std::sin(k)) / 1000;
    o.add(t, (1 - fall * t) * std::cos(2 * pi * t) + drift);
  }
  return o;
}

// The trapezoid rule of steps of 1/1000: (2 pi / 1000)^2 / 12 = 3e-6 of the amplitude.
TEST(Oscillation, IsMeasuredByItsPassages) {
  const Oscillation o = swing(20.1, 0, 0);
  EXPECT_EQ(o.periods(), 20u);
  EXPECT_NEAR(o.period(), 1, 1e-6);
  EXPECT_NEAR(o.amplitude() * 2 * pi, 1, 1e-5);
  EXPECT_NEAR(o.velocity_drift(), 0, 1e-5);
  EXPECT_NEAR(o.place_drift(), 0, 1e-5);
}

TEST(Oscillation, ShowsDrifts) {
  // Means over 0 .. 5 and 15 .. 20: (1 - 17.5 fall)/(1 - 2.5 fall), to second order in 5 fall.
  EXPECT_NEAR(swing(20.1, 0.001, 0).velocity_drift(), 0.9825 / 0.9975 - 1, 1e-5);
  // The centre moves on by 15 periods, the amplitude stays 1 / 2 pi but for the way of 20.
  const double drift = 1e-5;
  EXPECT_NEAR(swing(20.1, 0, drift).place_drift(), 15 * drift * 2 * pi, 15e-2 * drift * 2 * pi);
}

TEST(Oscillation, IsNotANumberWithoutAPeriod) {
  EXPECT_TRUE(std::isnan(Oscillation().period()));
  EXPECT_TRUE(std::isnan(swing(0.4, 0, 0).velocity_drift()));
  EXPECT_EQ(swing(0.4, 0, 0).periods(), 0u);
}

TEST(PistonContainer, RecordsTheMaterialThatIsItsPiston) {
  PistonContainer exact = container(17.51);
  const double T = exact.period();
  for (int k = 0; k <= 20200; ++k) {
    Balance b;
    b.time = k * T / 1000;
    for (const char* name : {"liquid", "piston"}) {
      Balance::Material m;
      m.name = name;
      m.totals.mass = 2;
      m.totals.momentum[0] = name[0] == 'p' ? 2 * v0 * std::cos(exact.frequency() * b.time) : 7;
      b.materials.push_back(m);
    }
    exact.record(b);
  }
  const auto measures = exact.measures(ParticleTable(), 1);
  EXPECT_NEAR(measures.at(0).value, T, 1e-6 * T);
  EXPECT_NEAR(measures.at(1).value, 0, 1e-6);
  EXPECT_NEAR(measures.at(2).value, 1.1276e-5, 1e-9);
}

}  // namespace
}  // namespace brisance
