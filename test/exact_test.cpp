#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <set>

#include "drivers/exact.hpp"

namespace brisance {
namespace {

// Central differences of the conserved quantities and their fluxes in place and time. `scale`: the
// size of a rate.
void expect_euler(const ExactSolution& exact, const Place& x, double t, double step,
                  double time_step, double scale) {
  const auto conserved = [](const MatterState& g) {
    const double v2 = g.v[0] * g.v[0] + g.v[1] * g.v[1] + g.v[2] * g.v[2];
    return std::array<double, 5>{g.rho, g.rho * g.v[0], g.rho * g.v[1], g.rho * g.v[2],
                                 g.rho * (g.e + 0.5 * v2)};
  };
  std::array<double, 5> rate{};
  const auto after = conserved(exact.at(x, t + time_step)),
             before = conserved(exact.at(x, t - time_step));
  for (int k = 0; k < 5; ++k) rate[k] = (after[k] - before[k]) / (2 * time_step);
  for (int d = 0; d < 3; ++d)
    for (const int sign : {-1, 1}) {
      Place there = x;
      there[d] += sign * step;
      const MatterState g = exact.at(there, t);
      std::array<double, 5> flux = conserved(g);
      flux[4] += g.p;
      for (double& f : flux) f *= g.v[d];
      flux[1 + d] += g.p;
      for (int k = 0; k < 5; ++k) rate[k] += sign * flux[k] / (2 * step);
    }
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(rate[k], 0, scale) << "equation " << k;
}

TEST(ExactTest, SmoothPartsSatisfyTheEulerEquations) {
  // Scales of 1 throughout: differences over 1e-4 are good to 1e-8 times a third derivative of up
  // to 1e2.
  const Riemann sod(Riemann::Data{{1, 0, 1}, {0.125, 0, 0.1}, 1.4, 0.5});
  expect_euler(sod, {0.4, 0, 0}, 0.2, 1e-4, 1e-4, 1e-6 * 30);
  const Vortex vortex(Vortex::Data{5, 1, 10, 1, 1, 1.4, {{5, 5, 0}}, {{1, 0.5, 0}}});
  for (const double r : {0., 0.4, 1., 1.7})
    expect_euler(vortex, {5.3 + r, 4.9 + 0.7 * r, 0}, 0.3, 1e-4, 1e-4, 1e-6);
  // Interpolated: an error of 1.5e-8 in the table over a distance of 1e-3, times rates of order 10.
  for (const int j : {1, 2, 3}) {
    const Sedov sedov(Sedov::Data{j, 1, 1, 0, 1.4, {}});
    expect_euler(sedov, {0.5, j > 1 ? 0.4 : 0, j > 2 ? 0.3 : 0}, 1, 1e-3, 1e-3, 1e-3);
  }
  // Of first order in the amplitude a: the residual is of order a^2 times the wave number.
  const AcousticWave wave(AcousticWave::Data{1e-4, 1, 1, 1 / 1.4, 0.3, 1.4, 1});
  for (const double x : {0., 0.1, 0.35, 0.8})
    expect_euler(wave, {0, x, 0}, 0.4, 1e-4, 1e-4, 1e-8 * 2 * 3.15 * 5);
}

TEST(AcousticWaveTest, ReturnsAfterOnePeriod) {
  const AcousticWave wave(AcousticWave::Data{1e-3, 2, 1.2, 1e5, -40, 1.4, 0});
  const double c = std::sqrt(1.4 * 1e5 / 1.2);
  EXPECT_DOUBLE_EQ(wave.sound_speed(), c);
  EXPECT_DOUBLE_EQ(wave.features(0)[1].value, 2 / (c - 40));
  const MatterState a = wave.at({0.3, 0, 0}, 0), b = wave.at({0.3, 0, 0}, 2 / (c - 40));
  EXPECT_NEAR(a.rho, b.rho, 1e-15);
  EXPECT_NEAR(a.rho, 1.2 * (1 + 1e-3 * std::sin(0.3 * 3.14159265358979)), 1e-14);
}

TEST(VortexTest, IsCarriedThroughThePeriodicBox) {
  const Vortex vortex(Vortex::Data{5, 1, 10, 1, 1, 1.4, {{5, 5, 0}}, {{1, 1, 0}}});
  const MatterState a = vortex.at({4.2, 6.1, 0}, 0), b = vortex.at({1.2, 3.1, 0}, 7);
  EXPECT_NEAR(a.rho, b.rho, 1e-13);
  EXPECT_NEAR(a.v[1], b.v[1], 1e-13);
  EXPECT_NEAR(vortex.at({5, 6, 0}, 0).v[0], 1 - 5 / (2 * 3.14159265358979), 1e-13);
  EXPECT_THROW(Vortex(Vortex::Data{20, 1, 10, 1, 1, 1.4, {}, {}}), InputError);
}

List example(const std::string& solution) {
  List list("exact");
  list.set("solution", solution);
  if (solution == "standing wave" || solution == "plate impact" || solution == "plastic wave") {
    list.set("density", 1.).set("Young's modulus", 36.).set("Poisson's ratio", 0.25);
    list.set("velocity", 0.1);
    if (solution == "standing wave") list.set("length", 1.);
    if (solution == "plastic wave") list.set("yield stress", 0.01);
    if (solution == "plate impact")
      list.set("low", 0.).set("high", 1.).set("moving from", 0.).set("moving to", 0.6);
    return list;
  }
  if (solution == "detonation") {
    list.set("density", 1630.).set("A", 373.8e9).set("B", 3.747e9).set("R1", 4.15).set("R2", 0.9);
    return list.set("omega", 0.35).set("energy density", 6e9);
  }
  if (solution == "layers") {
    list.set("cell size", 0.1).set("plate", "gas").set("outer end", "free");
    List& gas = list.sublist("layers").sublist("gas");
    gas.set("law", "perfect gas").set("gamma", 1.4).set("thickness", 1.);
    gas.set("density", 1.).set("specific energy", 1.);
    return list;
  }
  if (solution == "piston gas") {
    list.set("density", 7850.).set("Young's modulus", 200e9).set("Poisson's ratio", 0.29);
    list.set("gas density", 1.2).set("gas pressure", 1e6).set("speed", 26352.);
    list.set("interface", 0.1).set("gas length", 0.05).set("piston length", 0.05);
  }
  if (solution == "piston container") {
    list.set("piston", "piston").set("stiffness", 1.).set("piston mass", 1.).set("length", 1.);
    return list.set("density", 1.).set("bulk modulus", 1.).set("velocity", 0.1);
  }
  list.set("gamma", 1.4);
  if (solution == "riemann") {
    list.set("left density", 1.);
    list.set("left pressure", 1.);
    list.set("right density", 0.125);
    list.set("right pressure", 0.1);
    list.set("interface", 0.5);
  } else if (solution == "sedov") {
    list.set("energy", 1.);
    list.set("density", 1.);
  } else if (solution == "vortex") {
    list.set("centre", Teuchos::Array<double>(2, 0));
  }
  return list;
}

TEST(ExactTest, EverySolutionIsMadeFromItsListAndMeasuresWhatItSays) {
  ASSERT_EQ(exact_solutions().size(), 12u);
  ParticleTable table;
  table.dim = 2;
  table.cell_size = 0.1;
  table.cells = {10, 10, 1};
  for (auto* column : {&table.x, &table.y, &table.mass, &table.volume, &table.density,
                       &table.pressure, &table.energy, &table.vx, &table.vy})
    column->assign(1, 0.5);
  table.material = {0};
  table.fields.push_back({"stress xx", "Pa", {0.5}});
  for (const std::string& name : exact_solutions()) {
    SCOPED_TRACE(name);
    const List given = example(name);
    const List checked = check(given, valid_exact(given));
    const auto exact = make_exact(checked);
    EXPECT_TRUE(std::isfinite(exact->at({0.3, 0.2, 0}, 0.1).p));
    EXPECT_FALSE(exact->features(0.1).empty());
    EXPECT_LE(exact->least_dim(), 2);
    std::set<std::string> possible;
    for (const MeasureDoc& doc : possible_measures(name)) {
      EXPECT_TRUE(possible.insert(doc.name).second);
      EXPECT_FALSE(doc.doc.empty());
      EXPECT_FALSE(doc.unit.empty());
    }
    const auto docs = exact->measure_docs();
    const auto values = exact->measures(table, 0.1);
    ASSERT_EQ(docs.size(), values.size());
    for (std::size_t i = 0; i < docs.size(); ++i) {
      EXPECT_EQ(docs[i].name, values[i].name);
      EXPECT_EQ(possible.count(docs[i].name), 1u);
      // Along a run that was not recorded there is no period.
      EXPECT_TRUE(std::isfinite(values[i].value) || exact->records()) << docs[i].name;
    }
  }
}

TEST(ExactTest, ListsAreStrict) {
  List unknown("exact");
  unknown.set("solution", "taylor");
  EXPECT_THROW(valid_exact(unknown), InputError);
  EXPECT_THROW(valid_exact(List("exact")), InputError);
  EXPECT_THROW(possible_measures("taylor"), InputError);
  List wrong = example("riemann");
  wrong.set("left densty", 1.);
  EXPECT_THROW(check(wrong, valid_exact(wrong)), InputError);
  List region = example("riemann");
  region.set("measured region", Teuchos::Array<double>(2, 0.5));
  EXPECT_THROW(make_exact(check(region, valid_exact(region))), InputError);
}

}  // namespace
}  // namespace brisance
