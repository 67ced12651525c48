#include "core/relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "materials/fluid_stages.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using test::random_gas;
using test::RandomGas;

template <class G>
class EveryRelaxation : public testing::Test {
 public:
  static void relax_once(State<G>& s, const RelaxationRates& rates, double dt) {
    const int nodes = s.grid.lattice.size;
    Accumulator sums(nodes, relaxation_columns), spare(nodes, relaxation_columns);
    relax(s.groups, s.grid, sums, spare, rates, dt);
  }

  /// Mean square of the pressure about its mean, over that mean.
  static double noise(const State<G>& s) {
    double sum = 0, sum2 = 0, n = 0;
    for (const auto& g : s.groups)
      for (int p = 0; p < g->particles.count; ++p) {
        const double value = g->particles.stress(p, 0);
        sum += value;
        sum2 += value * value;
        ++n;
      }
    return std::sqrt(std::fmax(sum2 / n - sum * sum / (n * n), 0)) / (sum / n);
  }
};
using Geometries = testing::Types<Line, PlaneStrain>;
TYPED_TEST_SUITE(EveryRelaxation, Geometries);

const RelaxationRates by_volume{1, 0, 0}, by_pressure{0, 1, 0}, by_heat{0, 0, 1};

// Round-off of sums over a few hundred particles, three rounds.
TYPED_TEST(EveryRelaxation, KeepsMassMomentumAndEnergy) {
  for (const auto& rates : {by_volume, by_pressure, by_heat})
    for (const auto& choice : test::every_transfer())
      for (const Side side : {Side::wall, Side::periodic, Side::free}) {
        SCOPED_TRACE(test::name_of(choice));
        RandomGas of;
        of.transfer = choice;
        of.side = side;
        of.groups = 2;
        auto state = random_gas<TypeParam>(of);
        const Totals before = test::totals(state);
        for (int k = 0; k < 3; ++k) this->relax_once(state, rates, 0.1);
        const Totals after = test::totals(state);
        EXPECT_NEAR(after.mass / before.mass, 1, 1e-13);
        EXPECT_NEAR(after.internal / before.internal, 1, 1e-13);
        EXPECT_EQ(after.kinetic, before.kinetic);
        for (int d = 0; d < TypeParam::dim; ++d) EXPECT_EQ(after.momentum[d], before.momentum[d]);
      }
}

TYPED_TEST(EveryRelaxation, OfPressureKeepsTheVolumeAndEvensOutNoise) {
  for (const auto& choice : test::every_transfer()) {
    SCOPED_TRACE(test::name_of(choice));
    RandomGas of;
    of.transfer = choice;
    auto state = random_gas<TypeParam>(of);
    const double volume = test::volume(state), noise = this->noise(state);
    for (int k = 0; k < 20; ++k) this->relax_once(state, by_pressure, 0.1);
    EXPECT_NEAR(test::volume(state) / volume, 1, 1e-13);
    // What nodes see stays; with four particles to a node (sixteen in the plane) that is the
    // smaller part.
    EXPECT_LT(this->noise(state), 0.75 * noise);
  }
}

TYPED_TEST(EveryRelaxation, OfVolumeBringsTheVolumesBackToTheSpace) {
  for (const auto& choice : test::every_transfer())
    for (const double wrong : {0.8, 1.25}) {
      SCOPED_TRACE(test::name_of(choice));
      RandomGas of;
      of.transfer = choice;
      of.regular = true;
      of.pressure_range = 0;
      auto state = random_gas<TypeParam>(of);
      auto& p = state.groups[0]->particles;
      for (int q = 0; q < p.count; ++q) p.vol(q) *= wrong;
      const double space = test::volume(state) / wrong;
      this->relax_once(state, {0.1, 0, 0}, 0.1);
      // A tenth of 1 - 1/s, as it says.
      EXPECT_NEAR(test::volume(state) / space, wrong * (1 - 0.1 * (1 - 1 / wrong)), 1e-13);
      for (int k = 0; k < 200; ++k) this->relax_once(state, {0.1, 0, 0}, 0.1);
      EXPECT_NEAR(test::volume(state) / space, 1, 1e-8);  // 0.9^200 = 7e-10
    }
}

