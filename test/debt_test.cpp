// Energy that the fluids of a bin cannot give is owed, and paid when they can.
#include <gtest/gtest.h>

#include "test/state.hpp"

namespace brisance {
namespace {

/// A gas at rest with a debt in each bin, after its points have received work [J/kg].
struct Bins {
  State<Line> state;
  Group<Line>& group;

  Bins() : state(at_rest()), group(*state.groups[0]) {
    group.debt = Array<double>("energy owed", state.grid.lattice.size);
    Kokkos::deep_copy(group.particles.gradient.table, 0.0);
  }
  void receive(double work) {
    Kokkos::deep_copy(group.particles.work.table, work);
    test::sweep(state.grid.lattice, [&](auto& in) { group.finish(in, state.grid, 1e-3); });
  }
  double energy() const { return group.totals(0, group.particles.count, 0).internal; }
  double debt() const {
    double sum = 0;
    for (std::size_t n = 0; n < group.debt.extent(0); ++n) sum += group.debt(n);
    return sum;
  }

 private:
  static State<Line> at_rest() {
    test::RandomGas of;
    of.regular = of.passing_lasts = true;
    of.velocity_range = of.pressure_range = 0;
    return test::random_gas<Line>(of);
  }
};

// Pressure and density 1, gamma 1.4: 2.5 J/kg, of which a fifth stays.
TEST(Debt, HoldsWhatPointsCouldNotGive) {
  Bins bins;
  const double before = bins.energy(), mass = test::totals(bins.state).mass;
  bins.receive(-3);
  EXPECT_NEAR(bins.energy(), 0.5 * mass, 1e-12 * before);
  EXPECT_NEAR(bins.energy() - bins.debt(), before - 3 * mass, 1e-12 * before);
  EXPECT_GT(bins.group.floors(), 0);
}

TEST(Debt, IsPaidByTheNextThatHasSomethingToSpare) {
  Bins bins;
  const double before = bins.energy(), mass = test::totals(bins.state).mass;
  bins.receive(-3);
  bins.receive(2);
  EXPECT_EQ(bins.debt(), 0);
  EXPECT_NEAR(bins.energy(), before - mass, 1e-12 * before);
}

TEST(Debt, IsNoneWhereAllCanGive) {
  Bins bins;
  bins.receive(-1);
  EXPECT_EQ(bins.debt(), 0);
  EXPECT_EQ(bins.group.floors(), 0);
}

}  // namespace
}  // namespace brisance
