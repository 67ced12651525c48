#include "materials/elastic.hpp"

#include "point.hpp"

namespace brisance {
namespace {

TEST(ElasticLaw, HasTheModuliOfItsParameters) {
  const Elastic law = law_of<Elastic>(steel(0));
  EXPECT_NEAR(law.intact.K, 1.587302e11, 5e4);  // as printed, to seven digits
  EXPECT_NEAR(law.intact.G, 7.751938e10, 5e3);
  EXPECT_NEAR(law.intact.constrained(), 2.620893e11, 5e4);
  EXPECT_NEAR(law.sound_speed(7850, Elastic::History{}), 5778.164, 5e-4);
  EXPECT_EQ(law.density(), 7850);
}

TEST(ElasticLaw, ContractsABarByPoissonsRatio) {
  const Isotropic m = Isotropic::from_young(200e9, 0.29);
  const Sym3 strain = m.strain(tensor(2e8, 0, 0, 3e7));
  EXPECT_NEAR(strain[0], 1e-3, 1e-18);
  EXPECT_NEAR(strain[1], -0.29e-3, 1e-18);
  EXPECT_NEAR(strain[2], -0.29e-3, 1e-18);
  EXPECT_NEAR(strain[3], 3e7 * 1.29 / 200e9, 1e-18);
  const Sym3 back = m.stress(strain);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(back[k], tensor(2e8, 0, 0, 3e7)[k], 2e8 * 1e-15);
}

TEST(ElasticLaw, GivesAllWorkBack) {
  Point<Elastic> point{law_of<Elastic>(steel(0))};
  point.strain(tensor(2e-3, -1e-3, 0, 3e-3), 1e-3, 7);
  EXPECT_NEAR(point.missing() / point.work, 0, 1e-14);  // the mean stress of a step is exact
  const double stored = point.work;
  point.strain(tensor(-2e-3, 1e-3, 0, -3e-3), 1e-3, 3);
  EXPECT_NEAR(point.work / stored, 0, 1e-14);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(point.stress[k], 0, 5e8 * 1e-14);
}

TEST(ElasticLaw, RefusesParametersOutOfRangeWithOneLine) {
  List list = steel(0);
  list.set("Poisson's ratio", 0.5);
  EXPECT_EQ(refusal<Elastic>(list), "parameter 'Poisson's ratio' = 0.5: must be > -1 and < 0.5");
  list = steel(0);
  list.set("density", 0.);
  EXPECT_EQ(refusal<Elastic>(list), "parameter 'density' = 0: must be > 0");
}

TEST(MajorDirection, IsThePrincipalOneAndXWhereAllAreAlike) {
  for (double angle = -1.5; angle < 1.6; angle += 0.1) {
    const Vec<2> n = major_direction(turned(tensor(3, -1, 9, 0), angle));
    EXPECT_NEAR(std::fabs(n[0] * std::cos(angle) + n[1] * std::sin(angle)), 1, 1e-15);
    EXPECT_NEAR(dot(n, n), 1, 1e-15);
    EXPECT_NEAR(along(turned(tensor(3, -1, 9, 0), angle), n), 3, 1e-14);
    EXPECT_NEAR(across(turned(tensor(3, -1, 9, 0), angle), n), 0, 1e-14);
  }
  const Vec<2> tie = major_direction(tensor(2, 2 + 1e-15, 0, -1e-15));
  EXPECT_EQ(tie[0], 1);
  EXPECT_EQ(tie[1], 0);
  EXPECT_EQ(major_direction(Sym3{})[0], 1);
}

}  // namespace
}  // namespace brisance