TYPED_TEST(EveryRelaxation, OfVolumeLeavesAFreeSurfaceAlone) {
  RandomGas of;
  of.side = Side::free;
  of.regular = true;
  of.cells = 3;
  auto state = random_gas<TypeParam>(of);
  // No node has full surroundings on all sides: those at the surface have half and less.
  const double volume = test::volume(state);
  this->relax_once(state, by_volume, 0.1);
  double middle = 0;
  const auto& p = state.groups[0]->particles;
  for (int q = 0; q < p.count; ++q) middle = std::fmax(middle, p.vol(q));
  EXPECT_NEAR(test::volume(state) / volume, 1, 1e-13);
  EXPECT_NEAR(middle * p.count / volume, 1, 1e-13);
}

TYPED_TEST(EveryRelaxation, LeavesUniformGasAlone) {
  for (const auto& rates : {by_volume, by_pressure, by_heat})
    for (const auto& choice : test::every_transfer())
      for (const Side side : {Side::wall, Side::periodic}) {
        SCOPED_TRACE(test::name_of(choice));
        RandomGas of;
        of.transfer = choice;
        of.side = side;
        of.regular = true;
        of.pressure_range = 0;
        auto state = random_gas<TypeParam>(of);
        const auto& p = state.groups[0]->particles;
        const double v = p.vol(0);
        for (int k = 0; k < 5; ++k) this->relax_once(state, rates, 0.1);
        for (int q = 0; q < p.count; ++q) {
          ASSERT_NEAR(p.vol(q) / v, 1, 1e-13);
          ASSERT_NEAR(p.stress(q, 0), 1, 1e-13);
        }
      }
}

TYPED_TEST(EveryRelaxation, OfHeatActsOnCompressionOnlyAndKeepsVolumes) {
  auto state = random_gas<TypeParam>({});
  auto& p = state.groups[0]->particles;
  std::vector<double> energy;
  for (int q = 0; q < p.count; ++q) {
    p.compression(q, 0) = q % 2 == 0 ? -4 : 4;
    energy.push_back(p.history(q, 0));
  }
  const double volume = test::volume(state);
  this->relax_once(state, by_heat, 0.1);
  EXPECT_EQ(test::volume(state), volume);
  double changed = 0;
  for (int q = 0; q < p.count; ++q) {
    EXPECT_TRUE(q % 2 == 1 || p.history(q, 0) == energy[q]);
    changed += p.history(q, 0) != energy[q];
  }
  EXPECT_GT(changed, 0.4 * p.count);
}

