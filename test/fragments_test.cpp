#include "drivers/fragments.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "drivers/bins.hpp"
#include "drivers/commands.hpp"
#include "drivers/files.hpp"
#include "drivers/locations.hpp"
#include "drivers/run.hpp"
#include "test/program.hpp"

namespace brisance {
namespace {

constexpr double reach = 1.7;  // the default

ParticleTable empty_plane() {
  ParticleTable t;
  t.dim = 2;
  return t;
}

/// A point of density 2 at rest.
void add(ParticleTable& t, double x, double y, double size, int material = 0) {
  t.x.push_back(x);
  t.y.push_back(y);
  t.vx.push_back(0);
  t.vy.push_back(0);
  t.volume.push_back(size * size);
  t.mass.push_back(2 * size * size);
  t.material.push_back(material);
  for (auto& f : t.fields) f.values.push_back(0);
}

/// columns x rows points, their spacing 1 before the deformation x' = a x + b y, y' = c x + d y.
struct Deformation {
  double a = 1, b = 0, c = 0, d = 1;
  Deformation turned(double angle) const {
    const double cs = std::cos(angle), sn = std::sin(angle);
    return {cs * a - sn * c, cs * b - sn * d, sn * a + cs * c, sn * b + cs * d};
  }
};
void add_lattice(ParticleTable& t, int columns, int rows, const Deformation& f, double x0 = 0,
                 double spacing = 1) {
  const double size = spacing * std::sqrt(f.a * f.d - f.b * f.c);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = x0 + spacing * (i + 0.5), y = spacing * (j + 0.5);
      add(t, f.a * x + f.b * y, f.c * x + f.d * y, size);
    }
}

std::size_t count(const ParticleTable& t) {
  return find_fragments(t, 0, reach, true).pieces.size();
}

TEST(Fragments, OfADeformedLatticeAreOneAtAnyAngle) {
  for (const Deformation& f : {Deformation{1, 0, 0, 1},
                               {1.4, 0, 0, 1},
                               {1.4, 0, 0, 1 / 1.4},
                               {0.6, 0, 0, 1},
                               {1, 0.4, 0, 1},
                               {1.4, 0, 0, 1.4}})
    for (const double angle : {0., 0.3, 0.785398, 1.1}) {
      ParticleTable t = empty_plane();
      add_lattice(t, 9, 6, f.turned(angle));
      EXPECT_EQ(count(t), 1u) << f.a << " " << f.b << " " << f.d << ", turned by " << angle;
    }
}

// With one and with two points along a cell.
TEST(Fragments, AreApartBeyondAnEmptyCellAtAnyAngle) {
  for (const double spacing : {1., 0.5})
    for (const double angle : {0., 0.3, 0.785398, 1.1}) {
      ParticleTable t = empty_plane();
      const int n = static_cast<int>(4 / spacing);
      add_lattice(t, n, n, Deformation{}.turned(angle), 0, spacing);
      add_lattice(t, n, n, Deformation{}.turned(angle), 5, spacing);
      EXPECT_EQ(count(t), 2u) << spacing << ", turned by " << angle;
    }
}

TEST(Fragments, AreNumberedByMassThenByPlace) {
  ParticleTable t = empty_plane();
  add_lattice(t, 2, 2, {}, 20);
  add_lattice(t, 2, 2, {}, 10);
  add_lattice(t, 3, 2, {}, 30);
  const Fragments found = find_fragments(t, 0, reach, true);
  ASSERT_EQ(found.pieces.size(), 3u);
  EXPECT_EQ(found.pieces[0].points, 6);
  EXPECT_EQ(found.pieces[1].centre[0], 11);
  EXPECT_EQ(found.pieces[2].centre[0], 21);
}

TEST(Fragments, InRigidMotionHaveItsVelocityAndSpinAndNoRest) {
  ParticleTable t = empty_plane();
  add_lattice(t, 6, 2, Deformation{}.turned(0.5), 4);
  const double spin = -3, u = 7, v = 2;
  for (std::size_t k = 0; k < t.size(); ++k) {
    t.vx[k] = u - spin * t.y[k];
    t.vy[k] = v + spin * t.x[k];
  }
  const Fragment f = find_fragments(t, 0, reach, true).pieces.at(0);
  EXPECT_NEAR(f.spin, spin, 1e-13);
  EXPECT_NEAR(f.velocity[0], u - spin * f.centre[1], 1e-12);
  EXPECT_NEAR(f.velocity[1], v + spin * f.centre[0], 1e-12);
  EXPECT_NEAR(f.rest, 0, 1e-12 * f.translation);
  // 12 points of mass 2 about the centre: (6^2 - 1) / 12 + (2^2 - 1) / 12 each.
  EXPECT_NEAR(f.rotation, 0.5 * 9 * 24 * (35 + 3) / 12, 1e-10);
  EXPECT_NEAR(f.length, 6, 1e-12);
  EXPECT_NEAR(f.width, 2, 1e-12);
  EXPECT_NEAR(f.slenderness(), 3, 1e-12);
  EXPECT_NEAR(f.size, std::sqrt(12), 1e-12);
}

TEST(Fragments, ThatSwellHaveNothingButRest) {
  ParticleTable t = empty_plane();
  add_lattice(t, 4, 4, {}, -2);
  for (std::size_t k = 0; k < t.size(); ++k) {
    t.vx[k] = t.x[k];
    t.vy[k] = t.y[k] - 2;
  }
  const Fragments found = find_fragments(t, 0, reach, true);
  EXPECT_NEAR(found.pieces.at(0).rest, found.all.kinetic, 1e-14 * found.all.kinetic);
}

TEST(Fragments, OfOnePointAreAsLongAsThePoint) {
  ParticleTable t = empty_plane();
  add(t, 1, 2, 0.5);
  const Fragment f = find_fragments(t, 0, reach, true).pieces.at(0);
  EXPECT_EQ(f.spin, 0);
  EXPECT_NEAR(f.length, 0.5, 1e-15);
  EXPECT_NEAR(f.slenderness(), 1, 1e-15);
}

TEST(Fragments, AreCutByPointsWithoutStrength) {
  for (const char* field : {"decohesion", "damage", "failed"}) {
    ParticleTable t = empty_plane();
    t.fields = {{field, "-", {}}};
    add_lattice(t, 9, 4, {});
    for (std::size_t k = 0; k < t.size(); ++k) t.fields[0].values[k] = k % 9 == 3 ? 1 : 0.99;
    const Fragments cut = find_fragments(t, 0, reach, true);
    ASSERT_EQ(cut.pieces.size(), 2u) << field;
    EXPECT_EQ(cut.pieces[0].points, 20);
    EXPECT_EQ(cut.pieces[1].points, 12);
    EXPECT_EQ(cut.dust.points, 4);
    EXPECT_EQ(cut.dust.mass, 8);
    EXPECT_EQ(find_fragments(t, 0, reach, false).pieces.size(), 1u) << field;
  }
}

TEST(Fragments, OfABarOnALine) {
  ParticleTable t;
  for (const double x : {0.5, 1.5, 2.5, 4.5, 5.5}) {
    add(t, x, 0, 1);
    t.vx.back() = x < 4 ? 1 : 3;
  }
  const Fragments found = find_fragments(t, 0, reach, true);
  ASSERT_EQ(found.pieces.size(), 2u);
  EXPECT_NEAR(found.pieces[0].length, 3, 1e-14);
  EXPECT_EQ(found.pieces[1].speed(), 3);
  EXPECT_TRUE(std::isnan(found.pieces[1].slenderness()));
}

/// Points of any size, motion and state in a square of the edge 40; every fifth is of material 1.
ParticleTable scattered() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  ParticleTable t = empty_plane();
  t.fields = {{"decohesion", "-", {}}};
  for (int k = 0; k < 900; ++k) {
    add(t, 40 * any(random), 40 * any(random), 0.2 + 1.3 * any(random), k % 5 == 0);
    t.vx.back() = any(random) - 0.2;
    t.vy.back() = any(random) - 0.5;
    t.fields[0].values.back() = any(random) < 0.2 ? 1 : 0;
  }
  return t;
}

