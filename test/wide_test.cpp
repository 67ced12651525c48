// Eight at once are what each of them is alone: the operations on eight numbers, the order of bins
// in a tile, and the laws that are written for both.
#include "core/wide.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "core/tile.hpp"
#include "materials/concrete.hpp"
#include "materials/drucker_prager.hpp"
#include "materials/elastic.hpp"
#include "materials/fluid.hpp"
#include "materials/perfect_gas.hpp"
#include "materials/von_mises.hpp"
#include "point.hpp"

namespace brisance {
namespace {

constexpr int lanes = Wide::lanes;
using Eight = std::array<double, lanes>;

const Eight numbers = {-3.5, -1, -0.25, 0, 0.25, 1, 2.5, 1e6 + 0.5};

Wide wide(const Eight& a) { return Wide::read(a.data()); }

template <class F, class G>
void expect_same(const F& of_eight, const G& of_one) {
  for (int lane = 0; lane < lanes; ++lane)
    EXPECT_EQ(of_eight(wide(numbers))[lane], of_one(numbers[lane])) << "of " << numbers[lane];
}

TEST(Wide, DoesToEachLaneWhatIsDoneToANumber) {
  const auto id = [](auto a) { return a; };
  expect_same(id, id);
  const auto formula = [](auto a) { return (a + 2) * a - 1 / (a * a + 1); };
  for (int lane = 0; lane < lanes; ++lane) {
    const double one = formula(numbers[lane]);
    EXPECT_NEAR(formula(wide(numbers))[lane], one, 1e-15 * std::fabs(one) + 1e-15);
  }
  expect_same([](auto a) { return floor(a); }, [](double a) { return std::floor(a); });
  expect_same([](auto a) { return fabs(a); }, [](double a) { return std::fabs(a); });
  expect_same([](auto a) { return sqrt(a * a); }, [](double a) { return std::sqrt(a * a); });
  const auto clamped = [](auto a) { return clamp(a, decltype(a)(-1), decltype(a)(2)); };
  expect_same(clamped, clamped);
  const auto chosen = [](auto a) {
    using T = decltype(a);
    return select((a > T(0) && a < T(2)) || !(a < T(1e3)), a, T(7));
  };
  expect_same(chosen, chosen);
}

TEST(Wide, KnowsWhatAllItsLanesSay) {
  const Wide a = wide(numbers);
  EXPECT_TRUE(any(a > Wide(1e6)));
  EXPECT_FALSE(any(a > Wide(1e7)));
  EXPECT_EQ(greatest(a), 1e6 + 0.5);
  int whole[lanes];
  a.write_whole(whole);
  for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(whole[lane], static_cast<int>(numbers[lane]));
}

TEST(Wide, IsPermutedByDigits) {
  const Wide turned = wide(numbers).permuted(Wide::digits(0x01234567));
  for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(turned[lane], numbers[lanes - 1 - lane]);
}

TEST(Bundle, WritesItsOwnAndNothingElse) {
  for (const bool room : {true, false})
    for (int count = 1; count < lanes; ++count) {
      Eight column;
      column.fill(9);
      const Bundle<false> bundle{0, count, room};
      bundle.write(column.data(), wide(numbers));
      const Wide back = bundle.read(column.data()), safe = bundle.divisor(back);
      for (int lane = 0; lane < lanes; ++lane) {
        EXPECT_EQ(column[lane], lane < count ? numbers[lane] : 9);
        EXPECT_EQ(back[lane], lane < count ? numbers[lane] : 0);
        EXPECT_EQ(safe[lane], lane < count ? numbers[lane] : 1);
      }
    }
}

TEST(Bundle, RepeatsItsFirstForLaws) {
  for (const bool room : {true, false})
    for (int count = 1; count < lanes; ++count) {
      Eight column = numbers;
      const Bundle<false, true> bundle{0, count, room};
      const Wide read = bundle.read(column.data());
      for (int lane = 0; lane < lanes; ++lane)
        EXPECT_EQ(read[lane], numbers[lane < count ? lane : 0]);
      bundle.write(column.data(), -read);
      for (int lane = 0; lane < lanes; ++lane)
        EXPECT_EQ(column[lane], lane < count ? -numbers[lane] : numbers[lane]);
    }
}

TEST(TileOrder, PutsFullBinsFirstAndKnowsTheWayBack) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    int counts[lanes];
    for (int& n : counts) n = static_cast<int>(random() % 5);
    const TileOrder order = TileOrder::by(counts);
    for (int lane = 1; lane < lanes; ++lane) {
      const int before = order[lane - 1], here = order[lane];
      EXPECT_TRUE(counts[before] > counts[here] ||
                  (counts[before] == counts[here] && before < here));
    }
    const Wide back = Wide::count().permuted(order.bins()).permuted(order.lanes());
    for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(back[lane], lane);
  }
}

/// A strain, a stress and a state of eight points, drawn at random, and of each of them.
template <class Law>
struct Points {
  StrainOf<Wide> in;
  SymOf<Wide> old;
  typename Law::template HistoryOf<Wide> history;
  Strain in_of[lanes];
  Sym3 old_of[lanes];
  typename Law::History history_of[lanes];
};

