#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "drivers/exact.hpp"

namespace brisance {
namespace {

// Half a unit of the last of `digits` printed significant digits.
double last_digit(double value, int digits) {
  if (value == 0) return 0;
  return 0.5 * std::pow(10., std::floor(std::log10(std::abs(value))) + 1 - digits);
}

// `noise`: what rounding leaves of a difference between larger numbers.
void expect_printed(double value, double expected, int digits, double noise = 0) {
  EXPECT_NEAR(value, expected, 1.001 * last_digit(expected, digits) + noise);
}

Riemann tube_of(const Riemann::Side& left, const Riemann::Side& right, double gamma = 1.4) {
  return Riemann(Riemann::Data{left, right, gamma});
}

constexpr auto shock = Riemann::Wave::Kind::shock;
constexpr auto fan = Riemann::Wave::Kind::fan;

// One problem and its answer as printed, to 8 digits. A wave whose head is its tail is a shock.
struct Tube {
  Riemann::Side left, right;
  double gamma, interface, t;
  double p, u, rho_left, rho_right;
  double left_head, left_tail, right_head, right_tail;

  Riemann exact() const { return Riemann(Riemann::Data{left, right, gamma, interface}); }
};

// The numbers come from an independent solver that bisects; they agree with Toro (2009), table 4.2,
// as far as that is printed.
const std::map<std::string, std::vector<double>> printed{
    {"strong",
     {1, 0, 1, 0.125, 0, 0.001, 1.4, 0.5, 0.143, 0.21085775, 1.179541, 0.32895417, 0.72982548,
      -1.183216, 0.23223319, 1.4233181, 1.4233181}},
    {"sod",
     {1, 0, 1, 0.125, 0, 0.1, 1.4, 0.5, 0.2, 0.30313018, 0.92745262, 0.42631943, 0.26557371,
      -1.183216, -0.070272813, 1.7521557, 1.7521557}},
    {"toro 1",
     {1, 0.75, 1, 0.125, 0, 0.1, 1.4, 0.3, 0.2, 0.46629357, 1.3609055, 0.57986669, 0.33970023,
      -0.43321596, 0.29987067, 2.1532344, 2.1532344}},
    {"toro 2",
     {1, -2, 0.4, 1, 2, 0.4, 1.4, 0.5, 0.15, 0.0018938734, 0, 0.021852118, 0.021852118, -2.7483315,
      -0.34833148, 2.7483315, 0.34833148}},
    {"toro 3",
     {1, 0, 1000, 1, 0, 0.01, 1.4, 0.5, 0.012, 460.89379, 19.597451, 0.5750623, 5.9992407,
      -37.416574, -13.899632, 23.517537, 23.517537}},
    {"toro 4",
     {5.99924, 19.5975, 460.894, 5.99242, -6.19633, 46.0950, 1.4, 0.4, 0.035, 1691.647, 8.6897744,
      14.28235, 31.042602, 0.78959392, 0.78959392, 12.250778, 12.250778}},
    {"toro 5",
     {1, -19.59745, 1000, 1, -19.59745, 0.01, 1.4, 0.8, 0.012, 460.89379, 1.3887231e-06, 0.5750623,
      5.9992407, -57.014024, -33.497082, 3.920087, 3.920087}},
    {"collision",
     {1, 1, 1e-6, 1, -1, 1e-6, 5. / 3, 0.5, 0.6, 1.3333356, 0, 3.9999888, 3.9999888, -0.33333458,
      -0.33333458, 0.33333458, 0.33333458}},
    {"air",
     {12.9, 0, 1e7, 1.29, 0, 103200, 1.4, 0.5, 2e-4, 1994136.3, 1071.6404, 4.0776937, 5.9570377,
      -1041.7636, 244.20492, 1367.8489, 1367.8489}}};

Tube tube_named(const std::string& name) {
  const std::vector<double>& v = printed.at(name);
  return {{v[0], v[1], v[2]},
          {v[3], v[4], v[5]},
          v[6],
          v[7],
          v[8],
          v[9],
          v[10],
          v[11],
          v[12],
          v[13],
          v[14],
          v[15],
          v[16]};
}

TEST(RiemannTest, StarStatesAndWaveSpeedsAreThoseOfAnIndependentSolver) {
  for (const auto& [name, numbers] : printed) {
    SCOPED_TRACE(name);
    const Tube tube = tube_named(name);
    const Riemann exact = tube.exact();
    const double largest = std::max(std::abs(tube.left_head), std::abs(tube.right_head));
    const double noise = 32 * 2.3e-16 * largest;
    expect_printed(exact.star_pressure(), tube.p, 8);
    expect_printed(exact.star_velocity(), tube.u, 8, noise);
    expect_printed(exact.wave(0).rho, tube.rho_left, 8);
    expect_printed(exact.wave(1).rho, tube.rho_right, 8);
    EXPECT_EQ(exact.wave(0).kind, tube.left_head == tube.left_tail ? shock : fan);
    EXPECT_EQ(exact.wave(1).kind, tube.right_head == tube.right_tail ? shock : fan);
    expect_printed(exact.wave(0).head, tube.left_head, 8);
    expect_printed(exact.wave(0).tail, tube.left_tail, 8);
    expect_printed(exact.wave(1).head, tube.right_head, 8);
    expect_printed(exact.wave(1).tail, tube.right_tail, 8);
  }
}

TEST(RiemannTest, ProfileIsThatOfAnIndependentSolver) {
  const auto expect_at = [](const char* name, double x, double rho, double u, double p, double e) {
    SCOPED_TRACE(std::string(name) + " at " + std::to_string(x));
    const Tube tube = tube_named(name);
    const MatterState gas = tube.exact().at({x, 0, 0}, tube.t);
    EXPECT_NEAR(gas.rho, rho, 0.51e-6);  // printed to six decimals, p to six digits
    EXPECT_NEAR(gas.v[0], u, 0.51e-6);
    EXPECT_NEAR(gas.e, e, 0.51e-6);
    expect_printed(gas.p, p, 6);
  };
  expect_at("strong", 0.3, 1, 0, 1, 2.5);
  expect_at("strong", 0.4, 0.702583, 0.403263, 0.610066, 2.170797);
  expect_at("strong", 0.5, 0.401878, 0.986013, 0.279082, 1.736111);
  expect_at("strong", 0.6, 0.328954, 1.179541, 0.210858, 1.602486);
  expect_at("strong", 0.7, 0.729825, 1.179541, 0.210858, 0.722288);
  expect_at("strong", 0.8, 0.125, 0, 0.001, 0.02);
  expect_at("toro 2", 0.3, 0.150658, -0.820835, 0.0282651, 0.469026);
  expect_at("toro 2", 0.6, 0.044396, 0.265279, 0.00510914, 0.287700);
  expect_at("toro 3", 0.2, 0.752405, 10.347145, 671.479, 2231.108307);
  expect_at("toro 4", 0.5, 14.282350, 8.689774, 1691.65, 296.107952);
  expect_at("toro 5", 0.2, 0.853246, -13.752430, 800.763, 2346.225577);
}

TEST(RiemannTest, FeaturesNameTheWaves) {
  std::map<std::string, double> value;
  const Tube tube = tube_named("strong");
  for (const Measure& f : tube.exact().features(tube.t)) value[f.name] = f.value;
  expect_printed(value.at("right shock Mach number"), 13.4491, 6);
  EXPECT_NEAR(value.at("right shock position"), 0.703534, 0.51e-6);
  EXPECT_NEAR(value.at("contact position"), 0.668674, 0.51e-6);
  EXPECT_NEAR(value.at("left fan head position"), 0.330800, 0.51e-6);
  EXPECT_NEAR(value.at("left fan tail position"), 0.533209, 0.51e-6);
  EXPECT_EQ(value.count("left shock position"), 0u);
}

TEST(RiemannTest, MirroredDataGiveTheMirroredSolution) {
  for (const auto& [name, numbers] : printed) {
    const Tube tube = tube_named(name);
    Riemann::Data mirrored{tube.right, tube.left, tube.gamma, 0, 1};
    mirrored.left.u *= -1;
    mirrored.right.u *= -1;
    const Riemann there(mirrored), here = tube.exact();
    for (double x = -0.5; x <= 0.5; x += 0.0103) {
      const MatterState a = here.at({tube.interface + x, 7, 7}, tube.t);
      const MatterState b = there.at({7, -x, 7}, tube.t);
      EXPECT_NEAR(a.rho, b.rho, 1e-12 * a.rho);
      EXPECT_NEAR(a.p, b.p, 1e-12 * a.p);
      EXPECT_NEAR(a.v[0], -b.v[1], 1e-12 * std::abs(tube.left_head));
    }
  }
}

// Rankine-Hugoniot across shocks, entropy and Riemann invariant through fans, hold to rounding; the
// velocity is a difference of terms of the size of the largest speed.
TEST(RiemannTest, WavesObeyTheirLawsUpToRatiosOfATrillion) {
  int checked = 0;
  for (const double p : {1e-12, 1e-6, 1., 1e6, 1e12})
    for (const double rho : {1e-12, 1e-4, 1., 1e4, 1e12})
      for (const double mach : {-1e6, -10., -1., 0., 1., 4.9, 1e6}) {
        const double g = 1.4, sound[2] = {std::sqrt(g), std::sqrt(g * p / rho)};
        const double du = mach * (mach > 0 ? sound[0] + sound[1] : std::min(sound[0], sound[1]));
        const Riemann::Side side[2] = {{1, 0, 1}, {rho, du, p}};
        const Riemann exact(Riemann::Data{side[0], side[1], g});
        EXPECT_EQ(exact.vacuum(), mach > 5);
        if (exact.vacuum()) continue;
        const double ps = exact.star_pressure(), us = exact.star_velocity();
        ASSERT_GT(ps, 0);
        for (int k = 0; k < 2; ++k) {
          const Riemann::Wave& w = exact.wave(k);
          const double sign = k == 0 ? -1 : 1;
          const double speed = std::abs(du) + sound[0] + sound[1];
          if (w.kind == shock) {
            const double flux = side[k].rho * (w.head - side[k].u);
            EXPECT_NEAR(ps - side[k].p, flux * (us - side[k].u),
                        1e-9 * (ps + std::abs(flux) * speed));
            EXPECT_NEAR(w.rho * (w.head - us), flux,
                        1e-9 * (w.rho + side[k].rho) * (speed + std::abs(w.head)));
          } else if (w.kind == fan) {
            EXPECT_NEAR(ps / side[k].p, std::pow(w.rho / side[k].rho, g), 1e-12);
            const double behind = sound[k] * std::pow(ps / side[k].p, (g - 1) / (2 * g));
            EXPECT_NEAR(us - sign * 2 * behind / (g - 1), side[k].u - sign * 2 * sound[k] / (g - 1),
                        1e-12 * speed);
          }
          ++checked;
        }
      }
  EXPECT_EQ(checked, 5 * 5 * 6 * 2);
}

TEST(RiemannTest, VacuumOpensBetweenGasesThatPartTooFast) {
  const double a = std::sqrt(1.4 * 0.4);
  const Riemann exact = tube_of({1, -8, 0.4}, {1, 8, 0.4});
  ASSERT_TRUE(exact.vacuum());
  EXPECT_DOUBLE_EQ(exact.wave(0).tail, -8 + 5 * a);  // Toro (4.76): u + 2 a / (gamma - 1)
  EXPECT_DOUBLE_EQ(exact.wave(1).tail, 8 - 5 * a);
  const MatterState hole = exact.at({0, 0, 0}, 1);
  EXPECT_EQ(hole.rho, 0);
  EXPECT_EQ(hole.p, 0);
  EXPECT_EQ(hole.e, 0);
  const double s = -7, ratio = (2 + 0.4 * (-8 - s) / a) / 2.4;  // Toro (4.56)
  EXPECT_NEAR(exact.sample(s).rho, std::pow(ratio, 5), 1e-14);
  EXPECT_EQ(exact.sample(-9).u, -8);
}

TEST(RiemannTest, GasExpandsIntoVacuumOnEitherSide) {
  const Riemann right = tube_of({1, 0, 1}, {0, 0, 0}), left = tube_of({0, 0, 0}, {1, 0, 1});
  const double a = std::sqrt(1.4);
  EXPECT_DOUBLE_EQ(right.wave(0).tail, 5 * a);
  EXPECT_DOUBLE_EQ(left.wave(1).tail, -5 * a);
  for (double s = -7; s < 7; s += 0.1) {
    const Riemann::Side here = right.sample(s), there = left.sample(-s);
    EXPECT_DOUBLE_EQ(here.rho, there.rho);
    EXPECT_DOUBLE_EQ(here.u, -there.u);
    if (s > -a && s < 5 * a) {
      EXPECT_NEAR(here.rho, std::pow((5 - s / a) / 6, 5), 1e-14);  // Toro (4.56)
    }
  }
  EXPECT_EQ(right.sample(6).rho, 0);
}

TEST(RiemannTest, ColdGasIsSweptUpByAShockOfTheLimitingCompression) {
  const Riemann exact = tube_of({1, 1, 0}, {1, -1, 0}, 5. / 3);  // the planar Noh problem
  EXPECT_NEAR(exact.star_pressure(), 4. / 3, 1e-14);
  EXPECT_NEAR(exact.wave(1).rho, 4, 1e-14);
  EXPECT_NEAR(exact.wave(1).head, 1. / 3, 1e-14);
}

TEST(RiemannTest, EqualStatesMakeNoWaves) {
  const Riemann exact = tube_of({1.3, 2, 0.7}, {1.3, 2, 0.7});
  EXPECT_EQ(exact.wave(0).kind, Riemann::Wave::Kind::nothing);
  EXPECT_EQ(exact.wave(1).kind, Riemann::Wave::Kind::nothing);
  EXPECT_DOUBLE_EQ(exact.at({1, 0, 0}, 0.5).v[0], 2);
}

TEST(RiemannTest, RefusesWhatIsNoGas) {
  EXPECT_THROW(tube_of({0, 0, 0}, {0, 0, 0}), InputError);
  EXPECT_THROW(tube_of({0, 0, 1}, {1, 0, 1}), InputError);
  EXPECT_THROW(tube_of({-1, 0, 1}, {1, 0, 1}), InputError);
  EXPECT_THROW(tube_of({1, 0, 1}, {1, 0, 1}, 1.), InputError);
}

TEST(RiemannTest, MeasuresExistOnlyForWavesThatExist) {
  const auto has = [](const Riemann& exact, const std::string& name) {
    const auto docs = exact.measure_docs();
    return std::any_of(docs.begin(), docs.end(),
                       [&](const MeasureDoc& d) { return d.name == name; });
  };
  EXPECT_TRUE(has(tube_named("strong").exact(), "shock position"));
  EXPECT_TRUE(has(tube_named("strong").exact(), "fan noise"));
  EXPECT_FALSE(has(tube_named("toro 2").exact(), "shock position"));
  EXPECT_FALSE(has(tube_named("toro 4").exact(), "fan noise"));
  EXPECT_FALSE(has(tube_of({1, 0, 1}, {0, 0, 0}), "contact overshoot"));
}

}  // namespace
}  // namespace brisance