TEST(Fragments, AndDustAddUpToTheMaterial) {
  const ParticleTable t = scattered();
  const Fragments found = find_fragments(t, 0, reach, true);
  EXPECT_GT(found.pieces.size(), 10u);
  EXPECT_EQ(found.all.points, 720);
  long points = found.dust.points;
  for (const Fragment& f : found.pieces) points += f.points;
  EXPECT_EQ(points, found.all.points);
  EXPECT_LT(found.mass_error(), 1e-13);
  EXPECT_LT(found.momentum_error(), 1e-13);
  EXPECT_LT(found.energy_error(), 1e-13);
}

// Against all pairs: names spread from point to point until none changes.
TEST(Fragments, AreThoseOfTheirDefinition) {
  const ParticleTable t = scattered();
  std::vector<std::size_t> name(t.size());
  std::iota(name.begin(), name.end(), 0);
  const auto sound = [&](std::size_t k) { return t.material[k] == 0 && t.fields[0].values[k] < 1; };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t a = 0; a < t.size(); ++a)
      for (std::size_t b = 0; b < t.size(); ++b) {
        const double near = reach * 0.5 * (point_size(t, a) + point_size(t, b));
        if (!sound(a) || !sound(b) || std::hypot(t.x[a] - t.x[b], t.y[a] - t.y[b]) >= near)
          continue;
        changed = changed || name[a] != name[b];
        name[a] = name[b] = std::min(name[a], name[b]);
      }
  }
  std::size_t pieces = 0;
  for (std::size_t k = 0; k < t.size(); ++k) pieces += sound(k) && name[k] == k;
  EXPECT_EQ(count(t), pieces);
}

