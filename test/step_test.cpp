// Scenes of seconds through whole simulations: what must stay as it is, what must be the same seen
// otherwise, and waves whose answer is known.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/commands.hpp"
#include "drivers/locations.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using test::scene;
using test::simulated;
using Assignments = std::vector<std::string>;

const std::vector<std::string> every_preset = {"paper", "fast", "balanced", "accurate"};

Assignments operator+(Assignments a, const Assignments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Assignments periodic(int dim) {
  Assignments a = {"boundaries/x low=periodic", "boundaries/x high=periodic"};
  if (dim > 1) a = a + Assignments{"boundaries/y low=periodic", "boundaries/y high=periodic"};
  return a;
}

double spread(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

// A hundred steps or so, each of which rounds sums of a few terms of order 1. Three particles to a
// cell, evenly spaced, weigh the same at every node wherever they are, so this holds for every
// quadrature.
TEST(UniformGas, StaysAsItIsAtRestAndInMotion) {
  for (const int dim : {1, 2})
    for (const auto& preset : every_preset)
      for (const bool moving : {false, true}) {
        SCOPED_TRACE(preset + (moving ? ", moving" : ", at rest") + " in " + std::to_string(dim));
        Assignments a = Assignments{"preset=" + preset, "time/end=0.5"} + periodic(dim);
        if (dim == 2) a.push_back("grid/cells={8, 6}");
        const std::string v = dim == 1 ? "{0.7}" : "{0.7, -0.4}";
        if (moving) a = a + Assignments{"bodies/first/velocity=" + v, "bodies/rest/velocity=" + v};
        const ParticleTable t = simulated(scene(dim, a))->snapshot().table;
        const double most = 1e-12;
        EXPECT_LT(spread(t.vx), most);
        EXPECT_LT(spread(t.pressure), most);
        EXPECT_LT(spread(t.volume), most * 0.1);
        EXPECT_NEAR(t.vx[0], moving ? 0.7 : 0, most);
        if (dim == 2) {
          EXPECT_LT(spread(t.vy), most);
        }
      }
}

// Sod's tube at 100 cells; an error of first order is twice that at the 200 cells whose limits
// stand in inputs/sod.xml. `fast` has a viscosity without limiter, which on the Riemann problem
// costs a fifth. `paper` reaches 4.9, 6.4, 5.5, 2.1 % at 200 (accuracy of the printed scheme).
TEST(SodTube, IsReachedByEveryPreset) {
  for (const auto& preset : every_preset) {
    SCOPED_TRACE(preset);
    const List sod = load_scene({(data_folder() / "inputs/sod.xml").string(),
                                 preset,
                                 {"grid/cells={100}", "grid/cell size=0.01"}});
    const auto exact = make_exact(sod.sublist("exact"));
    const auto simulation = simulated(sod, exact.get());
    const bool paper = preset == "paper";
    const double share = preset == "fast" ? 1.2 : 1;
    for (const Measure& m : exact->measures(simulation->snapshot().table, 0.2)) {
      const double most = m.name == "L1 density"    ? (paper ? 0.098 : 0.018)
                          : m.name == "L1 velocity" ? (paper ? 0.128 : 0.05)
                          : m.name == "L1 pressure" ? (paper ? 0.11 : 0.02)
                          : m.name == "L1 energy"   ? (paper ? 0.042 : 0.012)
                                                    : 1e300;
      EXPECT_LT(m.value, share * most) << m.name;
    }
    const Balance end = simulation->balance();
    const Ledger ledger(make_simulation(sod, exact.get())->balance());
    EXPECT_NEAR(ledger.mass_error(end), 0, 1e-13);
    EXPECT_NEAR(ledger.momentum_error(end), 0, 1e-12);
    if (!paper) {
      EXPECT_NEAR(ledger.energy_error(end), 0, 1e-12);
    }
    EXPECT_EQ(end.floors, 0);
  }
}

const Assignments even_numbers = {"bodies/first/particles per cell=2",
                                  "bodies/rest/particles per cell=2"};
const Assignments tube = {"bodies/first/pressure=10", "bodies/first/density=4", "time/end=0.15"};

// The mirrored tube adds the same numbers in another order: round-off, which a hundred steps of a
// stable scheme do not magnify beyond 1e-10. (The printed scheme is not stable in that sense.) Bins
// of quadratic shapes end in the middle of cells: no particle may start there, where it belongs to
// the right bin in both tubes and shares the heat of different particles; nor may one be as long as
// those that are split, where round-off decides.
TEST(Symmetry, OfAMirroredTubeIsExact) {
  for (const char* preset : {"fast", "balanced", "accurate"}) {
    SCOPED_TRACE(preset);
    const Assignments common =
        Assignments{std::string("preset=") + preset, "scheme/split length=0.6", "time/end=0.15"} +
        even_numbers;
    const auto left = simulated(scene(1, common + tube))->snapshot().table;
    const auto right = simulated(scene(1, common + Assignments{"bodies/rest/pressure=10",
                                                               "bodies/rest/density=4"}))
                           ->snapshot()
                           .table;
    EXPECT_LT(test::distance(left, test::mirrored(right, 0, 1)), 1e-10);
  }
}

TEST(Symmetry, OfABlastInTheMiddleIsFourfold) {
  for (const char* preset : {"fast", "balanced", "accurate"}) {
    SCOPED_TRACE(preset);
    const Assignments blast = {std::string("preset=") + preset,
                               "grid/cells={16, 16}",
                               "grid/origin={-0.8, -0.8}",
                               "bodies/first/box/low={-0.2, -0.2}",
                               "bodies/first/box/high={0.2, 0.2}",
                               "bodies/first/pressure=100",
                               "time/end=0.05"};
    const auto t = simulated(scene(2, blast + even_numbers))->snapshot().table;
    EXPECT_LT(test::distance(t, test::mirrored(t, 0, 0)), 1e-10);
    EXPECT_LT(test::distance(t, test::mirrored(t, 1, 0)), 1e-10);
    EXPECT_LT(test::distance(t, test::transposed(t)), 1e-10);
  }
}

TEST(Symmetry, OfTubesAlongXAndY) {
  for (const char* preset : {"fast", "balanced", "accurate"}) {
    SCOPED_TRACE(preset);
    const Assignments common = tube + Assignments{std::string("preset=") + preset};
    const auto x =
        simulated(scene(2, common + Assignments{"grid/cells={20, 2}"}))->snapshot().table;
    const auto y = simulated(scene(2, common + Assignments{"grid/cells={2, 20}",
                                                           "bodies/first/box/high={1e9, 1}"}))
                       ->snapshot()
                       .table;
    EXPECT_LT(test::distance(x, test::transposed(y)), 1e-10);
  }
}

// Without splitting, which cuts at another length in the plane, a plane-strain tube one cell wide
// is the same problem as the line. Nothing moves across.
TEST(Symmetry, OfATubeOneCellWideAndTheLine) {
  for (const char* preset : {"fast", "balanced", "accurate"}) {
    SCOPED_TRACE(preset);
    const Assignments common =
        tube + Assignments{std::string("preset=") + preset, "scheme/split length=0"};
    const auto line = simulated(scene(1, common))->snapshot().table;
    const auto plane =
        simulated(
            scene(2, common + Assignments{"boundaries/y low=periodic", "boundaries/y high=periodic",
                                          "bodies/first/particles per cell=3"}))
            ->snapshot()
            .table;
    // Three rows of particles in the plane for one on the line: compare per layer of cells.
    const auto a = sums_per_layer(line, 0), b = sums_per_layer(plane, 0);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_NEAR(b[k].mean_density() / a[k].mean_density(), 1, 1e-10) << "layer " << k;
      EXPECT_NEAR(b[k].mean_pressure() / a[k].mean_pressure(), 1, 1e-10) << "layer " << k;
      EXPECT_NEAR(b[k].mean_velocity()[0], a[k].mean_velocity()[0], 1e-10) << "layer " << k;
    }
    for (const double v : plane.vy) EXPECT_NEAR(v, 0, 1e-10);
  }
}

}  // namespace
}  // namespace brisance
