#include "drivers/exact_layers.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

namespace brisance {
namespace {

/// A light gas of high pressure, a plate and air, in 60, 20 and 100 mm.
List layers(const std::string& symmetry = "plane") {
  List list("exact");
  list.set("solution", "layers").set("symmetry", symmetry);
  list.set("cell size", 1e-3).set("plate", "plate");
  List& of = list.sublist("layers");
  of.sublist("charge").set("law", "perfect gas").set("gamma", 1.4).set("thickness", 0.06);
  of.sublist("charge").set("density", 100.).set("specific energy", 2e6);
  of.sublist("plate").set("law", "von mises").set("density", 7850.).set("thickness", 0.02);
  of.sublist("plate").set("Young's modulus", 200e9).set("Poisson's ratio", 0.29);
  of.sublist("plate").set("yield stress", 500e6);
  of.sublist("air").set("law", "perfect gas").set("gamma", 1.4).set("thickness", 0.1);
  of.sublist("air").set("density", 1.29).set("specific energy", 2e5);
  return list;
}

Layers solution(const List& given) { return Layers(check(given, valid_exact(given))); }

double value(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m.value;
  return std::nan("");
}

/// Particles on a square lattice (a row of them in a plane) that have what the solution has there.
/// Materials are numbered from the last layer on.
ParticleTable table_of(const Layers& exact, double t, int dim, double factor = 1) {
  const double length = 0.18, h = 2e-3;
  ParticleTable table;
  table.dim = dim;
  table.cell_size = h;
  const int n = static_cast<int>(std::lround(length / h));
  table.cells = {n, dim == 1 ? 1 : n, 1};
  for (int j = 0; j < table.cells[1]; ++j)
    for (int i = 0; i < n; ++i) {
      const Place x{(i + 0.5) * h, dim == 1 ? 0 : (j + 0.5) * h, 0};
      const MatterState s = exact.at(x, t);
      if (!(s.rho > 0)) continue;
      table.x.push_back(x[0]);
      table.y.push_back(x[1]);
      table.vx.push_back(factor * s.v[0]);
      table.vy.push_back(factor * s.v[1]);
      table.volume.push_back(dim == 1 ? h : h * h);
      table.mass.push_back(s.rho * table.volume.back());
      table.pressure.push_back(factor * s.p);
      table.energy.push_back(s.e);
      const bool steel = s.rho > 1000;
      table.material.push_back(steel ? 1 : s.rho > 20 ? 2 : 0);
    }
  return table;
}

// A cell of the table beside an end of the plate may hold a velocity of its neighbour.
TEST(Layers, FindNoErrorInThemselves) {
  for (const int dim : {1, 2}) {
    const Layers exact = solution(layers(dim == 1 ? "plane" : "cylindrical"));
    const double t = 4e-5;
    for (const double factor : {1., 1.1}) {
      const auto measures = exact.measures(table_of(exact, t, dim, factor), t);
      EXPECT_NEAR(value(measures, "plate velocity error"), factor - 1, 0.02);
      EXPECT_NEAR(value(measures, "L1 pressure of gas"), factor - 1, 1e-12);
    }
  }
}

TEST(Layers, SeeParticlesThatPassTheNextLayer) {
  const Layers exact = solution(layers());
  ParticleTable table = table_of(exact, 1e-5, 1);
  EXPECT_NEAR(value(exact.measures(table, 1e-5), "interpenetration"), -2e-3, 1e-12);
  for (std::size_t k = 0; k + 1 < table.size(); ++k)
    if (table.material[k] == 2 && table.material[k + 1] == 1) table.x[k] += 5e-3;
  EXPECT_NEAR(value(exact.measures(table, 1e-5), "interpenetration"), 3e-3, 1e-12);
}

TEST(Layers, MayBeAskedForTimesInAnyOrder) {
  const Layers exact = solution(layers());
  const double late = exact.at({0.05, 0, 0}, 4e-5).p;
  const double early = exact.at({0.05, 0, 0}, 2e-5).p;
  EXPECT_NE(early, late);
  EXPECT_NEAR(exact.at({0.05, 0, 0}, 4e-5).p / late, 1, 1e-3);  // steps are other ones
}

TEST(Layers, AreTheSameAlongEveryRadius) {
  const Layers exact = solution(layers("cylindrical"));
  const MatterState a = exact.at({0.05, 0, 0}, 4e-5), b = exact.at({0.03, 0.04, 0}, 4e-5);
  EXPECT_NEAR(b.p / a.p, 1, 1e-12);
  EXPECT_NEAR(b.v[0], 0.6 * a.v[0], 1e-9);
  EXPECT_NEAR(b.v[1], 0.8 * a.v[0], 1e-9);
}

TEST(Layers, RefuseWhatIsNoStack) {
  List empty = layers();
  empty.remove("layers");
  EXPECT_THROW(solution(empty), InputError);
  List no_plate = layers();
  no_plate.set("plate", "plait");
  EXPECT_THROW(solution(no_plate), InputError);
  List no_law = layers();
  no_law.sublist("layers").sublist("air").remove("law");
  EXPECT_THROW(solution(no_law), InputError);
  const Layers exact = solution(layers());
  ParticleTable table = table_of(exact, 1e-5, 1);
  for (int& material : table.material) material = std::min(material, 1);
  EXPECT_THROW(exact.measures(table, 1e-5), std::runtime_error);
}

TEST(Layers, MeasureProductsOnlyWhereThereAreSome) {
  for (const MeasureDoc& doc : solution(layers()).measure_docs())
    EXPECT_NE(doc.name, "L1 pressure of products");
}

}  // namespace
}  // namespace brisance
