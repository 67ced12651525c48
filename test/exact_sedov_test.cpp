#include <gtest/gtest.h>

#include <cmath>

#include "drivers/exact.hpp"

namespace brisance {
namespace {

// Printed by an integration of all three equations without the energy integral.
TEST(SedovTest, ConstantsAreThoseOfAnIndependentIntegration) {
  struct Row {
    int j;
    double gamma, alpha, xi, centre, kinetic;
  };
  const Row rows[] = {{1, 1.2, 2.239148, 0.764374, 0.43225, 0.12510},
                      {1, 1.4, 1.077486, 0.975430, 0.39002, 0.18369},
                      {1, 5. / 3, 0.602935, 1.183704, 0.35320, 0.22716},
                      {1, 1.67, 0.599384, 1.186037, 0.35283, 0.22757},
                      {1, 2, 0.366332, 1.397575, 0.32343, 0.25845},
                      {1, 3, 0.141923, 1.917117, 0.27796, 0.30121},
                      {2, 1.2, 2.005186, 0.840352, 0.42603, 0.13645},
                      {2, 1.4, 0.984074, 1.004022, 0.37292, 0.20880},
                      {2, 5. / 3, 0.564283, 1.153787, 0.32150, 0.26655},
                      {2, 1.67, 0.561120, 1.155410, 0.32096, 0.26710},
                      {2, 2, 0.351936, 1.298327, 0.27591, 0.31069},
                      {2, 3, 0.144403, 1.622205, 0.19753, 0.37576},
                      {3, 1.2, 1.719803, 0.897231, 0.42359, 0.14070},
                      {3, 1.4, 0.851072, 1.032777, 0.36546, 0.21873},
                      {3, 5. / 3, 0.493590, 1.151666, 0.30620, 0.28276},
                      {3, 1.67, 0.490891, 1.152930, 0.30555, 0.28338},
                      {3, 2, 0.311988, 1.262329, 0.25082, 0.33291},
                      {3, 3, 0.132524, 1.498101, 0.14790, 0.40959}};
  for (const Row& row : rows) {
    SCOPED_TRACE("symmetry " + std::to_string(row.j) + ", gamma " + std::to_string(row.gamma));
    const Sedov exact(Sedov::Data{row.j, 1, 1, 0, row.gamma, {}});
    EXPECT_NEAR(exact.alpha(), row.alpha, 0.51e-6);
    EXPECT_NEAR(exact.radius(1), row.xi, 0.51e-6);
    EXPECT_NEAR(exact.profile(0).p, row.centre, 0.51e-5);
    EXPECT_NEAR(exact.kinetic_share(), row.kinetic, 0.51e-5);
  }
}

TEST(SedovTest, ProfileIsThatOfAnIndependentIntegration) {
  struct Row {
    int j;
    double gamma, x, rho, p, u;
  };
  const Row rows[] = {
      {2, 1.4, 0.3, 0.00079, 0.37299, 0.25714},  {2, 1.4, 0.5, 0.01028, 0.37534, 0.42917},
      {2, 1.4, 0.8, 0.13108, 0.44723, 0.71205},  {2, 1.4, 0.98, 0.76476, 0.86558, 0.96445},
      {2, 1.67, 0.1, 0.00038, 0.32096, 0.07993}, {2, 1.67, 0.4, 0.02419, 0.32442, 0.32073},
      {2, 1.67, 0.7, 0.14854, 0.38423, 0.58723}, {2, 1.67, 0.95, 0.67726, 0.76957, 0.91505},
      {3, 1.4, 0.6, 0.00679, 0.36782, 0.51500},  {3, 1.4, 0.9, 0.20541, 0.50774, 0.82183},
      {1, 1.4, 0.2, 0.00654, 0.39025, 0.17144},  {1, 1.4, 0.7, 0.17973, 0.46451, 0.62319}};
  for (const Row& row : rows) {
    SCOPED_TRACE("symmetry " + std::to_string(row.j) + " at " + std::to_string(row.x));
    const Sedov exact(Sedov::Data{row.j, 1, 1, 0, row.gamma, {}});
    // The printed values are those at the nearest of the table's points, up to 1.73e-4 of x away.
    const auto here = exact.profile(row.x), below = exact.profile(row.x * (1 - 1.73e-4)),
               above = exact.profile(row.x * (1 + 1.73e-4));
    EXPECT_NEAR(here.rho, row.rho, 0.51e-5 + (above.rho - below.rho));
    EXPECT_NEAR(here.p, row.p, 0.51e-5 + (above.p - below.p));
    EXPECT_NEAR(here.u, row.u, 0.51e-5 + (above.u - below.u));
  }
}

TEST(SedovTest, BlastOfFourCellsIsAsCalculatedByHand) {
  Sedov::Data data;
  data.energy = 1e9 * 1e-4 / 0.67;
  data.density = 1.67;
  data.gamma = 1.67;
  const Sedov exact(data);
  EXPECT_NEAR(exact.radius(41e-6), 0.12792, 0.51e-5);
  EXPECT_NEAR(exact.peak_pressure(41e-6), 3.044e6, 0.51e3);
  EXPECT_NEAR(exact.front_speed(41e-6), 1560.0, 0.051);
}

TEST(SedovTest, TheMassSweptUpIsInside) {
  for (const int j : {1, 2, 3})
    for (const double gamma : {1.05, 1.4, 3., 6.5}) {
      const Sedov exact(Sedov::Data{j, 1, 1, 0, gamma, {}});
      double mass = 0;
      const int points = 200000;
      for (int i = 0; i < points; ++i) {
        const double x = (i + 0.5) / points;
        mass += exact.profile(x).rho * std::pow(x, j - 1) / points;
      }
      mass *= (gamma + 1) / (gamma - 1) * j;
      // Linear interpolation in a table of step 3.5e-4 of a logarithm that bends as j / (gamma -
      // 1).
      EXPECT_NEAR(mass, 1, 1e-7 * std::max(1., j / (gamma - 1)) * std::max(1., j / (gamma - 1)))
          << j << ' ' << gamma;
    }
}

TEST(SedovTest, CentreIsFinite) {
  for (const double gamma : {1.01, 1.4, 6.}) {
    const Sedov exact(Sedov::Data{2, 1, 1, 0.1, gamma, {{0.5, 0.5, 0}}});
    const MatterState gas = exact.at({0.5, 0.5, 3}, 1);
    EXPECT_EQ(gas.rho, 0);
    EXPECT_EQ(gas.v[0], 0);
    EXPECT_DOUBLE_EQ(gas.p, exact.central_pressure(1));
    EXPECT_TRUE(std::isfinite(gas.e));
    EXPECT_EQ(exact.at({0.5, 0.5, 0}, 0).p, 0.1);
    EXPECT_EQ(exact.at({5, 0.5, 0}, 1).rho, 1);
  }
}

TEST(SedovTest, OnlyACylindricalBlastHasAxesAndDiagonals) {
  for (const int j : {1, 2, 3}) {
    const auto docs = Sedov(Sedov::Data{j, 1, 1, 0, 1.4, {}}).measure_docs();
    EXPECT_EQ(docs.back().name == "asymmetry", j == 2);
  }
}

}  // namespace
}  // namespace brisance
