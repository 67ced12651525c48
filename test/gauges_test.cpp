#include "drivers/gauges.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <functional>
#include <sstream>

#include "drivers/commands.hpp"
#include "drivers/exact.hpp"
#include "drivers/kernels.hpp"
#include "drivers/locations.hpp"
#include "drivers/run.hpp"
#include "drivers/scene.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

/// A complete scene with one more gauge, called "a b".
List with_gauge(
    List scene, const std::vector<double>& place,
    const std::function<void(List&)>& change = [](List&) {}) {
  List& gauge = scene.sublist("gauges").sublist("a b");
  gauge.set("place", Teuchos::Array<double>(place));
  change(gauge);
  return complete_scene(scene);
}

double value(const std::vector<Measure>& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m.value;
  throw std::logic_error(name);
}

/// The columns of a table, by name.
std::map<std::string, std::vector<double>> columns(const std::string& table) {
  std::istringstream lines(table);
  std::string line, word;
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> all;
  std::getline(lines, line);
  for (std::istringstream head(line); std::getline(head, word, ',');) names.push_back(word);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    for (const auto& name : names) {
      std::getline(words, word, ',');
      all[name].push_back(std::stod(word));
    }
  }
  return all;
}

/// A place where a function of time is seen.
class Known final : public Simulation {
 public:
  std::function<double(double)> pressure;
  int points = 1;
  double now = 0;
  int carried = 0;

  double time() const override { return now; }
  double dt() const override { return 0; }
  long step_count() const override { return 0; }
  long particle_count() const override { return 0; }
  void advance(double) override {}
  Balance balance() const override { return {}; }
  Snapshot snapshot(Snapshot) const override { return {}; }
  Footprint footprint() const override { return {}; }
  std::vector<Seen> probe(const std::vector<Window>& windows) const override {
    return std::vector<Seen>(windows.size(), {points, points > 0 ? pressure(now) : 0, {}});
  }
  void carry(std::vector<Window>&) override { ++carried; }
  void keep(Archive&) override {}
};

/// The record of a gauge over the time 0.1 at `steps` steps.
Gauges record(
    Known& known, int steps, const std::function<void(List&)>& change = [](List&) {}) {
  Gauges gauges(with_gauge(test::scene(1), {0.5}, change));
  for (int k = 0; k <= steps; ++k) {
    known.now = k == steps ? 0.1 : 0.1 * k / steps;
    gauges.follow(known);
  }
  return gauges;
}

// Pressure 2 at the start, then 2 + 10 t up to 0.05, back to 2 - 0.5: straight between samples, so
// that interpolation and trapezoids are exact.
TEST(Gauges, ToldOfAKnownPressureFindArrivalPeakAndImpulse) {
  Known known;
  known.pressure = [](double t) { return t <= 0.05 ? 2 + 10 * t : 2.5 - 20 * (t - 0.05); };
  const Gauges gauges = record(known, 40);
  const auto measured = gauges.measures();
  EXPECT_NEAR(value(measured, "a b arrival"), 0.01, 1e-15);  // 2 / 20 = 10 t
  EXPECT_NEAR(value(measured, "a b peak overpressure"), 0.5, 1e-15);
  EXPECT_NEAR(value(measured, "a b time of peak"), 0.05, 1e-15);
  EXPECT_NEAR(value(measured, "a b impulse"), 0.0125, 1e-15);  // 0.5 0.5 (0.05 + 0.025 - 0.025)
  const auto table = columns(gauges.table());
  EXPECT_EQ(table.at("time").size(), 41u);
  EXPECT_NEAR(table.at("positive_impulse_a_b").back(), 0.01875, 1e-12);
  EXPECT_EQ(table.at("x_a_b").front(), 0.5);
}

TEST(Gauges, CountArrivalFromWhatIsGiven) {
  Known known;
  known.pressure = [](double t) { return 10 * t; };
  EXPECT_NEAR(value(record(known, 40).measures(), "a b arrival"), 0.005, 1e-15);  // of the peak, 1
  const auto set = [](const char* name, double p) {
    return [=](List& gauge) { gauge.set(name, p); };
  };
  EXPECT_NEAR(value(record(known, 40, set("arrival", 0.2)).measures(), "a b arrival"), 0.02, 1e-15);
  EXPECT_TRUE(std::isnan(value(record(known, 40, set("arrival", 2.)).measures(), "a b arrival")));
  const auto absolute = record(known, 40, set("reference pressure", 0.5)).measures();
  EXPECT_NEAR(value(absolute, "a b peak overpressure"), 0.5, 1e-15);
  EXPECT_NEAR(value(absolute, "a b arrival"), 0.0525, 1e-15);
  const auto low = record(known, 40, set("reference pressure", 0.2)).measures();
  EXPECT_NEAR(value(low, "a b arrival"), 0.024, 1e-15);  // of the peak, 0.8
}

TEST(Gauges, ThatSeeNothingFeelNothing) {
  Known known;
  known.points = 0;
  known.pressure = [](double) { return 1; };
  const auto gauges = record(known, 10, [](List& gauge) { gauge.set("reference pressure", 1.); });
  EXPECT_EQ(value(gauges.measures(), "a b impulse"), 0);
  EXPECT_TRUE(std::isnan(value(gauges.measures(), "a b arrival")));
  EXPECT_EQ(gauges.table().find("nan"), std::string::npos);
  EXPECT_EQ(columns(gauges.table()).at("points_a_b").back(), 0);
}

