// The scenes plate_push and piston_gas with other particles, grids, steps and frames.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <ostream>

#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "drivers/run.hpp"

namespace brisance {
namespace {

Outcome outcome_of(const std::string& scene, const std::vector<std::string>& changes) {
  RunOptions quiet;
  quiet.quiet = true;
  return run(load_scene({(data_folder() / "inputs" / (scene + ".xml")).string(), {}, changes}),
             quiet)
      .outcome;
}

double value(const Outcome& outcome, const std::string& name) {
  for (const Measure& m : outcome.measures)
    if (m.name == name) return m.value;
  return std::nan("");
}

struct Plate {
  int in_plate = 10;  ///< cells in the plate
  int per_cell = 2;
  double limit = 0.015;  ///< of the error of its velocity

  std::string name() const {
    return "cells" + std::to_string(in_plate) + "_each" + std::to_string(per_cell);
  }
  friend std::ostream& operator<<(std::ostream& out, const Plate& p) { return out << p.name(); }
};

// On 5 cells of one particle the error is 2.1 %, where 2 are wanted.
class PlatePushSlow : public testing::TestWithParam<Plate> {};

TEST_P(PlatePushSlow, HasTheVelocityOfTheReference) {
  const Plate& plate = GetParam();
  const std::string each = "/particles per cell=" + std::to_string(plate.per_cell);
  const Outcome of = outcome_of(
      "plate_push", {"grid/cells={" + std::to_string(16 * plate.in_plate) + "}",
                     "grid/cell size=" + text_of(0.025 / plate.in_plate), "bodies/charge" + each,
                     "bodies/plate" + each, "bodies/air" + each});
  EXPECT_NEAR(value(of, "plate velocity error"), 0, plate.limit);
  EXPECT_LT(value(of, "interpenetration"), 0);
  EXPECT_NEAR(value(of, "energy error"), 0, 1e-10);
  EXPECT_NEAR(value(of, "momentum error"), 0, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Plates, PlatePushSlow,
                         testing::Values(Plate{5, 1, 0.022}, Plate{5, 2, 0.02}, Plate{5, 3, 0.02},
                                         Plate{10, 1, 0.015}, Plate{10, 2, 0.015},
                                         Plate{10, 3, 0.015}, Plate{20, 1, 0.0075},
                                         Plate{20, 2, 0.0075}, Plate{20, 3, 0.0075}),
                         [](const auto& plate) { return plate.param.name(); });

struct Piston {
  int per_cell = 1;
  double cfl = 0.8;
  double frame = 0;  ///< velocity of everything along x [m/s]

  std::string name() const {
    return "each" + std::to_string(per_cell) + "_cfl" + std::to_string(std::lround(100 * cfl)) +
           "_frame" + std::to_string(std::lround(frame));
  }
  friend std::ostream& operator<<(std::ostream& out, const Piston& p) { return out << p.name(); }
};

class PistonGasSlow : public testing::TestWithParam<Piston> {};

// The grid is longer by the 13 mm that a moving frame covers.
TEST_P(PistonGasSlow, HasShockAndStressOfTheAnswer) {
  const Piston& piston = GetParam();
  const std::string each = "/particles per cell=" + std::to_string(piston.per_cell);
  const auto velocity = [&](const char* body, double v) {
    return "bodies/" + std::string(body) + "/velocity={" + text_of(v + piston.frame) + "}";
  };
  const Outcome of = outcome_of(
      "piston_gas",
      {"grid/cells={" + std::string(piston.frame > 0 ? "708" : "648") + "}",
       "time/CFL=" + text_of(piston.cfl), "exact/frame velocity=" + text_of(piston.frame),
       "bodies/resting piston" + each, "bodies/gas" + each, "bodies/moving piston" + each,
       velocity("resting piston", 0), velocity("gas", 0), velocity("moving piston", -26352)});
  EXPECT_NEAR(value(of, "post-shock pressure error"), 0, 3e-3);
  EXPECT_NEAR(value(of, "shock position"), 0, 0.5);
  EXPECT_LT(value(of, "overshoot"), 0.03);
  EXPECT_LT(value(of, "steel stress error"), 0.02);
  EXPECT_LT(value(of, "worst steel point"), 2);
  EXPECT_NEAR(value(of, "interface pressure"), 1, 0.03);
  EXPECT_NEAR(value(of, "interface stress"), 1, 0.03);
  EXPECT_NEAR(value(of, "interface pressure") / value(of, "interface stress"), 1, 0.03);
  EXPECT_LT(value(of, "interpenetration"), 0);
  EXPECT_NEAR(value(of, "energy error"), 0, 1e-10);
  EXPECT_NEAR(value(of, "momentum error"), 0, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Pistons, PistonGasSlow,
                         testing::Values(Piston{1, 0.8}, Piston{1, 0.4}, Piston{3, 0.8},
                                         Piston{3, 0.4}, Piston{1, 0.8, 1e4}, Piston{3, 0.8, 1e4}),
                         [](const auto& piston) { return piston.param.name(); });

}  // namespace
}  // namespace brisance
