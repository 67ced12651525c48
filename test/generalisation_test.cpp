// The limits of the default scheme in states that no one tuned it to: other gammas, resolutions,
// particles per cell and CFL numbers. They are those that the scenes carry, set at gamma 1.4, 200
// cells a unit of length, 3 particles a cell and CFL 0.8. Errors of first order must fall with the
// cell size, a place of a shock is counted in cells. What does not hold stands in its row with the
// limit that does.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <ostream>

#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "drivers/run.hpp"

namespace brisance {
namespace {

/// A limit that is missed, and what was measured in its place; that much and a twentieth may be.
struct Missed {
  std::string quantity;
  double measured;
};
Missed density(double measured) { return {"L1 density", measured}; }
Missed velocity(double measured) { return {"L1 velocity", measured}; }
Missed pressure(double measured) { return {"L1 pressure", measured}; }
Missed energy(double measured) { return {"L1 energy", measured}; }
Missed shock(double measured) { return {"shock position", measured}; }

struct Row {
  std::string scene;
  double gamma = 1.4, cfl = 0.8;
  int per_cell = 3;
  double finer = 1;  ///< how many times as many cells as in the scene
  std::vector<Missed> missed = {};

  std::string name() const {
    return scene + "_gamma" + std::to_string(std::lround(100 * gamma)) + "_cfl" +
           std::to_string(std::lround(100 * cfl)) + "_each" + std::to_string(per_cell) + "_cells" +
           std::to_string(std::lround(100 * finer));
  }
  friend std::ostream& operator<<(std::ostream& out, const Row& r) { return out << r.name(); }
};

List scene_of(const Row& row) {
  const std::string file = (data_folder() / "inputs" / (row.scene + ".xml")).string();
  const List base = load_scene({file, {}, {}});
  const List& grid = base.sublist("grid");
  const auto text = [](double number) { return std::to_string(number); };
  std::vector<std::string> changes = {
      "grid/cells={" +
          std::to_string(std::lround(get<std::vector<int>>(grid, "cells")[0] * row.finer)) + "}",
      "grid/cell size=" + text(get<double>(grid, "cell size") / row.finer),
      "materials/gas/gamma=" + text(row.gamma), "exact/gamma=" + text(row.gamma),
      "time/CFL=" + text(row.cfl)};
  for (const auto& body : list_names(base.sublist("bodies")))
    changes.push_back("bodies/" + body + "/particles per cell=" + std::to_string(row.per_cell));
  List scene = load_scene({file, {}, changes});

  List& checks = scene.sublist("checks");
  for (const auto& quantity : list_names(checks)) {
    List& range = checks.sublist(quantity);
    if (quantity.find("L1 ") == 0 || quantity == "fan noise")
      range.set("most", get<double>(range, "most") / row.finer);
  }
  for (const Missed& m : row.missed) {
    List& range = checks.sublist(m.quantity);
    const double limit = 1.05 * std::fabs(m.measured);
    EXPECT_GT(limit, get<double>(range, "most")) << m.quantity << " is not missed any more";
    range.set("most", limit);
    if (m.quantity == "shock position") range.set("least", -limit);
  }
  return scene;
}

class GeneralisationSlow : public testing::TestWithParam<Row> {};

TEST_P(GeneralisationSlow, HoldsTheLimits) {
  RunOptions quiet;
  quiet.quiet = true;
  const Outcome outcome = run(scene_of(GetParam()), quiet).outcome;
  EXPECT_EQ(outcome.status, "finished");
  EXPECT_GE(outcome.verdicts.size(), 7u);
  for (const Verdict& v : outcome.verdicts)
    EXPECT_TRUE(v.reached()) << v.quantity << ": " << v.measured << ", limit " << v.limit();
}

// What is missed, or reached by less than a twentieth, and why:
// - riemann at gamma 1.1, density: the shocked gas, 19 times as dense as before, fills a shell of 2
//   cells at 200. A MUSCL-Hancock HLLC code of finite volumes has an error of 3.4 % here.
// - gamma 3 (sod, too), place of the shock: after the start all waves lie in the same few cells for
//   a while. In the exact flow that starts from a ramp of W cells in place of a jump, the shock of
//   riemann is ahead by -0.08 W, 0.02 W, 0.08 W and 0.25 W for gammas of 1.1, 1.4, 5/3 and 3; the
//   scheme acts like a ramp of 2.5 to 3.5 cells, at any resolution. Finite volumes are 0.5 to 0.9
//   cells ahead at gamma 3.
// - energy at gammas of 5/3 and 3, pressure at 3: the lead of the shock, and gas beside the contact
//   that the start left too hot: in riemann 0.3, 0.4 and 0.7 cells of it at gammas of 1.4, 5/3 and
//   3. Finite volumes have an error in energy of 1.0 to 1.5 % at 3, in sod 0.9 to 1.6 %.
// - toro2 on half as many cells, velocity: that of the gas near to vacuum.
const Row rows[] = {
    {"riemann", 1.1, 0.8, 3, 1, {density(0.01195)}},
    {"riemann", 1.1, 0.8, 3, 0.5, {density(0.02961)}},
    {"riemann", 1.1, 0.8, 3, 2, {density(0.006593), shock(-0.260)}},
    {"riemann", 1.1, 0.4, 3, 1, {density(0.01208)}},
    {"riemann", 1.1, 0.9, 3, 1, {density(0.01205)}},
    {"riemann", 1.1, 0.8, 1, 1, {density(0.01414), shock(-0.249)}},
    {"riemann", 1.4, 0.8, 3, 0.5},
    {"riemann", 1.4, 0.8, 3, 2},
    {"riemann", 1.4, 0.4},
    {"riemann", 1.4, 0.9},
    {"riemann", 1.4, 0.8, 1},
    {"riemann", 1.4, 0.8, 2},
    {"riemann", 1.4, 0.8, 4},
    {"riemann", 1.4, 0.9, 1, 2},
    {"riemann", 5. / 3, 0.8, 3, 1, {energy(0.00746)}},
    {"riemann", 5. / 3, 0.8, 3, 0.5, {energy(0.01501)}},
    {"riemann", 5. / 3, 0.8, 3, 2, {energy(0.00463)}},
    {"riemann", 5. / 3, 0.4, 3, 1, {energy(0.00781)}},
    {"riemann", 5. / 3, 0.9, 3, 1, {energy(0.00755)}},
    {"riemann", 5. / 3, 0.8, 1, 1, {energy(0.00853), shock(0.249)}},
    {"riemann", 5. / 3, 0.8, 2, 1, {energy(0.00797), shock(0.245)}},
    {"riemann", 5. / 3, 0.8, 4, 1, {energy(0.00788)}},
    {"riemann", 3, 0.8, 3, 1, {pressure(0.01035), energy(0.01742), shock(0.89)}},
    {"riemann", 3, 0.8, 3, 0.5, {pressure(0.02019), energy(0.03322), shock(0.80)}},
    {"riemann", 3, 0.8, 3, 2, {pressure(0.005556), energy(0.009203), shock(0.97)}},
    {"riemann", 3, 0.9, 2, 1, {pressure(0.01026), energy(0.01662), shock(0.77)}},
    {"sod", 1.1},
    {"sod", 1.1, 0.9, 2},
    {"sod", 1.4, 0.8, 3, 0.5},
    {"sod", 1.4, 0.8, 3, 2},
    {"sod", 1.4, 0.4},
    {"sod", 1.4, 0.9},
    {"sod", 1.4, 0.8, 1},
    {"sod", 1.4, 0.8, 2},
    {"sod", 1.4, 0.8, 4},
    {"sod", 1.4, 0.9, 1, 2, {energy(0.00302)}},
    {"sod", 5. / 3, 0.8, 3, 1, {energy(0.00605)}},
    {"sod", 5. / 3, 0.8, 3, 0.5},
    {"sod", 5. / 3, 0.8, 3, 2, {energy(0.00309)}},
    {"sod", 5. / 3, 0.9, 2, 1, {energy(0.00621)}},
    {"sod", 3, 0.8, 3, 1, {pressure(0.00993), energy(0.00884), shock(0.41)}},
    {"sod", 3, 0.8, 3, 2, {pressure(0.00518), energy(0.00467), shock(0.48)}},
    {"sod", 3, 0.9, 2, 1, {pressure(0.00973), energy(0.00940), shock(0.54)}},
    {"toro2", 1.4, 0.4},
    {"toro2", 1.4, 0.9},
    {"toro2", 1.4, 0.8, 1},
    {"toro2", 1.4, 0.8, 3, 0.5, {velocity(0.0964)}},
    {"toro2", 1.4, 0.8, 3, 2},
    {"toro3", 1.4, 0.4},
    {"toro3", 1.4, 0.9},
    {"toro3", 1.4, 0.8, 1},
    {"toro3", 1.4, 0.8, 3, 0.5},
    {"toro3", 1.4, 0.8, 3, 2},
    {"toro3", 5. / 3},
    {"toro4", 1.4, 0.9, 2},
    {"toro4", 1.4, 0.8, 1},
    {"toro4", 1.4, 0.8, 3, 0.5},
    {"toro4", 1.4, 0.8, 3, 2},
    {"toro4", 5. / 3},
    {"toro5", 1.4, 0.9, 2},
    {"toro5", 1.4, 0.8, 1},
    {"toro5", 1.4, 0.8, 3, 2},
    {"toro5", 5. / 3},
};

INSTANTIATE_TEST_SUITE_P(States, GeneralisationSlow, testing::ValuesIn(rows),
                         [](const auto& row) { return row.param.name(); });

}  // namespace
}  // namespace brisance
