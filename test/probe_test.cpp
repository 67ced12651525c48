// What is seen through a window, and how one rides on matter.
#include "drivers/probe.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/state.hpp"

namespace brisance {
namespace {

using test::every_transfer;
using test::name_of;
using test::RandomGas;

double spline(double z) {
  const double r = std::fabs(z);
  return r < 0.5 ? 0.75 - r * r : (r < 1.5 ? 0.5 * (1.5 - r) * (1.5 - r) : 0);
}

/// The mean of all particles and their images beyond joined ends, without bins.
template <class G>
Seen summed(const State<G>& state, const Window& window) {
  constexpr int D = G::dim;
  Seen seen;
  double volume = 0, mass = 0;
  for (std::size_t g = 0; g < state.groups.size(); ++g) {
    if (window.material >= 0 && window.material != static_cast<int>(g)) continue;
    const auto& group = *state.groups[g];
    const Particles<G>& p = group.particles;
    const Array<double> pressure("pressure", p.count), energy("energy", p.count);
    group.report(pressure, energy);
    for (int image = 0; image < power(3, D); ++image)
      for (int q = 0; q < p.count; ++q) {
        double w = 1;
        for (int d = 0; d < D; ++d) {
          const int turn = image / power(3, d) % 3 - 1;
          if (turn != 0 && state.grid.boundaries.side[d][0] != Side::periodic) w = 0;
          const double length = state.grid.lattice.cells[d] * state.grid.lattice.h;
          w *= spline((p.position(q, d) - window.place[d] - turn * length) / window.radius);
        }
        if (!(w > 0)) continue;
        ++seen.points;
        volume += w * p.vol(q);
        mass += w * p.m(q);
        seen.pressure += w * p.vol(q) * pressure(q);
        for (int d = 0; d < D; ++d) seen.velocity[d] += w * p.m(q) * p.velocity(q, d);
      }
  }
  if (seen.points == 0) return {};
  seen.pressure /= volume;
  for (double& v : seen.velocity) v /= mass;
  return seen;
}

template <class G>
class Probe : public testing::Test {};
using Geometries = testing::Types<Line, PlaneStrain>;
TYPED_TEST_SUITE(Probe, Geometries);

// Places in the middle, at an end and beyond it; radii of less than a cell, and so wide that all is
// in reach. Sums of a few hundred terms in another order: round-off.
TYPED_TEST(Probe, SumsAllParticlesInReach) {
  for (const auto& transfer : every_transfer())
    for (const Side side : {Side::periodic, Side::wall}) {
      SCOPED_TRACE(name_of(transfer));
      RandomGas of;
      of.transfer = transfer;
      of.side = side;
      of.groups = 2;
      const auto state = test::random_gas<TypeParam>(of);
      for (const double place : {0.1, -1.2, 1.75, 2.0})
        for (const double radius : {0.05, 0.5, 1.9})
          for (const int material : {-1, 1}) {
            const Window window{{place, -place / 2, 0}, radius, material, false};
            const Seen seen = probe(state, {window}).front(), all = summed(state, window);
            EXPECT_EQ(seen.points, all.points) << place << " " << radius;
            EXPECT_NEAR(seen.pressure, all.pressure, 1e-13);
            for (int d = 0; d < TypeParam::dim; ++d)
              EXPECT_NEAR(seen.velocity[d], all.velocity[d], 1e-13);
          }
    }
}

// However the particles lie, and whatever their volumes: it is their mean.
TYPED_TEST(Probe, OfAUniformFieldIsExact) {
  RandomGas of;
  of.pressure_range = 0;
  of.velocity_range = 0;
  const auto state = test::random_gas<TypeParam>(of);
  for (const double place : {-1.25, -0.4, 0.33, 1.75}) {
    const Seen seen = probe(state, {{{place, 0.2, 0}, 0.5, -1, false}}).front();
    EXPECT_GT(seen.points, 0);
    EXPECT_NEAR(seen.pressure, 1, 1e-14);
    EXPECT_EQ(seen.velocity[0], 0);
  }
}

TYPED_TEST(Probe, SeesNothingWhereNothingIs) {
  RandomGas of;
  of.side = Side::wall;
  const auto state = test::random_gas<TypeParam>(of);
  const Seen seen = probe(state, {{{5, 0, 0}, 0.5, -1, false}}).front();
  EXPECT_EQ(seen.points, 0);
  EXPECT_EQ(seen.pressure, 0);
}

// Two materials on the same nodes, a gas and a solid at other velocities.
TYPED_TEST(Probe, PrefersFluidsUnlessAMaterialIsNamed) {
  RandomGas of;
  of.groups = of.classes = 2;
  of.solids = true;
  const auto state = test::random_gas<TypeParam>(of);
  const auto seen = probe(
      state, {{{0, 0, 0}, 0.5, -1, false}, {{0, 0, 0}, 0.5, 0, false}, {{0, 0, 0}, 0.5, 1, false}});
  EXPECT_EQ(seen[0].pressure, seen[1].pressure);
  EXPECT_NE(seen[0].pressure, seen[2].pressure);
  EXPECT_NEAR(seen[2].pressure, summed(state, {{0, 0, 0}, 0.5, 1, false}).pressure, 1e-13);
}

// A window that starts where a particle is stays with it, to the last digits of the sum over
// nodes. GIMP moves by the size of a particle, which a window does not have.
TYPED_TEST(Probe, ThatRidesMovesAsAParticleDoes) {
  constexpr int D = TypeParam::dim;
  for (const auto& transfer : every_transfer())
    for (const bool midpoint : {true, false})
      for (const Side side : {Side::periodic, Side::wall}) {
        if (transfer.shape == "GIMP" || (!midpoint && transfer.scheme != "FLIP")) continue;
        SCOPED_TRACE(name_of(transfer) + (midpoint ? ", midpoint" : ", MUSL"));
        RandomGas of;
        of.transfer = transfer;
        of.midpoint = midpoint;
        of.side = side;
        auto state = test::random_gas<TypeParam>(of);
        const Particles<TypeParam>& p = state.groups[0]->particles;
        std::vector<Window> windows(p.count);
        for (int q = 0; q < p.count; ++q) {
          windows[p.id(q)].rides = p.id(q) % 3 != 0;
          for (int d = 0; d < D; ++d) windows[p.id(q)].place[d] = p.position(q, d);
        }
        const auto start = windows;
        Riders<TypeParam> riders;
        for (int k = 0; k < 3; ++k) riders.carry(state, test::step(state), windows);
        for (int q = 0; q < p.count; ++q)
          for (int d = 0; d < D; ++d) {
            const Window& w = windows[p.id(q)];
            EXPECT_NEAR(w.place[d], w.rides ? p.position(q, d) : start[p.id(q)].place[d], 1e-12);
          }
      }
}

}  // namespace
}  // namespace brisance
