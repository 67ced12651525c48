// What every law in the registry must obey, whatever it models. A new one is tested by being listed
// there, and by a sample of its parameters below.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "core/parameters.hpp"
#include "materials/fluid.hpp"
#include "materials/registry.hpp"
#include "test/as_types.hpp"
#include "test/explosive.hpp"

namespace brisance {
namespace {

/// Parameters of a law by its name, and a state in which it is at home.
struct Sample {
  List list;
  double rho = 1, energy = 1;
};
Sample sample_of(const std::string& law) {
  Sample s;
  if (law == "perfect gas") {
    s.list.set("gamma", 1.4);
    s.rho = 1.29;
    s.energy = 2e5;
    return s;
  }
  if (law == "linear fluid") {  // compressed by a tenth, with the elastic energy of that
    s.list.set("bulk modulus", 2e9).set("density", 1000.);
    s.rho = 1100;
    s.energy = LinearFluid(2e9, 1000).elastic_energy(1100);
    return s;
  }
  if (law == "jwl") {
    s.list = test::tnt();
    s.rho = 1630;
    s.energy = 6e9 / 1630;
    return s;
  }
  throw std::logic_error("add a sample of '" + law + "' to this test");
}

template <class Eos>
class EveryMaterial : public testing::Test {
 protected:
  Sample sample = sample_of(Eos::name);
  Eos eos{check(sample.list, Eos::valid_parameters())};
  using Law = Fluid<Eos, Inviscid, NoShockViscosity>;
  Law law{eos, {}, {}};

  double pressure(double rho, double e) const { return eos.offset(rho) + eos.slope(rho) * e; }

  Strain strain(double compression) const {
    Strain in;
    in.dt = 1e-6;
    in.rho0 = sample.rho;
    in.rho1 = sample.rho * compression;
    in.rate[0] = (1 / compression - 1) / in.dt;
    in.volume_change = 1 / in.rho1 - 1 / in.rho0;
    in.h = 0.01;
    return in;
  }
};
TYPED_TEST_SUITE(EveryMaterial, AsTypes<Fluids>::type);

TYPED_TEST(EveryMaterial, IsInTheSchemaUnderItsName) {
  const auto names = law_names();
  EXPECT_EQ(std::count(names.begin(), names.end(), TypeParam::name), 1);
  List given = this->sample.list;
  given.set("law", TypeParam::name);
  List shock;
  const List checked = check(given, valid_material(given, shock));
  EXPECT_EQ(get<std::string>(checked, "law"), TypeParam::name);
}

TYPED_TEST(EveryMaterial, AsksForUnitsAndRules) {
  const List valid = TypeParam::valid_parameters();
  for (const auto& name : names(valid)) {
    const Described d = described(valid, name);
    EXPECT_FALSE(d.unit.empty()) << name;
    EXPECT_FALSE(d.rule.empty()) << name;
  }
}

// rho c^2 = rho dp/drho + (p / rho) dp/de, with differences over 1e-5: good to 1e-10 of it.
TYPED_TEST(EveryMaterial, SoundSpeedIsItsStiffness) {
  const double small = 1e-5;
  for (const double compression : {0.5, 1., 2.})
    for (const double heat : {0.1, 1., 30.}) {
      const double rho = compression * this->sample.rho, e = heat * this->sample.energy;
      const double by_rho =
          (this->pressure(rho * (1 + small), e) - this->pressure(rho * (1 - small), e)) /
          (2 * small * rho);
      const double by_e =
          (this->pressure(rho, e * (1 + small)) - this->pressure(rho, e * (1 - small))) /
          (2 * small * e);
      const double stiffness = by_rho + this->pressure(rho, e) / (rho * rho) * by_e;
      EXPECT_NEAR(this->eos.sound_speed2(rho, e) / stiffness, 1, 1e-9);
    }
}

TYPED_TEST(EveryMaterial, StaysAsItIsWithoutStrain) {
  typename TestFixture::Law::History h{this->sample.energy};
  const Response before = this->law.state(this->sample.rho, h);
  const Response after = this->law.update(this->strain(1), before.stress, h);
  EXPECT_EQ(h.energy, this->sample.energy);
  EXPECT_EQ(after.sound_speed, before.sound_speed);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(after.stress[k], before.stress[k]);
}

TYPED_TEST(EveryMaterial, StartsAtThePressureItIsGiven) {
  const double p = this->pressure(this->sample.rho, this->sample.energy);
  const auto h = this->law.initial(this->sample.rho, p, false);
  EXPECT_NEAR(h.energy / this->sample.energy, 1, 1e-14);
}

// (A.19)-(A.22): guess e from p0, then repeat p = p(rho1, e), e = e0 - ((p0 + p)/2 + q) dv. It
// contracts by |slope dv / 2| <= 0.2 a round here: 40 rounds leave less than round-off.
TYPED_TEST(EveryMaterial, EnergyInClosedFormIsTheFixedPointOfTheIteration) {
  using Shocked = Fluid<TypeParam, Inviscid, ShockViscosity>;
  const Shocked shocked{this->eos, {}, ShockViscosity()};
  for (const double compression : {0.7, 0.99, 1.01, 1.3, 1.8}) {
    const Strain in = this->strain(compression);
    const double e0 = this->sample.energy;
    typename Shocked::History h{e0};
    const Response before = shocked.state(in.rho0, h);
    const double p0 = -before.stress[0];
    const double q = shocked.shock.pressure(in.rho0, shocked.strength(in.rho0, h),
                                            before.sound_speed, this->eos.shock_slope(), in);
    double e = e0 - (p0 + q) * in.volume_change;
    for (int round = 0; round < 40; ++round)
      e = e0 - (0.5 * (p0 + this->pressure(in.rho1, e)) + q) * in.volume_change;
    const Response after = shocked.update(in, before.stress, h);
    EXPECT_NEAR(h.energy / e, 1, 1e-14);
    EXPECT_NEAR(-after.stress[0] / (this->pressure(in.rho1, e) + q), 1, 1e-14);
  }
}

TYPED_TEST(EveryMaterial, ShockHeatsMoreThanSlowCompression) {
  const Strain in = this->strain(1.5);
  typename TestFixture::Law::History slow{this->sample.energy}, fast = slow;
  const Sym3 stress = this->law.state(in.rho0, slow).stress;
  this->law.update(in, stress, slow);
  const Fluid<TypeParam, Inviscid, ShockViscosity> shocked{this->eos, {}, ShockViscosity()};
  typename decltype(shocked)::History h{fast.energy};
  shocked.update(in, stress, h);
  EXPECT_GT(h.energy, slow.energy);
}

}  // namespace
}  // namespace brisance
