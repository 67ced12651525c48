// Where the time goes is told by kernel and part; how long anything takes is tested nowhere.
#include "drivers/time_spent.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/types.hpp"

namespace brisance {
namespace {

void launch(const char* name) {
  const Array<double> x("x", 4);
  Kokkos::parallel_for(
      name, Kokkos::RangePolicy<Space>(0, 4), KOKKOS_LAMBDA(const int k) { x(k) += k; });
}

double sum(const char* name) {
  double result = 0;
  Kokkos::parallel_reduce(
      name, Kokkos::RangePolicy<Space>(0, 4), KOKKOS_LAMBDA(const int k, double& s) { s += k; },
      result);
  return result;
}

const TimeRow* find(const std::vector<TimeRow>& rows, const std::string& name) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const TimeRow& r) { return r.name == name; });
  return row == rows.end() ? nullptr : &*row;
}

double seconds_of(const std::vector<TimeRow>& rows) {
  double all = 0;
  for (const TimeRow& row : rows) all += row.seconds;
  return all;
}

/// Steps of three kernels, with one launch outside of them.
TimeSpent ten_steps() {
  TimeKeeper keeper;
  for (int step = 0; step < 10; ++step) {
    keeper.step([] {
      launch("permute");
      launch("permute back");
      launch("update");
      launch("update");
      sum("signals");
    });
    keeper.on(TimeKeeper::output, [] { launch("report"); });
  }
  return keeper.so_far();
}

TEST(TimeSpent, IsToldForTheKernelsOfTheStepsUnderTheirLabels) {
  const TimeSpent spent = ten_steps();
  for (const auto& [name, calls] :
       {std::pair{"permute", 10}, {"permute back", 10}, {"update", 20}, {"signals", 10}}) {
    ASSERT_TRUE(find(spent.kernels, name)) << name;
    EXPECT_NEAR(find(spent.kernels, name)->calls, calls, 1e-9) << name;
  }
  EXPECT_FALSE(find(spent.kernels, "report"));  // part of the output
  EXPECT_GE(spent.measured_steps, 1);
  EXPECT_LE(spent.measured_steps, 10);
}

TEST(TimeSpent, IsNowhereCountedTwice) {
  const TimeSpent spent = ten_steps();
  const TimeRow *steps = find(spent.parts, "steps"), *output = find(spent.parts, "output");
  ASSERT_TRUE(steps && output);
  EXPECT_EQ(steps->calls, 10);
  EXPECT_EQ(output->calls, 10);
  EXPECT_FALSE(find(spent.parts, "checkpoints"));
  const double round_off = 1e-12 * spent.seconds;
  EXPECT_LE(seconds_of(spent.kernels), steps->seconds + round_off);
  EXPECT_NEAR(seconds_of(spent.parts), spent.seconds, round_off);
}

TEST(TimeSpent, PutsWhatIsAlikeTogether) {
  const auto rows = alike_together({{"permute", 1, 10},
                                    {"permute back", 2, 10},
                                    {"update", 4, 1},
                                    {"half step of solid", 1, 2},
                                    {"half step", 1, 3},
                                    {"Kokkos::ViewFill-1D", 0.5, 7}});
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].name, "update");
  EXPECT_EQ(rows[1].name, "sort particles");
  EXPECT_EQ(rows[1].seconds, 3);
  EXPECT_EQ(rows[1].calls, 20);
  EXPECT_EQ(rows[2].name, "half step");
  EXPECT_EQ(rows[2].calls, 5);
  EXPECT_EQ(rows[3].name, "fill and sum arrays");
}

int seen = 0;

TEST(TimeSpent, LeavesKokkosToAnotherToolThatIsThere) {
  namespace tools = Kokkos::Tools::Experimental;
  seen = 0;
  tools::set_begin_parallel_for_callback([](const char*, uint32_t, uint64_t*) { ++seen; });
  const TimeSpent spent = ten_steps();
  tools::set_begin_parallel_for_callback(nullptr);
  EXPECT_GE(seen, 50);  // with the one of the output, and what views launch themselves
  EXPECT_TRUE(spent.kernels.empty());
  EXPECT_EQ(find(spent.parts, "steps")->calls, 10);
}

}  // namespace
}  // namespace brisance