// Steps of 0.004, samples every 0.01.
TEST(Gauges, SampleAtTheFirstStepThatReachesTheirTime) {
  Known known;
  known.pressure = [](double) { return 1; };
  List scene = test::scene(1);
  scene.sublist("gauges").set("interval", 0.01);
  Gauges gauges(with_gauge(scene, {0.5}));
  for (int k = 0; k <= 25; ++k) {
    known.now = 0.1 * k / 25;
    gauges.follow(known);
  }
  const auto time = columns(gauges.table()).at("time");
  ASSERT_EQ(time.size(), 11u);
  const double expected[] = {0, 0.012, 0.02, 0.032, 0.04, 0.052};
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(time[k], expected[k], 1e-15);
  EXPECT_EQ(time.back(), 0.1);
  EXPECT_EQ(known.carried, 0);
}

TEST(Gauges, CostNothingBetweenSamples) {
  const List scene = with_gauge(test::scene(1), {0.5});
  const auto simulation = make_simulation(scene, nullptr);
  Known between;
  between.now = 1e-9;
  Gauges gauges(scene);
  gauges.follow(*simulation);
  EXPECT_TRUE(kernels_of([&] { gauges.follow(between); }).empty());
}

TEST(Gauges, RefuseWhatDoesNotFit) {
  const auto told = [](const std::function<void(List&)>& change) -> std::string {
    try {
      List scene = test::scene(1);
      change(scene.sublist("gauges"));
      complete_scene(scene);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto place = [](double x) { return Teuchos::Array<double>(1, x); };
  EXPECT_NE(told([](List&) {}).find("must name a gauge"), std::string::npos);
  EXPECT_NE(told([&](List& l) { l.sublist("a").set("place", place(2.1)); }).find("in the grid"),
            std::string::npos);
  EXPECT_NE(told([&](List& l) {
              l.sublist("a").set("place", place(1)).set("material", "lead");
            }).find("must be one of: any, gas"),
            std::string::npos);
  EXPECT_NE(told([&](List& l) {
              l.sublist("a b").set("place", place(1));
              l.sublist("a_b").set("place", place(1));
            }).find("same columns"),
            std::string::npos);
}

/// Runs a scene and keeps its gauges' table.
std::map<std::string, std::vector<double>> recorded(const List& scene,
                                                    const ExactSolution* exact = nullptr) {
  const auto simulation = make_simulation(scene, exact);
  Gauges gauges(scene);
  gauges.follow(*simulation);
  const double end = get<double>(scene.sublist("time"), "end");
  while (simulation->time() < end) {
    simulation->advance(end);
    gauges.follow(*simulation);
  }
  return columns(gauges.table());
}

// 20 cells pass by in the time, three particles in each. The pressure of such a flow stays what it
// is to round-off of some hundred steps.
TEST(Gauges, SeeAConstantPressureInAUniformFlow) {
  for (const char* preset : {"balanced", "accurate"})
    for (const bool rides : {false, true}) {
      SCOPED_TRACE(preset);
      const auto flow =
          test::scene(1, {std::string("preset=") + preset, "boundaries/x low=periodic",
                          "boundaries/x high=periodic", "bodies/first/velocity={2}",
                          "bodies/rest/velocity={2}", "time/end=1"});
      const auto table =
          recorded(with_gauge(flow, {0.33}, [&](List& gauge) { gauge.set("rides", rides); }));
      ASSERT_GT(table.at("time").size(), 50u);
      for (std::size_t k = 0; k < table.at("time").size(); ++k) {
        EXPECT_NEAR(table.at("pressure_a_b")[k], 1, 1e-12);
        EXPECT_NEAR(table.at("velocity_x_a_b")[k], 2, 1e-12);
        const double gone = rides ? 2 * table.at("time")[k] : 0;
        const double turns = gone > 1.67 ? 2 : 0;
        EXPECT_NEAR(table.at("x_a_b")[k], 0.33 + gone - turns, 1e-9);
      }
    }
}

// The shock of Hu & Chen's tube, from the interface at 0.5 over a gauge at 0.6. It is spread over
// some three cells, and the spline sees one and a half to each side. Arrival is where the pressure
// has risen by half: in place within half a cell. From four cells on the plateau has begun.
TEST(Gauges, BehindAShockKeepItsPressure) {
  const List tube = load_scene({(data_folder() / "inputs/riemann.xml").string(), {}, {}});
  const Riemann exact(tube.sublist("exact"));
  const double plateau = exact.star_pressure(), speed = exact.wave(1).head, h = 0.005;
  const List scene =
      with_gauge(tube, {0.6}, [&](List& gauge) { gauge.set("arrival", 0.5 * plateau); });
  const RunOptions quiet{{}, true};
  const RunResult result = run(scene, quiet);
  const double arrival = value(result.outcome.measures, "a b arrival");
  EXPECT_NEAR(arrival, 0.1 / speed, 0.5 * h / speed);

  const auto table = recorded(scene, &exact);
  const auto &time = table.at("time"), &pressure = table.at("pressure_a_b");
  double variation = 0;
  std::size_t last = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] < arrival + 4 * h / speed) continue;
    EXPECT_NEAR(pressure[k] / plateau, 1, 0.01) << time[k];
    if (last > 0) variation += std::fabs(pressure[k] - pressure[last]) / plateau;
    last = k;
  }
  EXPECT_LT(variation, 0.03);  // measured 0.018; with half the radius 0.035
  EXPECT_NEAR(value(result.outcome.measures, "a b impulse"),
              (plateau - 0.001) * (0.143 - 0.1 / speed), 0.01 * plateau * 0.143);
}

}  // namespace
}  // namespace brisance
