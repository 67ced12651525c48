// The scene detonation_1d at three times, with other particles, steps and grids.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <ostream>

#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "drivers/simulation.hpp"

namespace brisance {
namespace {

struct Row {
  int per_cell = 2;
  double cfl = 0.8;
  int cells = 2000;

  std::string name() const {
    return "each" + std::to_string(per_cell) + "_cfl" + std::to_string(std::lround(100 * cfl)) +
           "_cells" + std::to_string(cells);
  }
  friend std::ostream& operator<<(std::ostream& out, const Row& r) { return out << r.name(); }
};

double value(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m.value;
  return std::nan("");
}

/// A slab on its way, and what is measured of it.
class Slab {
 public:
  explicit Slab(const Row& row)
      : scene_(load_scene(
            {(data_folder() / "inputs" / "detonation_1d.xml").string(),
             {},
             {"grid/cells={" + std::to_string(row.cells) + "}",
              "grid/cell size=" + text_of(0.1 / row.cells), "time/CFL=" + text_of(row.cfl),
              "bodies/slab/particles per cell=" + std::to_string(row.per_cell)}})),
        exact_(make_exact(scene_.sublist("exact"))),
        simulation_(make_simulation(scene_, exact_.get())),
        start_(simulation_->balance()) {}

  std::vector<Measure> at(double time) {
    while (simulation_->time() < time) simulation_->advance(time);
    return exact_->measures(simulation_->snapshot().table, time);
  }
  double energy_error() const { return Ledger(start_).energy_error(simulation_->balance()); }

 private:
  List scene_;
  std::unique_ptr<ExactSolution> exact_;
  std::unique_ptr<Simulation> simulation_;
  Balance start_;
};

class DetonationSlow : public testing::TestWithParam<Row> {};

// Fan and peak cover as many cells as the front has passed: their errors fall as it runs on.
TEST_P(DetonationSlow, HasFrontFanAndPlateauOfTaylor) {
  Slab slab(GetParam());
  for (const double time : {5e-6, 10e-6, 14e-6}) {
    SCOPED_TRACE(time);
    const auto m = slab.at(time);
    EXPECT_NEAR(value(m, "detonation speed error"), 0, 2e-3);
    EXPECT_LT(value(m, "L1 fan"), time < 10e-6 ? 0.02 : 0.015);
    EXPECT_NEAR(value(m, "plateau error"), 0, 0.01);
    EXPECT_LT(value(m, "L1 plateau"), 0.01);
    EXPECT_NEAR(value(m, "peak error"), 0, 0.1);
    EXPECT_LT(value(m, "peak of points error"), 0.1);
    EXPECT_NEAR(slab.energy_error(), 0, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, DetonationSlow, testing::Values(Row{1}, Row{2}, Row{3}, Row{2, 0.4}),
                         [](const auto& row) { return row.param.name(); });

// Errors of the peak and of the fan fall with the cell: an order near 1 and of two thirds.
TEST(DetonationSlow, OnHalfAsManyCellsLosesTwiceAsMuchOfItsPeak) {
  Slab coarse(Row{2, 0.8, 1000}), fine(Row{2, 0.8, 2000});
  const auto a = coarse.at(14e-6), b = fine.at(14e-6);
  EXPECT_NEAR(value(a, "detonation speed error"), 0, 2e-3);
  EXPECT_LT(value(a, "L1 fan"), 0.015);
  EXPECT_NEAR(value(a, "plateau error"), 0, 0.01);
  const double peak = std::log2(value(a, "peak error") / value(b, "peak error")),
               fan = std::log2(value(a, "L1 fan") / value(b, "L1 fan"));
  EXPECT_GT(peak, 0.75);
  EXPECT_GT(fan, 0.5);
  RecordProperty("order_of_peak", std::to_string(peak));
  RecordProperty("order_of_fan", std::to_string(fan));
}

}  // namespace
}  // namespace brisance