TEST(Fragments, ThatHaveFlownFarAreFoundInFewBins) {
  ParticleTable t = empty_plane();
  add_lattice(t, 3, 3, {});
  add_lattice(t, 3, 3, {}, 1e9);
  EXPECT_EQ(count(t), 2u);
}

TEST(Fragments, OfNothingAreNone) {
  ParticleTable t = empty_plane();
  add(t, 0, 0, 1, 1);
  EXPECT_EQ(count(t), 0u);
  EXPECT_EQ(find_fragments(t, 0, reach, true).mass_error(), 0);
}

FragmentWatch watch(double least_mass, double at = 0) {
  List given;
  given.set("material", "steel").set("least mass", least_mass).set("at", at);
  const WatchedMaterials materials{{"steel", "air"}, {false, true}};
  return {check(given, FragmentWatch::valid_parameters(materials.names)), materials};
}

TEST(FragmentWatch, CountsPiecesFromTheLeastMassOn) {
  ParticleTable t = empty_plane();
  add_lattice(t, 2, 3, {});
  add_lattice(t, 2, 2, {}, 10);
  add_lattice(t, 1, 1, {}, 20);
  for (std::size_t k = 0; k < t.size(); ++k) t.vy[k] = k < 6 ? 1 : k < 10 ? 4 : 9;
  std::map<std::string, double> value;
  FragmentWatch seen = watch(5);
  seen.observe(t, 0.25);
  for (const Measure& m : seen.measures()) value[m.name] = m.value;
  EXPECT_EQ(value.at("fragments"), 2);
  EXPECT_EQ(value.at("largest fragment"), 12);
  EXPECT_EQ(value.at("fastest fragment"), 4);
  EXPECT_EQ(value.at("slowest fragment"), 1);
  EXPECT_NEAR(value.at("mean fragment speed"), (12 * 1 + 8 * 4) / 20., 1e-15);
  EXPECT_NEAR(value.at("fragment slenderness"), (12 * 1.5 + 8 * 1) / 20., 1e-14);

  const test::Folder folder("fragment_watch");
  std::filesystem::create_directories(folder.path);
  seen.write(folder.path, nullptr);
  const std::string text = read_file(folder.path / "fragments.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
  EXPECT_NE(text.find("\n0.25,1,6,12,1,1.5,0,1,0,6,0,0,"), std::string::npos) << text;
}

TEST(FragmentWatch, TellsOfTheFirstOutputPastItsTime) {
  FragmentWatch seen = watch(0, 0.5);
  for (const double time : {0.25, 0.6, 0.8}) {
    ParticleTable t = empty_plane();
    add_lattice(t, 1, 1, {});
    t.vy[0] = time;
    seen.observe(t, time);
  }
  for (const Measure& m : seen.measures())
    if (m.name == "fastest fragment") {
      EXPECT_EQ(m.value, 0.6);
    }
}

TEST(FragmentWatch, RefusesAGas) {
  List given;
  given.set("material", "air");
  const WatchedMaterials materials{{"steel", "air"}, {false, true}};
  const List list = check(given, FragmentWatch::valid_parameters(materials.names));
  EXPECT_THROW(FragmentWatch(list, materials), InputError);
}

// Two discs that fly freely: each keeps its speed, and the sum of masses is the material's.
TEST(FragmentWatch, SeesTwoDiscsFlyInARun) {
  const std::string file = (data_folder() / "inputs" / "elastic_discs.xml").string();
  const List scene = load_scene({file,
                                 {},
                                 {"grid/cells={48, 48}", "grid/cell size=0.025", "time/end=0.3",
                                  "bodies/upper/material=lower", "fragments/material=lower"}});
  const test::Folder folder("fragments_of_a_run");
  const RunResult result = run(scene, {folder.path, true});
  std::map<std::string, double> value;
  for (const Measure& m : result.outcome.measures) value[m.name] = m.value;
  EXPECT_EQ(value.at("fragments"), 2);
  EXPECT_NEAR(2 * value.at("largest fragment"), result.end.totals.mass,
              1e-12 * result.end.totals.mass);
  for (const char* name : {"fastest fragment", "slowest fragment", "mean fragment speed"})
    EXPECT_NEAR(value.at(name), 0.1 * std::sqrt(2), 1e-10) << name;
  EXPECT_NEAR(value.at("fragment slenderness"), 1, 0.01);
  EXPECT_LT(value.at("fragment mass error"), 1e-13);
  const std::string text = read_file(folder.path / "fragments.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 2 * 4) << text;
}

}  // namespace
}  // namespace brisance
