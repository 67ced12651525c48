// What the law of every solid must obey, whatever it models. A new one is tested by being listed in
// the registry, and by a sample of its parameters below.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "materials/registry.hpp"
#include "test/as_types.hpp"

namespace brisance {
namespace {

List sample_of(const std::string& law) {
  List list;
  if (law == "concrete") return list;
  list.set("Young's modulus", 200e9).set("Poisson's ratio", 0.29).set("density", 7850.);
  if (law == "elastic") return list;
  if (law == "von mises") return list.set("yield stress", 500e6);
  if (law == "drucker prager") return list.set("compressive strength", 28e6);
  throw std::logic_error("add a sample of '" + law + "' to this test");
}

template <class Law>
class EverySolid : public testing::Test {
 protected:
  List list = sample_of(Law::name);
  Law law{check(list, Law::valid_parameters(list))};

  /// A strain along x in one step.
  Strain strain(double size) const {
    Strain in;
    in.dt = 1e-6;
    in.rate[0] = size / in.dt;
    in.rho0 = law.density();
    in.rho1 = in.rho0 / (1 + size);
    in.h = 0.01;
    return in;
  }
};
TYPED_TEST_SUITE(EverySolid, AsTypes<Solids>::type);

// c^2 rho = d(sxx) / d(exx), from a strain so small that nothing yields.
TYPED_TEST(EverySolid, SoundSpeedIsItsStiffness) {
  typename TypeParam::History h = this->law.initial(this->law.density(), 0, false);
  const double c = this->law.sound_speed(this->law.density(), h);
  const Response r = this->law.update(this->strain(-1e-8), {}, h);
  EXPECT_NEAR(-r.stress[0] / 1e-8 / (c * c * this->law.density()), 1, 1e-9);
  EXPECT_NEAR(this->law.signal_speed({}, this->law.density(), c, 0.01), c, 1e-12 * c);
}

TYPED_TEST(EverySolid, StaysAsItIsWithoutStrain) {
  typename TypeParam::History h = this->law.initial(this->law.density(), 0, false);
  const Sym3 stress{{-2e6, -1e6, -1.5e6, 1e5, 0, 0}};
  const Response r = this->law.update(this->strain(0), stress, h);
  // Twice through the moduli: a few roundings of the largest stress.
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(r.stress[k], stress[k], 1e-8);
}

TYPED_TEST(EverySolid, GivesBackWhatIsElastic) {
  typename TypeParam::History h = this->law.initial(this->law.density(), 0, false);
  const Response in = this->law.update(this->strain(-1e-6), {}, h);
  const Energies stored = this->law.energies(in.stress, this->law.density(), h);
  const double work = -0.5 * in.stress[0] * 1e-6 / this->law.density();
  EXPECT_NEAR(stored.elastic / work, 1, 1e-9);
  EXPECT_EQ(stored.plastic + stored.damage + stored.decohesion, 0);
}

// The method adds to it what a point receives.
TYPED_TEST(EverySolid, LeavesTheLedgerAlone) {
  typename TypeParam::History h = this->law.initial(this->law.density(), 0, false);
  h.energy = 7;
  this->law.update(this->strain(-0.01), {}, h);
  EXPECT_EQ(h.energy, 7);
  EXPECT_EQ(TypeParam::energy(h), 7);
  EXPECT_TRUE(std::any_of(std::begin(TypeParam::fields), std::end(TypeParam::fields),
                          [](const auto& f) { return std::string(f.name) == "energy"; }));
}

}  // namespace
}  // namespace brisance
