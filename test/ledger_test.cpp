#include "drivers/ledger.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <map>
#include <sstream>

#include "drivers/scene.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

/// The scene of two halves with a material each, the second called "other gas".
List two_materials(const std::vector<std::string>& assignments) {
  List scene = test::scene(2, assignments);
  List& materials = scene.sublist("materials");
  materials.sublist("other gas") = materials.sublist("gas");
  scene.sublist("bodies").sublist("rest").set("material", "other gas");
  return complete_scene(scene);
}

std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> all;
  std::string word;
  for (std::istringstream in(line); std::getline(in, word, ',');) all.push_back(word);
  return all;
}

std::map<std::string, double> history(const Ledger& ledger, const Balance& balance) {
  const auto names = words(ledger.head()), values = words(ledger.line(balance));
  EXPECT_EQ(names.size(), values.size());
  std::map<std::string, double> line;
  for (std::size_t k = 0; k < names.size(); ++k)
    line[names[k].substr(0, names[k].find('\n'))] = std::stod(values[k]);
  return line;
}

double value(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m.value;
  throw std::logic_error(name);
}

// Halves of mass and volume 0.1 that move with (3, 4) and (-3, 4): their speed is 5. Sums of some
// hundred terms: round-off.
TEST(Ledger, KnowsTheMotionOfEachMaterial) {
  const Balance b =
      make_simulation(two_materials({"bodies/first/velocity={3, 4}", "bodies/rest/velocity={-3, 4}",
                                     "bodies/rest/pressure=3"}),
                      nullptr)
          ->balance();
  const Ledger ledger(b);
  const auto measures = ledger.measures(b);
  EXPECT_NEAR(value(measures, "x velocity of gas"), 3, 1e-13);
  EXPECT_NEAR(value(measures, "x velocity of other gas"), -3, 1e-13);
  EXPECT_NEAR(value(measures, "y velocity of other gas"), 4, 1e-13);
  EXPECT_NEAR(value(measures, "mean speed of other gas"), 5, 1e-13);
  EXPECT_NEAR(value(measures, "kinetic energy of gas"), 1.25, 1e-13);
  EXPECT_NEAR(value(measures, "internal energy of other gas"), 0.75, 1e-13);  // p V / (gamma - 1)

  auto line = history(ledger, b);
  EXPECT_NEAR(line.at("momentum_x_other_gas"), -0.3, 1e-13);
  EXPECT_NEAR(line.at("absolute_momentum_x_other_gas"), 0.3, 1e-13);
  EXPECT_NEAR(line.at("absolute_momentum_y_gas"), 0.4, 1e-13);
  EXPECT_NEAR(line.at("kinetic_other_gas"), 1.25, 1e-13);
  EXPECT_NEAR(line.at("internal_other_gas"), 0.75, 1e-13);
}

// Both halves burst out of the free ends of a channel.
TEST(Ledger, OfMaterialsAddsUpToThatOfAll) {
  const List scene = two_materials({"bodies/first/pressure=5", "boundaries/x low=free",
                                    "boundaries/y low=free", "boundaries/x high=free"});
  const Ledger ledger(make_simulation(scene, nullptr)->balance());
  auto line = history(ledger, test::simulated(scene)->balance());
  EXPECT_GT(line.at("outflow_mass"), 0);
  for (const char* q : {"mass", "momentum_x", "momentum_y", "kinetic", "internal"})
    EXPECT_NEAR(line.at(std::string(q) + "_gas") + line.at(std::string(q) + "_other_gas"),
                line.at(q), 1e-14)
        << q;
  EXPECT_NEAR(line.at("outflow_momentum_x") + line.at("momentum_x"), 0, 1e-14);
  EXPECT_NEAR(line.at("outflow_kinetic") + line.at("outflow_internal") + line.at("total"),
              0.6 / 0.4, 1e-13);
}

// Parts that fly apart have no momentum together: half the mass each way.
TEST(Ledger, KeepsMotionWhoseMomentaCancel) {
  const Balance b =
      make_simulation(
          test::scene(2, {"bodies/first/velocity={2, 0}", "bodies/rest/velocity={-2, 0}"}), nullptr)
          ->balance();
  auto line = history(Ledger(b), b);
  EXPECT_NEAR(line.at("momentum_x_gas"), 0, 1e-13);
  EXPECT_NEAR(line.at("absolute_momentum_x_gas"), 0.4, 1e-13);
}

// After a burst of the left half the left wall has been pushed longer and harder than the right
// one. What walls took, the gas has lost.
TEST(Ledger, TellsWhatWallsHaveTaken) {
  const List scene = test::scene(2, {"bodies/first/pressure=5", "time/end=0.5"});
  const Balance start = make_simulation(scene, nullptr)->balance();
  const Ledger ledger(start);
  const Balance end = test::simulated(scene)->balance();
  const auto measures = ledger.measures(end);
  EXPECT_NEAR(value(measures, "x impulse on walls") + end.totals.momentum[0], 0, 1e-14);
  EXPECT_LT(value(measures, "x impulse on walls"), -0.01);
}

TEST(Ledger, NamesColumnsWithoutBlanks) {
  EXPECT_EQ(column_name("TNT, 2nd lump"), "TNT__2nd_lump");
}

}  // namespace
}  // namespace brisance
