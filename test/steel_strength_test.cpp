// The ends of steel's strength: tension cut-off and failure strain of von Mises' law.
#include "materials/von_mises.hpp"
#include "point.hpp"

namespace brisance {
namespace {

constexpr double Y = 500e6, K = 200e9 / (3 * 0.42), rho = 7850;

Point<VonMises> steel_point(double cut_off, double failure) {
  List list = steel();
  list.set("tension cut-off", cut_off).set("failure strain", failure);
  return {law_of<VonMises>(list)};
}

// The mean stress climbs to the cut-off and stays; what is pulled beyond is dissipated by it.
TEST(TensionCutOff, HoldsTheMeanStressWhileTheMatterOpens) {
  const double cut_off = 1.2e9, yields_at = cut_off / (3 * K), e = 0.01;
  for (const int steps : {1, 7}) {
    Point<VonMises> point = steel_point(cut_off, 0);
    point.strain(tensor(yields_at, yields_at, yields_at, 0), 1e-6);
    EXPECT_NEAR(point.stress[0], cut_off, 1e-14 * cut_off);
    EXPECT_NEAR(point.history.plastic_work * rho, 0, 1e-14 * cut_off);
    point.strain(tensor(e, e, e, 0), 1e-6, steps);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(point.stress[k], cut_off, 1e-14 * cut_off);
    EXPECT_NEAR(point.history.plastic_work * rho / (3 * e * cut_off), 1, 1e-12);
    EXPECT_NEAR(point.missing() / point.work, 0, 1e-13);
    EXPECT_EQ(point.history.plastic_strain, 0);
    // It has not closed, yet presses at once: the rate form does not remember the gap.
    point.strain(tensor(-2 * yields_at, -2 * yields_at, -2 * yields_at, 0), 1e-6);
    EXPECT_NEAR(point.stress[0], -cut_off, 1e-13 * cut_off);
  }
}

TEST(TensionCutOff, LeavesShearAlone) {
  Point<VonMises> with = steel_point(1e9, 0), without = steel_point(0, 0);
  for (auto* point : {&with, &without}) point->strain(tensor(0.02, 0, 0, 0.01), 1e-6, 20);
  EXPECT_GT(trace(without.stress) / 3, 1e9);
  EXPECT_NEAR(trace(with.stress) / 3, 1e9, 1);
  const double cut = (trace(without.stress) - trace(with.stress)) / 3;
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(with.stress[k] + (k < 3 ? cut : 0), without.stress[k], 1e-14 * 20 * 4e9);
}

TEST(FailureStrain, EndsShearAndTensionAndGivesTheirEnergyToThePlasticWork) {
  Point<VonMises> point = steel_point(0, 0.02);
  const auto last = [&] { return std::sqrt(3 * second_invariant(point.stress)); };
  double strained = 0;
  while (point.history.plastic_strain < 0.02 && strained < 1) {
    if (strained > 0.01) {
      EXPECT_NEAR(last(), Y, 1e-13 * Y);
    }
    point.strain(tensor(1e-4, 0, 0, 1e-3), 1e-6);
    strained += 1e-3;
  }
  // 2/sqrt3 of the shear strain flows, less what is elastic, Y / 3G; and a step more at most.
  EXPECT_NEAR(strained, (0.02 + Y / (3 * 200e9 / 2.58)) * std::sqrt(3) / 2, 1e-3);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(point.stress[k], 0);
  EXPECT_EQ(point.energies().elastic, 0);
  EXPECT_NEAR(point.missing() / point.work, 0, 1e-13);

  const double plastic = point.history.plastic_strain;
  point.strain(tensor(0.01, 0, 0, 0.05), 1e-6, 3);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(point.stress[k], 0);
  point.strain(tensor(-0.003, 0, 0, 0.05), 1e-6, 3);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(point.stress[k], -0.003 * K, 1e-14 * 0.003 * K);
  for (int k = 3; k < 6; ++k) EXPECT_EQ(point.stress[k], 0);
  EXPECT_EQ(point.history.plastic_strain, plastic);
  EXPECT_NEAR(point.missing() / point.work, 0, 1e-13);
}

TEST(SteelStrength, NeverMakesEnergyOnRandomPaths) {
  std::mt19937 random(1);
  for (const double failure : {0., 0.05}) {
    Point<VonMises> point = steel_point(0.4e9, failure);
    wander(point, 1e-4, 100000, random, [&](const Energies& before, const Energies& after) {
      ASSERT_GE(after.plastic, before.plastic);
      ASSERT_LE(trace(point.stress) / 3, 0.4e9 * (1 + 1e-12));
    });
    // The limits bound a convex set: as long as no step crosses it, the mean of two stresses takes
    // no work out of what is cut off (Drucker). What has failed is crossed by every step that opens
    // it.
    if (failure == 0) {
      EXPECT_NEAR(point.missing() / point.history.plastic_work, 0, 1e5 * 1e-16);
    } else {
      EXPECT_GE(point.history.plastic_strain, failure);
    }
  }
}

TEST(SteelStrength, IsEndlessByDefaultAndTakesNoStateVariable) {
  Point<VonMises> plain{law_of<VonMises>(steel())}, off = steel_point(0, 0);
  EXPECT_EQ(VonMises::field_count, 3);
  for (auto* point : {&plain, &off}) point->strain(tensor(0.5, 0.5, 0.5, 2), 1e-6, 10);
  EXPECT_NEAR(trace(plain.stress) / 3, 1.5 * K, 1e-13 * K);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(plain.stress[k], off.stress[k]);
  EXPECT_EQ(refusal<VonMises>(List(steel()).set("failure strain", -1.)),
            "parameter 'failure strain' = -1: must be >= 0");
}

}  // namespace
}  // namespace brisance
