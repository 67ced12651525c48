#include "drivers/cracks.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

namespace brisance {
namespace {

/// Points of a wall across x at y = -1.9, -1.7 ... 1.9, of mass 1, unharmed.
ParticleTable wall() {
  ParticleTable t;
  t.dim = 2;
  t.cell_size = 0.2;
  t.cells = {4, 20, 1};
  t.fields = {{"damage", "-", {}},
              {"decohesion", "-", {}},
              {"normal x", "-", {}},
              {"normal y", "-", {}},
              {"peak rate", "1/s", {}}};
  for (int k = 0; k < 20; ++k) {
    t.x.push_back(0.1);
    t.y.push_back(-1.9 + 0.2 * k);
    t.mass.push_back(1);
    t.volume.push_back(1);
    t.pressure.push_back(k);
    for (auto& f : t.fields) f.values.push_back(0);
  }
  return t;
}

std::vector<double>& column(ParticleTable& t, const std::string& name) {
  for (auto& f : t.fields)
    if (f.name == name) return f.values;
  throw std::logic_error(name);
}

CrackPattern pattern() {
  List given;
  given.set("size", 0.2);
  return CrackPattern(check(given, CrackPattern::valid_parameters(2)));
}

double value(const CrackPattern& seen, const std::string& name) {
  for (const Measure& m : seen.measures())
    if (m.name == name) return m.value;
  return std::nan("");
}

/// Of one table alone.
double value(CrackPattern fresh, const ParticleTable& t, const std::string& name) {
  fresh.observe(t, 0);
  return value(fresh, name);
}

TEST(Cracks, OfASymmetricPatternHaveNoAsymmetry) {
  ParticleTable t = wall();
  column(t, "decohesion")[8] = column(t, "decohesion")[11] = 0.5;  // y = -0.3 and 0.3
  EXPECT_EQ(value(pattern(), t, "asymmetry"), 0);
  column(t, "decohesion")[11] = 0;
  EXPECT_EQ(value(pattern(), t, "asymmetry"), 1);
}

TEST(Cracks, CombineDamageAndDecohesion) {
  ParticleTable t = wall();
  column(t, "damage")[10] = 0.2;
  column(t, "decohesion")[10] = 0.5;
  column(t, "decohesion")[0] = 1;
  EXPECT_NEAR(value(pattern(), t, "failed mass"), 1 - 0.8 * 0.5 + 1, 1e-15);
  EXPECT_EQ(value(pattern(), t, "separated mass"), 1);
  EXPECT_NEAR(value(pattern(), t, "failure near the middle"), 0.6 / 1.6, 1e-15);
  EXPECT_NEAR(value(pattern(), t, "failed extent"), 1.9, 1e-15);
  EXPECT_EQ(value(pattern(), t, "largest damage"), 0.2);
}

TEST(Cracks, HaveANormalWithoutSign) {
  ParticleTable t = wall();
  for (const int k : {9, 10}) {
    column(t, "decohesion")[k] = 0.5;
    column(t, "normal x")[k] = k == 9 ? -1 : 1;
  }
  EXPECT_NEAR(value(pattern(), t, "normal at the middle"), 0, 1e-12);
  column(t, "normal x")[9] = column(t, "normal x")[10] = column(t, "normal y")[9] =
      column(t, "normal y")[10] = std::sqrt(0.5);
  EXPECT_NEAR(value(pattern(), t, "normal at the middle"), 45, 1e-12);
}

TEST(Cracks, RememberWhatWasOnTheWay) {
  ParticleTable t = wall();
  CrackPattern seen = pattern();
  seen.observe(t, 0.5);
  EXPECT_EQ(value(seen, "greatest pressure"), 19);
  EXPECT_TRUE(std::isnan(value(seen, "first decohesion")));
  column(t, "decohesion")[3] = 0.1;
  t.pressure.assign(20, 1);
  seen.observe(t, 0.75);
  seen.observe(t, 1);
  EXPECT_EQ(value(seen, "greatest pressure"), 19);
  EXPECT_EQ(value(seen, "first decohesion"), 0.75);
}

TEST(Cracks, NeedConcrete) {
  ParticleTable t = wall();
  t.fields.clear();
  EXPECT_THROW(pattern().observe(t, 0), std::runtime_error);
}

}  // namespace
}  // namespace brisance
