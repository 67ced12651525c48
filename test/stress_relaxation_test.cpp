// Stress that no node feels: what is taken away of it, and what is left alone.
#include "core/stress_relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/state.hpp"

namespace brisance {
namespace {

/// A lattice of elastic points, four a cell in the plane and two in a line, in a periodic box; its
/// stresses by f(place, number along x).
template <class G, class F>
State<G> lattice(const F& f) {
  test::RandomGas of;
  of.solids = true;
  of.groups = of.classes = 2;
  of.regular = true;
  auto state = test::random_gas<G>(of);
  state.groups.erase(state.groups.begin());
  auto& group = *state.groups[0];
  group.scheme.stress_relaxation = 0.1;
  auto& p = group.particles;
  p.scratch = Table<double>("scratch", p.capacity(), 4);
  const auto stress = p.stress, position = p.position;
  for (int k = 0; k < p.count; ++k)
    for (int c = 0; c < 3; ++c) stress(k, c) = f(position(k, 0), k);
  return state;
}

template <class G>
class StressRelaxation : public testing::Test {};
using Geometries = testing::Types<Line, PlaneStrain>;
TYPED_TEST_SUITE(StressRelaxation, Geometries);

TYPED_TEST(StressRelaxation, LeavesAUniformStressAlone) {
  auto state = lattice<TypeParam>([](double, int) { return 3.; });
  Accumulator means(state.grid.lattice.size, 4);
  relax_stress(state.groups, state.grid, means, 0.1);
  const auto& p = state.groups[0]->particles;
  for (int k = 0; k < p.count; ++k)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(p.stress(k, c), 3, 1e-14);
}

// What alternates from point to point is all but wiped out by the mean over a cell: each call takes
// away nearly its share.
TYPED_TEST(StressRelaxation, TakesAwayWhatAlternates) {
  const auto sign = [](double, int k) { return k % 2 == 0 ? 1. : -1.; };
  auto state = lattice<TypeParam>(sign);
  Accumulator means(state.grid.lattice.size, 4);
  const auto& p = state.groups[0]->particles;
  double before = 0, after = 0;
  for (int k = 0; k < p.count; ++k) before += std::fabs(p.stress(k, 0));
  for (int n = 0; n < 200; ++n) relax_stress(state.groups, state.grid, means, 0.2);
  for (int k = 0; k < p.count; ++k) after += std::fabs(p.stress(k, 0));
  EXPECT_LT(after, 0.2 * before);
}

TYPED_TEST(StressRelaxation, TouchesNoEnergyOfTheBooks) {
  auto state = lattice<TypeParam>([](double, int k) { return k % 3 - 1.; });
  Accumulator means(state.grid.lattice.size, 4);
  const Totals before = test::totals(state);
  relax_stress(state.groups, state.grid, means, 0.1);
  EXPECT_EQ(test::totals(state).total(), before.total());
}

}  // namespace
}  // namespace brisance
