// Gas that no wave has reached sleeps: who may, that it wakes in time, and that nobody can tell.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <set>

#include "drivers/files.hpp"
#include "drivers/kernels.hpp"
#include "drivers/ledger.hpp"
#include "drivers/run.hpp"
#include "drivers/scene.hpp"
#include "test/program.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using Assignments = std::vector<std::string>;

Assignments operator+(Assignments a, const Assignments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Assignments sleeping = {"scheme/sleep=true"};

long asleep(const Simulation& simulation) { return simulation.sleeping()->particles; }

std::unique_ptr<Simulation> started(int dim, const Assignments& assignments) {
  return make_simulation(test::scene(dim, assignments + sleeping), nullptr);
}

TEST(Sleep, TakesUniformGasAtRestBetweenWallsAsAWhole) {
  for (const int dim : {1, 2}) {
    const auto simulation = started(dim, {"grid/cells={20" + std::string(dim == 1 ? "}" : ", 7}")});
    EXPECT_EQ(asleep(*simulation), simulation->particle_count());
    const double dt = simulation->dt();
    const double energy = simulation->balance().totals.internal;
    for (int k = 0; k < 20; ++k) simulation->advance(1);
    EXPECT_EQ(asleep(*simulation), simulation->particle_count());
    EXPECT_EQ(simulation->balance().totals.internal, energy);
    // Steps are those of the gas as if it were awake.
    const auto awake = make_simulation(
        test::scene(dim, {"grid/cells={20" + std::string(dim == 1 ? "}" : ", 7}")}), nullptr);
    EXPECT_EQ(dt, awake->dt());
  }
}

TEST(Sleep, LeavesSixCellsAwakeBeforeWhatIsNotTheSame) {
  const long each = 3;  // points to the cell
  EXPECT_EQ(asleep(*started(1, {})), 20 * each);
  // The other state, or the other kind of end, lies beyond the tenth or the twentieth cell.
  EXPECT_EQ(asleep(*started(1, {"bodies/first/pressure=2"})), (4 + 4) * each);
  EXPECT_EQ(asleep(*started(1, {"bodies/first/density=2"})), (4 + 4) * each);
  EXPECT_EQ(asleep(*started(1, {"bodies/first/velocity={0.1}"})), 4 * each);
  EXPECT_EQ(asleep(*started(1, {"boundaries/x high=free"})), 14 * each);
  EXPECT_EQ(asleep(*started(1, {"boundaries/x low=periodic", "boundaries/x high=periodic"})),
            8 * each);
  // Points that are about to be split.
  EXPECT_EQ(asleep(*started(1, {"bodies/first/particles per cell=1"})), 4 * each);
  // Another number of points to the cell is no other state.
  EXPECT_EQ(asleep(*started(1, {"bodies/first/particles per cell=2"})), 10 * 2 + 10 * each);
}

TEST(Sleep, IsOfPerfectGasesWithoutShearOnly) {
  List given = test::scene(1, sleeping);
  given.sublist("materials").sublist("rock") = test::elastic_material();
  given.sublist("bodies").sublist("first").set("material", "rock");
  EXPECT_EQ(asleep(*make_simulation(complete_scene(given), nullptr)), 4 * 3);
  EXPECT_EQ(asleep(*started(1, {"materials/gas/viscosity/shear=0.001"})), 0);
}

TEST(Sleep, NeedsASchemeInWhichGasAtRestStandsStill) {
  for (const char* other : {"preset=paper", "preset=accurate", "scheme/quadrature=particle"}) try {
      test::scene(1, {other, "scheme/sleep=true"});
      FAIL() << other;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("'sleep'"), std::string::npos) << error.what();
    }
}

/// Of a blast into gas at rest: how far points are from those of the run in which all are awake,
/// over the largest value in each column; and what was saved.
struct Comparison {
  double distance = 0;
  double mass = 0, momentum = 0, energy = 0;  ///< errors with sleep [-]
  double saved = 0;                           ///< share of particle-steps [-]
  long asleep_at_end = 0;
  double impulse = 0;
  bool same_steps = false;
};

Comparison compare(int dim, const Assignments& assignments) {
  const auto off = test::simulated(test::scene(dim, assignments));
  const List scene = test::scene(dim, assignments + sleeping);
  const auto on = make_simulation(scene, nullptr);
  const Ledger ledger(on->balance());
  double slept = 0, all = 0;
  while (on->time() < get<double>(scene.sublist("time"), "end")) {
    on->advance(get<double>(scene.sublist("time"), "end"));
    slept += static_cast<double>(asleep(*on));
    all += static_cast<double>(on->particle_count());
  }
  Comparison c;
  c.distance = test::distance(on->snapshot().table, off->snapshot().table);
  const Balance end = on->balance();
  c.mass = std::fabs(ledger.mass_error(end));
  c.momentum = std::fabs(ledger.momentum_error(end));
  c.energy = std::fabs(ledger.energy_error(end));
  c.saved = slept / all;
  c.asleep_at_end = asleep(*on);
  c.impulse = on->sleeping()->impulse;
  c.same_steps = on->step_count() == off->step_count();
  return c;
}

/// What lies beyond the margin is at rest to 1e-9 of its state, and six cells on to far less; the
/// rest is round-off, which grows with the steps.
void expect_the_same(const Comparison& c) {
  EXPECT_TRUE(c.same_steps);
  EXPECT_LT(c.distance, 1e-9);
  EXPECT_LT(c.mass, 1e-12);
  EXPECT_LT(c.momentum, 1e-12);
  EXPECT_LT(c.energy, 1e-12);
  EXPECT_LT(c.impulse, 1e-9);  // of a pressure of 1 over a time of 0.1
}