/// finish() with nothing but the work given: particle q of each bin asks for -0.75 or +0.5 or -2 of
/// its energy.
TYPED_TEST(EveryRelaxation, EnergyReceivedNeverLeavesLessThanAFifth) {
  for (const double worst : {-0.75, -1.5, -40.}) {
    SCOPED_TRACE(worst);
    RandomGas of;
    of.per_cell = 8;
    of.passing_lasts = true;
    auto state = random_gas<TypeParam>(of);
    auto& p = state.groups[0]->particles;
    const int bins = state.grid.lattice.size;
    std::vector<double> before, given;
    for (int q = 0; q < p.count; ++q) {
      for (int c = 0; c < TypeParam::dim * TypeParam::dim; ++c) p.gradient(q, c) = 0;
      before.push_back(p.history(q, 0));
      p.work(q, 0) = before[q] * (q % 4 == 0 ? worst : 0.1 * (q % 3));
      given.push_back(p.work(q, 0));
    }
    test::sweep(state.grid.lattice, [&](auto& in) { state.groups[0]->finish(in, state.grid, 0); });
    long floors = 0;
    state.groups[0]->transfer->find_bins(state.grid.lattice, p);
    for (int b = 0; b < bins; ++b) {
      double wanted = 0, spare = 0, is = 0;
      for (int q = 0; q < p.count; ++q) {
        if (p.bin(q) != b) continue;
        wanted += p.m(q) * (before[q] + given[q]);
        spare += p.m(q) * (0.8 * before[q] + given[q]);
        is += p.m(q) * p.history(q, 0);
        EXPECT_GE(p.history(q, 0), 0.2 * before[q] * (1 - 1e-14));
      }
      if (spare < 0) {
        ++floors;  // cannot be kept: all are at their bound
        EXPECT_GT(is, wanted);
      } else if (is > 0) {
        EXPECT_NEAR(is / wanted, 1, 1e-13);
      }
    }
    EXPECT_EQ(state.groups[0]->floors(), floors);
    EXPECT_EQ(floors > 0, worst < -10);
    // Where nobody lacks, everybody gets what is due.
    if (worst > -0.8) {
      for (int q = 0; q < p.count; ++q)
        EXPECT_NEAR(p.history(q, 0), before[q] + given[q], 1e-14 * 3 * before[q]);
    }
  }
}

/// A point of products that press although they have next to no energy left. [SI units]
struct ColdProducts {
  struct Law {
    static constexpr bool conducts = false;
    template <class H>
    static bool relaxes(const H&) {
      return true;
    }
  };
  struct History {
    double energy;
  };
  double energy;
  mutable double scratches[3] = {0, 0.1, 0}, space = 2;

  void look_ahead(int) const {}
  History load(int) const { return {energy}; }
  double mass(int) const { return 1; }
  double volume(int) const { return space; }
  double smooth_pressure(int) const { return 1e5; }
  double compression(int) const { return 0; }
  double scratch(int, int column) const { return scratches[column]; }
  void set_scratch(int, int column, double value) const { scratches[column] = value; }
  void set_volume(int, double value) const { space = value; }
};

// 2e4 J for a tenth more of the volume.
TEST(Exchange, OfVolumeIsNotForPointsThatCannotPay) {
  const fluid_stages::ExchangeVolume exchange{true, 0};
  const ColdProducts rich{1e5}, poor{1e4}, empty{1e-310};
  for (const ColdProducts* point : {&rich, &poor, &empty}) exchange(*point, 0);
  EXPECT_DOUBLE_EQ(rich.space, 2.2);
  EXPECT_DOUBLE_EQ(rich.scratches[0], 0.2);
  for (const ColdProducts* point : {&poor, &empty}) {
    EXPECT_EQ(point->space, 2);
    EXPECT_EQ(point->scratches[0], 0);
  }
}

// What changes in the fourth step alone is what relaxations do.
TYPED_TEST(EveryRelaxation, ComesOnceInAnInterval) {
  RandomGas of;
  of.transfer = {"linear", "FLIP", "cell"};
  auto plain = random_gas<TypeParam>(of), relaxed = random_gas<TypeParam>(of);
  relaxed.scheme.rates = {0.15, 1, 1};
  relaxed.scheme.relaxation_interval = 4;
  relaxed.spare = Accumulator(relaxed.grid.lattice.size, relaxation_columns);
  relaxed.sums = Accumulator(relaxed.grid.lattice.size, relaxation_columns);
  const auto differ = [&] {
    const auto &a = plain.groups[0]->particles, &b = relaxed.groups[0]->particles;
    int count = 0;
    for (int p = 0; p < a.count; ++p) count += a.vol(p) != b.vol(p);
    return count;
  };
  for (int k = 1; k <= 4; ++k) {
    test::step(plain);
    test::step(relaxed);
    EXPECT_EQ(differ() > 0, k == 4) << "step " << k;
  }
}

}  // namespace
}  // namespace brisance
