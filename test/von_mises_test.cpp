#include "materials/von_mises.hpp"

#include "point.hpp"

namespace brisance {
namespace {

constexpr double Y = 500e6, G = 200e9 / 2.58;

Point<VonMises> steel_point() { return {law_of<VonMises>(steel())}; }

// The exact path: elastic to e_y = Y / 2G, then sxx = K e -+ 2Y/3. The step to e_y touches the
// yield surface, so that the radial return of a proportional path is exact in any number of steps
// after it.
TEST(VonMisesLaw, FollowsTheExactPathOfUniaxialStrain) {
  const double ey = Y / (2 * G), tiny = 1e-14 * 3.5e9;
  EXPECT_NEAR(Y * 0.71 / 0.42, 8.452381e8, 50);  // the Hugoniot elastic limit as printed
  for (const int steps : {1, 13}) {
    Point<VonMises> point = steel_point();
    point.strain(tensor(-ey, 0, 0, 0), 1e-6);
    EXPECT_NEAR(point.stress[0], -Y * 0.71 / 0.42, tiny);
    point.strain(tensor(-0.02 + ey, 0, 0, 0), 1e-6, steps);
    EXPECT_NEAR(point.stress[0], -3507936507.936508, 1e-5);
    EXPECT_NEAR(point.stress[1], -3.007937e9, 500);
    EXPECT_NEAR(point.stress[2], point.stress[1], tiny);
    EXPECT_NEAR(point.history.plastic_strain, 2. / 3 * (0.02 - ey), 1e-16);
    EXPECT_NEAR(point.history.plastic_strain, 1.118333e-2, 5e-9);
    EXPECT_NEAR(point.history.plastic_work * 7850, 5.591667e6, 0.5);
    EXPECT_NEAR(point.work * 7850, 3.787520e7, 5);
    EXPECT_NEAR(point.missing() / point.work, 0, 1e-13);

    point.strain(tensor(0.005, 0, 0, 0), 1e-6, steps);  // elastic: the range is Y / G
    EXPECT_NEAR(point.stress[0], -2.197490e9, 500);
    EXPECT_NEAR(point.stress[1], -2.472684e9, 500);
    point.strain(tensor(2 * ey - 0.005, 0, 0, 0), 1e-6);
    EXPECT_NEAR(point.history.plastic_strain, 1.118333e-2, 5e-9);
    point.strain(tensor(0.02 - 2 * ey, 0, 0, 0), 1e-6, steps);
    EXPECT_NEAR(point.stress[0], 2. / 3 * Y, tiny);
    EXPECT_NEAR(point.stress[1], -Y / 3, tiny);
    EXPECT_NEAR(point.history.plastic_strain, 2.021667e-2, 5e-9);
    EXPECT_NEAR(point.history.plastic_work * 7850, 1.010833e7, 5);
    EXPECT_NEAR(point.missing() / point.work, 0, 1e-13);
  }
}

TEST(VonMisesLaw, YieldsInShearAtYOverRootThree) {
  Point<VonMises> point = steel_point();
  point.strain(tensor(0, 0, 0, 0.001), 1e-6);
  EXPECT_NEAR(point.stress[3], 1.550388e8, 50);
  EXPECT_EQ(point.history.plastic_strain, 0);
  point.strain(tensor(0, 0, 0, 0.009), 1e-6, 5);
  EXPECT_NEAR(point.stress[3], Y / std::sqrt(3), 1e-14 * Y);
  EXPECT_NEAR(point.history.plastic_strain, 2 / std::sqrt(3) * 0.01 - Y / (3 * G), 1e-16);
  EXPECT_NEAR(point.history.plastic_strain, 9.397005e-3, 5e-10);
}

TEST(VonMisesLaw, LimitsTheDifferenceOfStressesInPlaneStrain) {
  Point<VonMises> point = steel_point();
  point.strain(tensor(0.01, -0.01, 0, 0), 1e-6, 3);
  EXPECT_NEAR(point.stress[0] - point.stress[1], 2 * Y / std::sqrt(3), 1e-13 * Y);
  EXPECT_NEAR(point.stress[2], 0, 1e-13 * Y);
}

// Numbers of 20000 steps of the same return, printed to seven digits.
TEST(VonMisesLaw, FollowsAPathThatTurns) {
  Point<VonMises> point = steel_point();
  point.strain(tensor(-0.004, 0, 0, 0), 1e-6, 20000);
  EXPECT_NEAR(point.stress[0], -9.682540e8, 500);
  EXPECT_NEAR(point.history.plastic_strain, 5.166667e-4, 5e-11);
  point.strain(tensor(0, 0, 0, 0.004), 1e-6, 20000);
  EXPECT_NEAR(point.stress[0], -7.116714e8, 500);
  EXPECT_NEAR(point.stress[1], -5.965453e8, 500);
  EXPECT_NEAR(point.stress[3], 2.809187e8, 500);
  EXPECT_NEAR(point.history.plastic_strain, 3.674248e-3, 5e-10);
  // The print is Y times the strain; that of the mean stress is less by the curve of the path in a
  // step, a few G de^2 a step.
  EXPECT_NEAR(point.history.plastic_work * 7850, 1.837124e6, 0.5 + 20000 * G * 4e-14);
}

// Plane strain: dev flow along sxx - syy, yield Y + H ep: q = Y + 3G H / (3G + H) (2/sqrt3 e -
// Y/3G).
TEST(VonMisesLaw, HardensByItsModulus) {
  List list = steel();
  const double H = 3e9;
  list.set("hardening modulus", H);
  Point<VonMises> point{law_of<VonMises>(list)};
  point.strain(tensor(0, 0, 0, 0.01), 1e-6, 9);
  const double slip = (2 / std::sqrt(3) * 0.01 * 3 * G - Y) / (3 * G + H);
  EXPECT_NEAR(point.history.plastic_strain, slip, 1e-16);
  EXPECT_NEAR(point.stress[3], (Y + H * slip) / std::sqrt(3), 1e-14 * Y);
  EXPECT_NEAR(point.missing() / point.work, 0, 1e-13);
}

TEST(VonMisesLaw, NeverMakesEnergyOnRandomPaths) {
  std::mt19937 random(1);
  Point<VonMises> point = steel_point();
  wander(point, 0.01, 100000, random, [&](const Energies& before, const Energies& after) {
    ASSERT_GE(after.plastic, before.plastic);
    ASSERT_LE(3 * second_invariant(point.stress), Y * Y * (1 + 1e-12));
  });
  // The mean of two admissible stresses never takes work out of plastic flow (Drucker), so that
  // nothing is cut off and the ledger closes to the round-off of 1e5 sums.
  EXPECT_NEAR(point.missing() / point.history.plastic_work, 0, 1e5 * 1e-16);
}

TEST(VonMisesLaw, RefusesParametersOutOfRangeWithOneLine) {
  List list = steel();
  list.set("yield stress", -5.0);
  EXPECT_EQ(refusal<VonMises>(list), "parameter 'yield stress' = -5: must be > 0");
  list = steel();
  list.set("hardening modulus", -1.0);
  EXPECT_EQ(refusal<VonMises>(list), "parameter 'hardening modulus' = -1: must be >= 0");
  EXPECT_EQ(refusal<VonMises>(steel(0)),
            "parameter 'yield stress' is missing: it must be a number > 0");
}

}  // namespace
}  // namespace brisance