TEST(Sleep, OfGasInATubeEndsBeforeTheBlast) {
  for (const char* pressure : {"1.01", "10", "1000"}) {
    SCOPED_TRACE(pressure);
    const Comparison c =
        compare(1, {"grid/cells={200}", "bodies/first/box/low={9.5}", "bodies/first/box/high={10}",
                    std::string("bodies/first/pressure=") + pressure});
    expect_the_same(c);
    EXPECT_GT(c.saved, 0.6);
    EXPECT_GT(c.asleep_at_end, 0);
  }
}

const Assignments blast = {"grid/cells={64, 48}",
                           "bodies/first/box/low={1.6, 1.2}",
                           "bodies/first/box/high={2, 1.6}",
                           "bodies/first/pressure=1000",
                           "bodies/rest/particles per cell=1",
                           "boundaries/y high=free",
                           "time/end=0.05"};

TEST(Sleep, AroundABlastEndsBeforeItsFront) {
  const Comparison c = compare(2, blast);
  expect_the_same(c);
  EXPECT_GT(c.saved, 0.15);
}

TEST(Sleep, IsOverWhenTheBlastHasBeenEverywhere) {
  const Comparison c = compare(2, blast + Assignments{"grid/cells={40, 32}", "time/end=0.2"});
  expect_the_same(c);
  EXPECT_GT(c.saved, 0);
  EXPECT_EQ(c.asleep_at_end, 0);
}

// Gas between a wall at rest, which pushes it, and the blast.
TEST(Sleep, OfGasBesideASolidIsTheSame) {
  List given = test::scene(2, blast);
  given.sublist("materials").sublist("rock") = test::elastic_material();
  List& rock = given.sublist("bodies").sublist("first");
  rock.set("material", "rock").set("pressure", 0.5).set("particles per cell", 1);
  const auto end = [&](bool on) {
    given.sublist("scheme").set("sleep", on);
    return test::simulated(complete_scene(given));
  };
  const auto on = end(true), off = end(false);
  EXPECT_GT(asleep(*on), 0);
  EXPECT_LT(test::distance(on->snapshot().table, off->snapshot().table), 1e-9);
}

TEST(Sleep, IsSeenByNoGauge) {
  const auto on = started(2, blast), off = make_simulation(test::scene(2, blast), nullptr);
  for (const auto& s : {on.get(), off.get()})
    for (int k = 0; k < 10; ++k) s->advance(1);
  std::vector<Window> windows(3);
  for (int k = 0; k < 3; ++k) {
    windows[k].place = {0.15 + 1.5 * k, 0.15 + 1.2 * k, 0};
    windows[k].radius = 0.15;
  }
  const auto a = on->probe(windows), b = off->probe(windows);
  for (int k = 0; k < 3; ++k) {
    EXPECT_GT(a[k].points, 0);
    EXPECT_EQ(a[k].points, b[k].points);
    EXPECT_NEAR(a[k].pressure, b[k].pressure, 1e-9 * b[k].pressure);
  }
}

TEST(Sleep, OfAllPointsIsTheSameRunAfterRun) {
  const auto end = [] { return test::simulated(test::scene(2, blast + sleeping))->snapshot(); };
  const Snapshot a = end(), b = end();
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.table.x, b.table.x);
  EXPECT_EQ(a.table.vy, b.table.vy);
  EXPECT_EQ(a.table.energy, b.table.energy);
}

TEST(Sleep, IsToldByTheRun) {
  const test::Folder folder("sleep");
  RunOptions options;
  options.folder = folder.path;
  options.quiet = true;
  const RunResult result = run(test::scene(2, blast + sleeping), options);
  EXPECT_GT(result.outcome.share_asleep(), 0.15);
  EXPECT_LT(result.outcome.share_asleep(), 1);
  EXPECT_NE(read_file(folder.path / "summary.json").find("\"asleep\": 0."), std::string::npos);
  EXPECT_NE(read_file(folder.path / "log.txt").find(" % of particle-steps saved"),
            std::string::npos);
  options.folder.clear();
  EXPECT_FALSE(run(test::scene(1, {}), options).outcome.asleep);
}

std::set<std::string> kernels_of_a_step(const Assignments& assignments) {
  const auto simulation = make_simulation(test::scene(2, assignments), nullptr);
  simulation->advance(1);
  std::set<std::string> names;
  for (const auto& [name, launches] : kernels_of([&] { simulation->advance(1); }))
    names.insert(name);
  return names;
}

TEST(Sleep, CostsNothingWhereItIsOff) {
  const Assignments short_tube = {"grid/cells={40, 6}", "bodies/first/pressure=2"};
  const auto off = kernels_of_a_step(short_tube), on = kernels_of_a_step(short_tube + sleeping);
  for (const char* kernel :
       {"watch for sleepers", "press of sleepers", "fill of sleepers", "hold sleepers"}) {
    EXPECT_EQ(on.count(kernel), 1u) << kernel;
    EXPECT_EQ(off.count(kernel), 0u) << kernel;
  }
  const auto plain = make_simulation(test::scene(2, short_tube), nullptr)->footprint(),
             with = started(2, short_tube)->footprint();
  EXPECT_LT(plain.grid_bytes, with.grid_bytes);
  EXPECT_EQ(plain.particles, with.particles);
  ASSERT_EQ(plain.columns.size(), with.columns.size());
  for (std::size_t k = 0; k < plain.columns.size(); ++k)
    EXPECT_EQ(plain.columns[k].bytes, with.columns[k].bytes);
  EXPECT_FALSE(make_simulation(test::scene(2, short_tube), nullptr)->sleeping());
}

}  // namespace
}  // namespace brisance
