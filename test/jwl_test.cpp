// Products of an explosive: values of Hu & Chen (2006), Table 3, worked out independently, and how
// a point burns.
#include "materials/jwl.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>

#include "core/parameters.hpp"
#include "materials/fluid.hpp"
#include "test/explosive.hpp"

namespace brisance {
namespace {

using Law = Fluid<Jwl, Inviscid, NoShockViscosity>;

Law tnt(const char* burn = "at once") {
  List given = test::tnt();
  given.set("burn", burn);
  return {Jwl(check(given, Jwl::valid_parameters())), {}, {}};
}

Strain strain(double rho0, double rho1) {
  Strain in;
  in.rho0 = rho0;
  in.rho1 = rho1;
  in.volume_change = 1 / rho1 - 1 / rho0;
  in.dt = 1e-7;
  in.spacing = 1e-3;
  return in;
}

// To the digits of the reference.
TEST(Jwl, DetonatesAsItsConstantsSay) {
  const ChapmanJouguet cj = chapman_jouguet(tnt().eos);
  EXPECT_NEAR(cj.D, 6929.66, 0.005);
  EXPECT_NEAR(cj.p, 21.0012e9, 1e5);
  EXPECT_NEAR(cj.V, 0.731693, 1e-6);
  EXPECT_NEAR(cj.u, 1859.28, 0.005);
  EXPECT_NEAR(cj.gamma, 2.7271, 5e-5);
  EXPECT_NEAR(cj.e * 1630, 8.81738e9, 1e4);
}

TEST(Jwl, HasTheStateOfAnExplosionAtConstantVolume) {
  const Law law = tnt();
  const auto h = law.initial(1630, 6e9 / 1630, true);
  const Response r = law.state(1630, h);
  EXPECT_NEAR(-r.stress[0], 8.426738e9, 1e3);
  EXPECT_NEAR(r.sound_speed, 4084.25, 0.005);
}

// One step of V from 1 to 1.05: the trapezoid in closed form, which an iteration meets at
// 5.609563e9 J/m^3 and 7.190734e9 Pa.
TEST(Jwl, ExpandsByTheTrapezoidInClosedForm) {
  const Law law = tnt();
  auto h = law.initial(1630, 6e9 / 1630, true);
  const Sym3 before = law.state(1630, h).stress;
  const Response after = law.update(strain(1630, 1630 / 1.05), before, h);
  EXPECT_NEAR(h.energy * 1630, 5.609563e9, 1e3);
  EXPECT_NEAR(-after.stress[0], 7.190734e9, 1e3);
}

TEST(Burning, PressesByTheShareThatHasBurned) {
  const Law law = tnt();
  auto h = law.initial(1630, 6e9 / 1630, true);
  const double all = law.pressure(1630, h);
  h.burned = 0.25;
  EXPECT_DOUBLE_EQ(law.pressure(1630, h), 0.25 * all);
  const double quarter = law.speed_of_sound(1630, h);
  h.burned = 1;
  EXPECT_DOUBLE_EQ(quarter, 0.5 * law.speed_of_sound(1630, h));
}

// 2.5 spacings of 1 mm take 2.5e-3 / 6930 s; steps of 1e-7 s burn 0.2772 each, the one in which the
// point is lit as much as is left of it.
TEST(Burning, TakesTheTimeThatTheDetonationNeedsForItsWidth) {
  const Law law = tnt("program");
  auto h = law.initial(1630, 6e9 / 1630, true);
  h.lighting_time = 1.5e-7;
  Strain in = strain(1630, 1630);
  const double per_step = 1e-7 * 6930 / 2.5e-3;
  const double expected[] = {0, 0.5 * per_step, 1.5 * per_step, 2.5 * per_step, 3.5 * per_step, 1};
  for (int k = 0; k < 6; ++k) {
    in.time = (k + 1) * 1e-7;
    law.advance_burn(in, h);
    EXPECT_NEAR(h.burned, std::fmin(expected[k], 1), 1e-14) << k;
  }
}

TEST(Burning, IsNotHastenedByItsStepLength) {
  const Law law = tnt("program");
  auto coarse = law.initial(1630, 6e9 / 1630, true), fine = coarse;
  coarse.lighting_time = fine.lighting_time = 0.3e-7;
  Strain in = strain(1630, 1630);
  in.time = in.dt;
  law.advance_burn(in, coarse);
  in.dt = 1e-8;
  for (int k = 1; k <= 10; ++k) {
    in.time = k * 1e-8;
    law.advance_burn(in, fine);
  }
  EXPECT_NEAR(coarse.burned, fine.burned, 1e-14);
}

TEST(Burning, ByCompressionIsCompleteAtTheVolumeOfChapmanAndJouguet) {
  List given = test::tnt();
  given.set("volume burn", true);
  const Jwl products(check(given, Jwl::valid_parameters()));
  const Law law{products, {}, {}};
  const double V = chapman_jouguet(products).V;
  for (const double share : {0.2, 0.7, 1.}) {
    auto h = law.initial(1630, 6e9 / 1630, true);
    h.lighting_time = 1;
    Strain in = strain(1630, 1630 / (1 - share * (1 - V)));
    law.advance_burn(in, h);
    EXPECT_NEAR(h.burned, share, 1e-12);
  }
}

TEST(Burning, LetsNothingPressBeforeItIsLit) {
  const Law law = tnt("program");
  auto h = law.initial(1630, 6e9 / 1630, true);
  h.lighting_time = 1;
  const Response r = law.update(strain(1630, 1700), {}, h);
  EXPECT_EQ(r.stress[0], 0);
  EXPECT_EQ(h.energy, 6e9 / 1630);
}

}  // namespace
}  // namespace brisance
