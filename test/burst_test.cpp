#include "drivers/burst.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <map>

#include "drivers/input.hpp"
#include "drivers/run.hpp"
#include "drivers/scene.hpp"

namespace brisance {
namespace {

using Centre = std::array<double, 3>;

/// A plane of 20 x 20 cells of the edge 1 about the origin.
ParticleTable plane() {
  ParticleTable t;
  t.dim = 2;
  t.cell_size = 1;
  t.origin = {-10, -10, 0};
  t.cells = {20, 20, 1};
  return t;
}

void add(ParticleTable& t, double x, double y, int material = 0, double size = 1, double mass = 1) {
  t.x.push_back(x);
  t.y.push_back(y);
  t.vx.push_back(0);
  t.vy.push_back(0);
  t.mass.push_back(mass);
  t.volume.push_back(size * size);
  t.material.push_back(material);
  for (auto& f : t.fields) f.values.push_back(0);
}

/// A point and its images under the symmetries of the square, flying outward.
void add_images(ParticleTable& t, double x, double y) {
  for (const double a : {-1, 1})
    for (const double b : {-1, 1})
      for (const bool swap : {false, true}) {
        add(t, swap ? b * y : a * x, swap ? a * x : b * y);
        t.vx.back() = 3 * t.x.back();
        t.vy.back() = 3 * t.y.back();
      }
}

TEST(Box, OutwardVelocityIsTheMeanByMass) {
  ParticleTable t = plane();
  add(t, 4, 2, 0, 1, 1);
  t.vx.back() = 5;
  add(t, 1, -2, 0, 1, 3);
  t.vy.back() = -7;
  t.vx.back() = 1;  // outward is -y
  add(t, 0, 0, 1);
  t.vx.back() = 100;  // of another material
  EXPECT_NEAR(outward_velocity(t, 0, {1, 2, 0}), (5 + 3 * 7) / 4., 1e-15);
  EXPECT_TRUE(std::isnan(outward_velocity(t, 2, {})));
}

TEST(Box, ImagesUnderTheSymmetriesOfTheSquareHaveNoAsymmetry) {
  ParticleTable t = plane();
  add_images(t, 3.3, 1.2);
  add_images(t, 6, 4);  // on lines of the lattice, but for round-off
  for (std::size_t k = 8; k < 16; ++k) t.x[k] += k % 3 == 0 ? 1e-14 : -1e-14;
  EXPECT_LT(four_fold_asymmetry(t, {}), 1e-12);
}

TEST(Box, APointWithoutImagesIsAllAsymmetry) {
  ParticleTable t = plane();
  add(t, 4, 2);
  EXPECT_NEAR(four_fold_asymmetry(t, {}), 1, 1e-15);
}

TEST(Box, AnAsymmetryOfMotionAloneIsSeen) {
  ParticleTable t = plane();
  add_images(t, 4, 2);
  for (auto* v : {&t.vx, &t.vy}) (*v)[0] = 0;
  // 7 of 8 move: of 56 ordered pairs 14 differ wholly, 42 are twice the same.
  EXPECT_NEAR(four_fold_asymmetry(t, {}), 14 / (14 + 2 * 42.), 1e-14);
}

TEST(Box, AQuarterHasOnlyItsDiagonal) {
  ParticleTable t = plane();
  add(t, -6, -8);
  add(t, -8, -6);
  EXPECT_NEAR(four_fold_asymmetry(t, {-10, -10, 0}), 0, 1e-15);
  add(t, -3, -4, 0, 1, 2);
  EXPECT_NEAR(four_fold_asymmetry(t, {-10, -10, 0}), 4. / 8, 1e-15);
}

/// Solid below y = 0 on a lattice of the spacing 0.5, one point of fluid at a depth.
ParticleTable half_plane(double depth, double fluid_size) {
  ParticleTable t = plane();
  for (int j = 0; j < 8; ++j)
    for (int i = -8; i < 8; ++i) add(t, 0.5 * i + 0.25, -0.5 * j - 0.25, 0, 0.5);
  add(t, 0.25, -depth, 1, fluid_size);
  return t;
}

TEST(Box, FluidCountsAsInterpenetratingFromHalfASpacingOn) {
  for (const double size : {0.1, 0.5, 20.}) {
    EXPECT_EQ(overlap_of(half_plane(0.3 * 0.5, size), {false, true}).share, 0);
    EXPECT_EQ(overlap_of(half_plane(0.5 * 0.5, size), {false, true}).share, 1);
    EXPECT_EQ(overlap_of(half_plane(3.1 * 0.5, size), {false, true}).share, 1);
  }
  ParticleTable t = half_plane(0.5, 0.5);
  add(t, 0, 5, 1, 0.5, 3);
  EXPECT_NEAR(overlap_of(t, {false, true}).share, 1 / 4., 1e-15);
}

TEST(Box, FluidThatTouchesASolidDoesNotOverlapIt) {
  EXPECT_NEAR(overlap_of(half_plane(-0.25, 0.5), {false, true}).greatest, 0, 1e-15);
  EXPECT_NEAR(overlap_of(half_plane(-0.125, 0.25), {false, true}).greatest, 0, 1e-15);
  // 0.2 above the face, 0.45 above the point of a solid: expanded gas is no closer than other gas.
  for (const double size : {0.5, 50.})
    EXPECT_NEAR(overlap_of(half_plane(-0.2, size), {false, true}).greatest, 1 - 0.9, 1e-14);
  EXPECT_EQ(overlap_of(half_plane(-2, 50), {false, true}).greatest, 0);
}

TEST(Box, NearnessIsOfTwoMaterials) {
  ParticleTable t = plane();
  add(t, 0, 0, 0);
  add(t, 3, 4, 1);
  add(t, 0.1, 0, 2);
  EXPECT_TRUE(within(t, 0, 1, 5.001));
  EXPECT_FALSE(within(t, 0, 1, 4.999));
  EXPECT_FALSE(within(t, 0, 3, 5));
}

/// A box of inner faces at 8, two thick, failed where `failed` says so.
template <class F>
ParticleTable box(const F& failed) {
  ParticleTable t = plane();
  t.fields = {{"damage", "-", {}}, {"decohesion", "-", {}}};
  for (int j = -10; j < 10; ++j)
    for (int i = -10; i < 10; ++i) {
      const double x = i + 0.5, y = j + 0.5;
      if (std::max(std::abs(x), std::abs(y)) < 8) continue;
      add(t, x, y);
      if (failed(x, y)) t.fields[0].values.back() = t.fields[1].values.back() = 0.5;
    }
  return t;
}

TEST(Box, AWallThatFailsEverywhereFailsUniformly) {
  const WallDamage d = wall_damage(box([](double, double) { return true; }), 0, {}, 8);
  EXPECT_NEAR(d.share, 1, 1e-15);
  EXPECT_NEAR(d.spread, 1, 1e-15);
  EXPECT_EQ(d.length, 1);
  EXPECT_NEAR(d.near_middle, 4 * 8 * 2 / 144., 1e-15);
}

TEST(Box, AWallThatFailsInOnePartOfAFaceIsLocalised) {
  const ParticleTable t = box([](double x, double y) { return x > 0 && std::abs(y - 0.5) < 0.1; });
  const WallDamage d = wall_damage(t, 0, {}, 8);
  EXPECT_NEAR(d.share, 2 / 144., 1e-15);
  EXPECT_NEAR(d.spread, 1 / 64., 1e-15);
  EXPECT_EQ(d.length, 1 / 64.);
  EXPECT_NEAR(d.near_middle, 1, 1e-15);
}

TEST(Box, CornersOfAWallAreFarFromTheMiddle) {
  const auto corner = [](double x, double y) { return std::min(std::abs(x), std::abs(y)) > 5; };
  EXPECT_EQ(wall_damage(box(corner), 0, {}, 8).near_middle, 0);
}

TEST(Box, AQuarterOfAWallHasTheSameNumbers) {
  const auto some = [](double x, double y) { return std::min(std::abs(x), std::abs(y)) < 3; };
  const ParticleTable all = box(some);
  ParticleTable part = plane();
  part.fields = {{"damage", "-", {}}, {"decohesion", "-", {}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all.x[k] < 0 || all.y[k] < 0) continue;
    add(part, all.x[k], all.y[k]);
    for (int f : {0, 1}) part.fields[f].values.back() = all.fields[f].values[k];
  }
  const WallDamage a = wall_damage(all, 0, {}, 8), b = wall_damage(part, 0, {}, 8);
  EXPECT_NEAR(a.near_middle, b.near_middle, 1e-14);
  EXPECT_NEAR(a.share, b.share, 1e-14);
  EXPECT_NEAR(a.spread, b.spread, 1e-14);
  EXPECT_NEAR(a.length, b.length, 1e-14);
}

TEST(Box, AWallThatCannotFailHasNoPlaceOfFailure) {
  ParticleTable t = box([](double, double) { return true; });
  t.fields.clear();
  const WallDamage d = wall_damage(t, 0, {}, 8);
  EXPECT_EQ(d.share, 0);
  EXPECT_TRUE(std::isnan(d.near_middle) && std::isnan(d.spread));
}

const WatchedMaterials materials{{"wall", "case", "products"}, {false, false, true}};

List burst_list(const List& given) {
  return check(given, BurstWatch::valid_parameters(materials.names, 2));
}

List usual() {
  List given;
  given.set("wall", "wall").set("case", "case").set("products", "products").set("inner face", 8.);
  return given;
}

std::map<std::string, double> values(const Watch& watch) {
  std::map<std::string, double> value;
  for (const Measure& m : watch.measures()) value[m.name] = m.value;
  return value;
}

TEST(BurstWatch, RemembersTheGreatestAndTheFirst) {
  BurstWatch watch(burst_list(usual()), materials);
  const double speeds[] = {0, 5, 3, 1}, places[] = {2, 5, 7.6, 8}, gas[] = {1, 7.6, 8.45, 1};
  for (int n = 0; n < 4; ++n) {
    ParticleTable t = box([](double, double) { return false; });
    add(t, places[n], 0.5, 1);
    t.vx.back() = speeds[n];
    add(t, -gas[n], 0.5, 2);
    watch.observe(t, n);
  }
  const auto value = values(watch);
  EXPECT_NEAR(value.at("case velocity"), 5 * 5 / std::hypot(5, 0.5), 1e-14);
  EXPECT_EQ(value.at("case velocity time"), 1);
  EXPECT_EQ(value.at("fragments reach wall"), 2);
  EXPECT_EQ(value.at("products reach wall"), 1);
  EXPECT_EQ(value.at("interpenetration"), 1);  // at time 2
  EXPECT_NEAR(value.at("greatest overlap"), 0.95, 1e-14);
}

TEST(BurstWatch, LooksAtSymmetryUntilItsTime) {
  List given = usual();
  BurstWatch until_half(burst_list(List(given).set("symmetric until", 0.5)), materials);
  BurstWatch always(burst_list(given), materials);
  ParticleTable t = box([](double, double) { return false; });
  for (BurstWatch* watch : {&until_half, &always}) watch->observe(t, 0.5);
  add(t, 2, 1, 1);
  for (BurstWatch* watch : {&until_half, &always}) watch->observe(t, 0.6);
  EXPECT_LT(values(until_half).at("four-fold asymmetry"), 1e-15);
  EXPECT_GT(values(always).at("four-fold asymmetry"), 1e-3);
}

TEST(BurstWatch, OfABareChargeMeasuresNoCase) {
  List given;
  given.set("wall", "wall").set("inner face", 8.);
  const auto value = values(BurstWatch(burst_list(given), materials));
  for (const char* name : {"case velocity", "fragments reach wall", "products reach wall"})
    EXPECT_EQ(value.count(name), 0u) << name;
}

TEST(BurstWatch, RefusesMaterialsThatDoNotFit) {
  for (const auto& [name, material] : std::vector<std::pair<std::string, std::string>>{
           {"wall", "products"}, {"case", "products"}, {"case", "wall"}, {"products", "wall"}})
    EXPECT_THROW(BurstWatch(burst_list(usual().set(name, material)), materials), InputError)
        << name << " of " << material;
}

/// Compressed gas in a ring of steel in a box of concrete; 30 x 30 cells of 50 mm.
const char* const bomb = R"xml(
<ParameterList name="bomb">
  <Parameter name="geometry" type="string" value="plane strain"/>
  <ParameterList name="grid">
    <Parameter name="origin" type="Array(double)" value="{-0.75, -0.75}"/>
    <Parameter name="cells" type="Array(int)" value="{30, 30}"/>
    <Parameter name="cell size" type="double" value="0.05"/>
  </ParameterList>
  <ParameterList name="time"><Parameter name="end" type="double" value="3e-4"/></ParameterList>
  <ParameterList name="materials">
    <ParameterList name="concrete"><Parameter name="law" type="string" value="concrete"/></ParameterList>
    <ParameterList name="gas"><Parameter name="law" type="string" value="perfect gas"/><Parameter name="gamma" type="double" value="1.4"/></ParameterList>
    <ParameterList name="steel">
      <Parameter name="law" type="string" value="von mises"/>
      <Parameter name="Young's modulus" type="double" value="200e9"/>
      <Parameter name="Poisson's ratio" type="double" value="0.29"/>
      <Parameter name="density" type="double" value="7850"/>
      <Parameter name="yield stress" type="double" value="500e6"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="bodies">
    <ParameterList name="charge">
      <Parameter name="material" type="string" value="gas"/>
      <Parameter name="edge" type="string" value="points"/>
      <Parameter name="density" type="double" value="1000"/>
      <Parameter name="pressure" type="double" value="1e9"/>
      <ParameterList name="disc"><Parameter name="centre" type="Array(double)" value="{0, 0}"/><Parameter name="radius" type="double" value="0.15"/></ParameterList>
    </ParameterList>
    <ParameterList name="ring">
      <Parameter name="material" type="string" value="steel"/>
      <Parameter name="particles per cell" type="int" value="2"/>
      <ParameterList name="disc"><Parameter name="centre" type="Array(double)" value="{0, 0}"/><Parameter name="radius" type="double" value="0.25"/></ParameterList>
    </ParameterList>
    <ParameterList name="air">
      <Parameter name="material" type="string" value="gas"/>
      <Parameter name="particles per cell" type="int" value="2"/>
      <Parameter name="density" type="double" value="1.29"/>
      <Parameter name="pressure" type="double" value="1e5"/>
      <ParameterList name="box"><Parameter name="low" type="Array(double)" value="{-0.5, -0.5}"/><Parameter name="high" type="Array(double)" value="{0.5, 0.5}"/></ParameterList>
    </ParameterList>
    <ParameterList name="box">
      <Parameter name="material" type="string" value="concrete"/>
      <Parameter name="particles per cell" type="int" value="2"/>
      <ParameterList name="box"><Parameter name="low" type="Array(double)" value="{-0.6, -0.6}"/><Parameter name="high" type="Array(double)" value="{0.6, 0.6}"/></ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="burst">
    <Parameter name="wall" type="string" value="concrete"/>
    <Parameter name="case" type="string" value="steel"/>
    <Parameter name="inner face" type="double" value="0.5"/>
    <Parameter name="symmetric until" type="double" value="2e-4"/>
  </ParameterList>
  <ParameterList name="fragments"><Parameter name="material" type="string" value="steel"/></ParameterList>
  <ParameterList name="checks">
    <ParameterList name="four-fold asymmetry"><Parameter name="most" type="double" value="1e-9"/></ParameterList>
    <ParameterList name="case velocity"><Parameter name="least" type="double" value="50"/></ParameterList>
    <ParameterList name="fragments"><Parameter name="least" type="double" value="1"/></ParameterList>
    <ParameterList name="fragment energy error"><Parameter name="most" type="double" value="1e-12"/></ParameterList>
  </ParameterList>
</ParameterList>)xml";

List scene_of(const std::string& text) {
  return complete_scene(*parse_input(text, "bomb.xml").list);
}

TEST(BurstWatch, IsMeasuredAndCheckedInARun) {
  const RunResult result = run(scene_of(bomb), {{}, true});
  EXPECT_EQ(result.outcome.verdicts.size(), 4u);
  EXPECT_TRUE(all_reached(result.outcome.verdicts));
  std::map<std::string, double> value;
  for (const Measure& m : result.outcome.measures) value[m.name] = m.value;
  // All energy of the charge in the case would give it this velocity.
  const double energy = 1e9 / 0.4 * 3.1416 * 0.15 * 0.15,
               steel = 7850 * 3.1416 * (0.25 * 0.25 - 0.15 * 0.15);
  EXPECT_LT(value.at("case velocity"), 1.1 * std::sqrt(2 * energy / steel));
}

TEST(BurstWatch, NeedsAPlane) {
  const std::string line = R"xml(
<ParameterList name="line">
  <Parameter name="geometry" type="string" value="line"/>
  <ParameterList name="grid"><Parameter name="cells" type="Array(int)" value="{8}"/><Parameter name="cell size" type="double" value="0.1"/></ParameterList>
  <ParameterList name="time"><Parameter name="end" type="double" value="1e-6"/></ParameterList>
  <ParameterList name="materials"><ParameterList name="wall"><Parameter name="law" type="string" value="concrete"/></ParameterList></ParameterList>
  <ParameterList name="bodies"><ParameterList name="wall"><Parameter name="material" type="string" value="wall"/></ParameterList></ParameterList>
  <ParameterList name="burst"><Parameter name="wall" type="string" value="wall"/><Parameter name="inner face" type="double" value="0.5"/></ParameterList>
</ParameterList>)xml";
  EXPECT_THROW(scene_of(line), InputError);
}

}  // namespace
}  // namespace brisance