template <class Law>
Points<Law> drawn(double rate, double stress, double rho, const Eight& energy) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> within(-1, 1);
  Points<Law> p;
  p.in.dt = 1e-6;
  p.in.h = 0.01;
  for (auto& one : p.in_of) one.dt = p.in.dt, one.h = p.in.h;
  const auto spread = [&](Wide& all, const auto& to_one, double size, double mean = 0) {
    all = Wide::of([&](int lane) { return to_one(lane) = mean + size * within(random); });
  };
  for (int k = 0; k < 4; ++k) {
    spread(
        p.in.rate[k], [&](int l) -> double& { return p.in_of[l].rate[k]; }, rate);
    spread(
        p.old[k], [&](int l) -> double& { return p.old_of[l][k]; }, stress);
  }
  spread(
      p.in.rho0, [&](int l) -> double& { return p.in_of[l].rho0; }, 0.1 * rho, rho);
  spread(
      p.in.smoothness, [&](int l) -> double& { return p.in_of[l].smoothness; }, 0.5, 0.5);
  p.in.rho1 = p.in.rho0 / (1 + trace(p.in.rate) * p.in.dt);
  p.in.volume_change = trace(p.in.rate) * p.in.dt / p.in.rho0;
  p.history.energy = wide(energy);
  for (int lane = 0; lane < lanes; ++lane) {
    p.in_of[lane].rho1 = p.in.rho1[lane];
    p.in_of[lane].volume_change = p.in.volume_change[lane];
    p.history_of[lane].energy = energy[lane];
  }
  return p;
}

/// Both answers agree to round-off of `size`, which the compiler's choice of fused operations
/// leaves. The law is asked several times, so that its state is that of work done.
template <class Law>
void expect_alike(const Law& law, Points<Law> p, double size) {
  for (int step = 0; step < 5; ++step) {
    const ResponseOf<Wide> all = law.update(p.in, p.old, p.history);
    const Wide signal = law.signal_speed(p.in.rate, p.in.rho1, all.sound_speed, p.in.h);
    for (int lane = 0; lane < lanes; ++lane) {
      const Response one = law.update(p.in_of[lane], p.old_of[lane], p.history_of[lane]);
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(all.stress[k][lane], one.stress[k], 1e-13 * size);
      EXPECT_NEAR(all.sound_speed[lane], one.sound_speed, 1e-13 * one.sound_speed);
      const double alone =
          law.signal_speed(p.in_of[lane].rate, p.in_of[lane].rho1, one.sound_speed, p.in.h);
      EXPECT_NEAR(signal[lane], alone, 1e-13 * alone);
      for (int k = 0; k < Law::field_count; ++k) {
        const double there = (p.history.*(Law::template fields_of<Wide>[k].member))[lane],
                     here = p.history_of[lane].*(Law::fields[k].member);
        EXPECT_NEAR(there, here, 1e-12 * std::fabs(here) + 1e-300) << Law::fields[k].name;
      }
      p.old_of[lane] = one.stress;
    }
    p.old = all.stress;
  }
}

constexpr Eight energies = {0, 1e4, 1e5, 2e5, 3e5, 1e6, 2e6, 5e6};

TEST(WideLaw, OfAGasIsTheLawOfOnePoint) {
  const PerfectGas air(1.4);
  using Still = Fluid<PerfectGas>;
  expect_alike(Still(air, {}, {}), drawn<Still>(1e5, 1e5, 1.2, energies), 1e6);
  for (const auto form :
       {ShockViscosity::Form::kurapatenko, ShockViscosity::Form::von_neumann_richtmyer}) {
    using Shocked = Fluid<PerfectGas, Newtonian, ShockViscosity>;
    ShockViscosity shock;
    shock.form = form;
    expect_alike(Shocked(air, Newtonian(1e-2, 2e-2), shock),
                 drawn<Shocked>(1e5, 1e5, 1.2, energies), 1e6);
  }
}

TEST(WideLaw, OfElasticMatterIsTheLawOfOnePoint) {
  expect_alike(law_of<Elastic>(steel(0)), drawn<Elastic>(1e3, 1e8, 7850, energies), 1e9);
}

TEST(WideLaw, OfSteelIsTheLawOfOnePointWhetherItYieldsOpensOrFails) {
  List hardening = steel(3e8), weak = steel(3e8);
  hardening.set("hardening modulus", 1e9);
  weak.set("tension cut-off", 1e8).set("failure strain", 2e-3);
  for (const List& list : {steel(3e8), hardening, weak})
    for (const double rate : {1e2, 1e3, 1e4})  // some, most, all yield
      expect_alike(law_of<VonMises>(list), drawn<VonMises>(rate, 2e8, 7850, energies), 1e10);
}

TEST(WideLaw, OfRockIsTheLawOfOnePointOnTheConeAndAtItsApex) {
  List rock = steel(0);
  rock.set("cone", "alpha and k").set("alpha", 0.3).set("k", 8e6).set("dilatancy", 0.1);
  for (const double stress : {1e6, 1e7, 1e8})  // some, most, all outside
    expect_alike(law_of<DruckerPrager>(rock), drawn<DruckerPrager>(1e2, stress, 7850, energies),
                 1e9);
}

TEST(WideLaw, OfConcreteIsTheLawOfOnePointWhetherItCracksPartsOrIsPressed) {
  List recovers, always, brittle;
  recovers.set("recover stiffness", true).set("flaw exponent", 6.5);
  always.set("shear limit in tension", "always");
  brittle.set("softening exponent", 0.5);
  for (const List& list : {List(), recovers, always, brittle})
    for (const double rate : {30., 100., 1000.})  // some, most, all come apart
      expect_alike(law_of<Concrete>(list), drawn<Concrete>(rate, 1e6, 2320, energies), 1e9);
}

}  // namespace
}  // namespace brisance
