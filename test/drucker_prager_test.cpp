#include "materials/drucker_prager.hpp"

#include "point.hpp"

namespace brisance {
namespace {

List concrete_of(const std::string& cone, double dilatancy = 0) {
  List list;
  list.set("Young's modulus", 25e9);
  list.set("Poisson's ratio", 0.15);
  list.set("density", 2320.);
  list.set("cone", cone);
  list.set("dilatancy", dilatancy);
  if (cone.size() == 1) list.set("compressive strength", 28.3e6);
  if (cone == "A") list.set("tensile strength", 2.83e6);
  return list;
}

double excess(const DruckerPragerCone& c, const Sym3& s) {
  return std::sqrt(second_invariant(s)) + c.alpha * trace(s) - c.k;
}

// Printed to six digits behind the point.
TEST(DruckerPragerCone, IsFittedToStrengths) {
  const DruckerPragerCone a = law_of<DruckerPrager>(concrete_of("A")).cone,
                          b = law_of<DruckerPrager>(concrete_of("B")).cone,
                          c = law_of<DruckerPrager>(concrete_of("C")).cone;
  EXPECT_NEAR(a.alpha, 0.472377, 5e-7);
  EXPECT_NEAR(a.k, 2.970730e6, 0.5);
  EXPECT_NEAR(b.alpha, 0.069982, 5e-7);
  EXPECT_NEAR(b.k, 14.358526e6, 0.5);
  EXPECT_NEAR(c.alpha, 0.293408, 5e-7);
  EXPECT_NEAR(c.k, 8.035580e6, 0.5);

  const double fc = 28.3e6, tiny = 1e-15 * fc * 10;
  for (const DruckerPragerCone& cone : {a, b, c}) {
    EXPECT_NEAR(excess(cone, tensor(-fc, 0, 0, 0)), 0, tiny);
    EXPECT_EQ(cone.beta, 0);
  }
  EXPECT_NEAR(excess(a, tensor(2.83e6, 0, 0, 0)), 0, tiny);
  EXPECT_NEAR(excess(b, tensor(-1.16 * fc, -1.16 * fc, 0, 0)), 0, tiny);
  const double confined = 50e6;
  EXPECT_NEAR(excess(c, tensor(-fc - 4.1 * confined, -confined, -confined, 0)), 0, tiny * 10);
}

TEST(DruckerPragerCone, IsGivenDirectly) {
  List list = concrete_of("alpha and k", 0.1);
  list.set("alpha", 0.2);
  list.set("k", 5e6);
  const DruckerPragerCone direct = law_of<DruckerPrager>(list).cone;
  EXPECT_EQ(direct.alpha, 0.2);
  EXPECT_EQ(direct.beta, 0.1);
  EXPECT_EQ(direct.k, 5e6);

  // Mohr and Coulomb in compression: s1 = s3 (1 + sin)/(1 - sin) + 2 c cos/(1 - sin).
  list = concrete_of("friction");
  list.set("friction angle", 30.0);
  list.set("cohesion", 7e6);
  const double s1 = 3 * 20e6 + 2 * 7e6 * std::cos(std::acos(-1.0) / 6) / 0.5;
  EXPECT_NEAR(excess(law_of<DruckerPrager>(list).cone, tensor(-s1, -20e6, -20e6, 0)), 0, 1e-6);
}

// sxx, syy, mean pressure in MPa, printed to three digits behind the point. Proportional beyond the
// first yield: exact for any number of steps when the first one ends there.
TEST(DruckerPragerLaw, FollowsTheExactPathOfUniaxialStrain) {
  struct Printed {
    const char* cone;
    double dilatancy, at_1[3], at_5[3];
  };
  const double alpha_c = law_of<DruckerPrager>(concrete_of("C")).cone.alpha;
  for (const Printed& p :
       {Printed{"A", 0, {263.975, 46.584, 119.048}, {1319.876, 232.919, 595.238}},
        Printed{"C", 0, {249.326, 53.909, 119.048}, {1209.513, 288.101, 595.238}},
        Printed{"C", alpha_c, {262.667, 57.163, 125.664}, {1310.019, 312.614, 645.082}}}) {
    for (const int steps : {1, 2000}) {
      Point<DruckerPrager> point{law_of<DruckerPrager>(concrete_of(p.cone, p.dilatancy))};
      const auto expect = [&](const double* mpa) {
        EXPECT_NEAR(point.stress[0], -mpa[0] * 1e6, 500) << p.cone << steps;
        EXPECT_NEAR(point.stress[1], -mpa[1] * 1e6, 500) << p.cone << steps;
        EXPECT_NEAR(trace(point.stress) / 3, -mpa[2] * 1e6, 500) << p.cone << steps;
      };
      point.strain(tensor(-0.01, 0, 0, 0), 1e-6, steps);
      expect(p.at_1);
      point.strain(tensor(-0.04, 0, 0, 0), 1e-6, steps);
      expect(p.at_5);
      EXPECT_NEAR(point.missing() / point.work, 0, 1e-12);
    }
  }
}

TEST(DruckerPragerLaw, YieldsInUniaxialStrainWhereItIsPrinted) {
  Point<DruckerPrager> point{law_of<DruckerPrager>(concrete_of("C"))};
  point.strain(tensor(-3.8776e-3, 0, 0, 0), 1e-6);
  EXPECT_EQ(point.history.plastic_strain, 0);
  point.strain(tensor(-0.0002e-3, 0, 0, 0), 1e-6);
  EXPECT_GT(point.history.plastic_strain, 0);
}

TEST(DruckerPragerLaw, StopsAtTheApexUnderTension) {
  for (const double dilatancy : {0., 0.2}) {
    Point<DruckerPrager> point{law_of<DruckerPrager>(concrete_of("C", dilatancy))};
    const DruckerPragerCone cone = point.law.cone;
    const double apex = cone.k / (3 * cone.alpha), K = point.law.intact.K;
    const double reach = apex / (3 * K);  // strain in each direction that just gets there
    point.strain(tensor(reach, reach, reach, 0), 1e-6);
    EXPECT_EQ(point.history.plastic_work, 0);
    point.strain(tensor(2e-3, 2e-3, 2e-3, 0), 1e-6, 7);  // along the axis
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(point.stress[k], apex, 1e-15 * K);
    EXPECT_NEAR(point.history.plastic_work * 2320, apex * 6e-3, 1e-12 * apex);
    EXPECT_EQ(point.history.plastic_strain, 0);

    point.strain(tensor(1e-3, -5e-4, 0, 2e-5), 1e-6);  // and beside it
    EXPECT_NEAR(point.missing() / point.work, 0, 1e-13);
    EXPECT_LE(excess(cone, point.stress), 1e-15 * K);
    EXPECT_GT(point.history.plastic_strain, 0);
  }
}

// The return is to the apex from where the flow along the cone would pass it; on the line between
// the two the answers agree.
TEST(DruckerPragerCone, ReturnsWithoutAJumpBetweenConeAndApex) {
  const Isotropic m = Isotropic::from_young(25e9, 0.15);
  const DruckerPragerCone cone(0.3, 0.1, 8e6);
  const double flow = 1e-4;  // whose shear is just used up on reaching the apex
  const double shear = m.G * flow, mean = cone.k / (3 * cone.alpha) + 3 * m.K * cone.beta * flow;
  for (const double beside : {1 - 1e-9, 1., 1 + 1e-9}) {
    Sym3 stress = tensor(mean, mean, mean, shear * beside);
    double plastic = 0;
    EXPECT_TRUE(cone.bring_back(m, stress, plastic, true));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(stress[k], cone.k / 0.9, 1e-8 * m.K * flow * 10);
    EXPECT_NEAR(stress[3], 0, 1e-8 * shear);
    EXPECT_NEAR(plastic, flow / std::sqrt(3), 1e-8 * flow);
  }
}

// Work of the mean stresses is stored or dissipated to the last digit, in steps of any size that do
// not cross the cone.
TEST(DruckerPragerLaw, AccountsForAllWork) {
  for (const double dilatancy : {0., 0.2}) {
    for (const int steps : {10, 300}) {
      Point<DruckerPrager> point{law_of<DruckerPrager>(concrete_of("C", dilatancy))};
      point.strain(tensor(-0.01, 0, 0, 0), 1e-6, steps);
      point.strain(tensor(0, -0.002, 0, 0.02), 1e-6, steps);
      point.strain(tensor(0.01, 0.002, 0, -0.01), 1e-6, steps);
      EXPECT_GT(point.history.plastic_work, 0.1 * point.work);
      EXPECT_NEAR(point.missing() / point.work, 0, 1e-13);
    }
  }
}

TEST(DruckerPragerLaw, NeverMakesEnergyOnRandomPaths) {
  std::mt19937 random(2);
  for (const std::string cone : {"A", "B", "C"})
    for (const bool associated : {false, true})
      for (const double size : {1e-4, 5e-3}) {
        List list = concrete_of(cone);
        if (associated) list.set("dilatancy", law_of<DruckerPrager>(list).cone.alpha);
        Point<DruckerPrager> point{law_of<DruckerPrager>(list)};
        wander(point, size, 10000, random, [&](const Energies& before, const Energies& after) {
          ASSERT_GE(after.plastic, before.plastic);
          ASSERT_LE(excess(point.law.cone, point.stress),
                    1e-12 * (std::fabs(trace(point.stress)) + 25e9 * size));
        });
      }
}

TEST(DruckerPragerLaw, RefusesWhatDoesNotFitTogetherWithOneLine) {
  List list = concrete_of("A");
  list.set("tensile strength", 30e6);
  EXPECT_EQ(refusal<DruckerPrager>(list),
            "parameter 'tensile strength' = 3e+07: must be <= 'compressive strength'");
  list = concrete_of("B", 0.1);
  EXPECT_EQ(refusal<DruckerPrager>(list).substr(0, 60),
            "parameter 'dilatancy' = 0.1: must be <= alpha of the cone, 0");
  list = concrete_of("C");
  list.set("cohesion", 1e6);
  EXPECT_NE(refusal<DruckerPrager>(list).find("'cohesion' is unknown"), std::string::npos);
  list.remove("cohesion");
  list.remove("compressive strength");
  EXPECT_EQ(refusal<DruckerPrager>(list),
            "parameter 'compressive strength' is missing: it must be a number > 0");
  list.set("cone", "D");
  EXPECT_NE(refusal<DruckerPrager>(list).find("'cone' = 'D': must be one of: A, B, C"),
            std::string::npos);
}

}  // namespace
}  // namespace brisance
