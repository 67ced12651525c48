// Model only what the scene requires: the kernels that a step launches and the bytes that a
// particle takes are listed here in full. Who adds a kernel or a column says so in this file.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <map>
#include <set>

#include "drivers/kernels.hpp"
#include "drivers/scene.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using Names = std::set<std::string>;
using Columns = std::map<std::string, double>;

struct Cost {
  std::map<std::string, int> kernels;
  Columns columns;

  bool launches(const std::string& kernel) const { return kernels.count(kernel) > 0; }
  Names names() const {
    Names all;
    for (const auto& [name, launches] : kernels) all.insert(name);
    return all;
  }
  double bytes() const {
    double sum = 0;
    for (const auto& [name, b] : columns) sum += b;
    return sum;
  }
};

/// Of a step of a scene that neither splits nor is at rest, one in which fluids relax.
Cost cost_of(const List& scene) {
  const auto simulation = make_simulation(scene, nullptr);
  for (int step = 0; step < 3; ++step) simulation->advance(1);
  Cost cost;
  for (const auto& [name, launches] : kernels_of([&] { simulation->advance(1); }))
    if (name.compare(0, 8, "Kokkos::") != 0)  // filling and summing views, named by the library
      cost.kernels[name] = launches;
  for (const auto& column : simulation->footprint().columns)
    cost.columns[column.name] = column.bytes;
  return cost;
}

Cost cost_of(int dim, const std::vector<std::string>& assignments) {
  std::vector<std::string> a = {"bodies/first/pressure=2"};
  a.insert(a.end(), assignments.begin(), assignments.end());
  return cost_of(test::scene(dim, a));
}

const Names sorting = {"find bins", "count bins", "places of bins", "order of particles",
                       "lay tiles"};

Names operator+(Names a, const Names& b) {
  a.insert(b.begin(), b.end());
  return a;
}
Names operator-(Names a, const Names& b) {
  for (const auto& name : b) a.erase(name);
  return a;
}

// In the second step no particle changes its cell, so nothing is permuted.
const Names permuting = {"permute"};

TEST(Cost, OfPaperOnALineIsTheStepOfAppendixA) {
  const Cost cost = cost_of(1, {"preset=paper"});
  EXPECT_EQ(cost.names() - permuting,
            (sorting + Names{"scatter momentum", "hold wall", "nodal velocity", "signals",
                             "fastest signals", "scatter force", "move grid", "accelerate",
                             "gradient and move", "update"}));
  EXPECT_EQ(cost.kernels.at("scatter momentum"), 2);  // (A.2) and (A.11)
  EXPECT_EQ(cost.kernels.at("scatter force"), 1);
  EXPECT_EQ(cost.columns, (Columns{{"position", 8},
                                   {"velocity", 8},
                                   {"mass", 8},
                                   {"volume", 8},
                                   {"stress", 8},
                                   {"history", 8},
                                   {"id", 8},
                                   {"bin", 4}}));
  EXPECT_EQ(cost.bytes(), 60);
}

TEST(Cost, OfBalancedInThePlaneIsThis) {
  const Cost cost = cost_of(2, {"preset=balanced"});
  EXPECT_EQ(
      cost.names() - permuting,
      (sorting +
       Names{"scatter momentum", "hold wall", "nodal velocity", "gather gradient", "signals",
             "fastest signals", "fastest strain",
             // cells: volumes to fill them, and the limiter
             "scatter volume", "describe cells", "fill halo cells", "scale cells", "limit cells",
             // the midpoint
             "half step", "scatter force", "move grid", "finish midpoint", "strain",
             "receive energy", "longest particle", "longest of rows",
             // relaxations
             "scatter mean", "gather scalar", "scatter two means", "gather two scalars",
             "nodal mean", "fullness", "correct volume", "load pressure", "propose exchange",
             "exchange volume", "exchange energy", "receive exchange"}));
  EXPECT_EQ(cost.kernels.at("scatter momentum"), 1);
  EXPECT_EQ(cost.kernels.at("scatter force"), 1);
  EXPECT_EQ(cost.columns, (Columns{{"position", 16},
                                   {"velocity", 16},
                                   {"scratch", 24},
                                   {"mass", 8},
                                   {"volume", 8},
                                   {"stress", 8},
                                   {"history", 8},
                                   {"extent", 16},
                                   {"compression", 8},
                                   {"id", 8},
                                   {"bin", 4}}));
  EXPECT_EQ(cost.bytes(), 124);
}

TEST(Cost, OfAffineMotionIsOneMatrix) {
  const Cost plain = cost_of(
                 2, {"preset=balanced", "scheme/shape=quadratic", "scheme/quadrature=particle"}),
             affine = cost_of(2, {"preset=accurate"});
  EXPECT_EQ(affine.bytes() - plain.bytes(), 32);
  EXPECT_EQ(affine.columns.at("affine"), 32);
  EXPECT_EQ(affine.names() - permuting, plain.names() - permuting);
}

TEST(Cost, OfTensorsIsPaidByViscousMaterialsOnly) {
  const Cost viscous = cost_of(1, {"materials/gas/viscosity/shear=0.001"});
  EXPECT_EQ(viscous.columns.at("stress"), 24);
  EXPECT_TRUE(viscous.launches("scatter tensor force"));
  EXPECT_FALSE(viscous.launches("scatter force"));
  const Cost inviscid = cost_of(1, {});
  EXPECT_EQ(inviscid.columns.at("stress"), 8);
  EXPECT_FALSE(inviscid.launches("scatter tensor force"));
}

TEST(Cost, OfWhatIsNotAskedForIsNothing) {
  const Cost all = cost_of(2, {});
  const auto without = [](const std::vector<std::string>& a) { return cost_of(2, a); };

  // Viscosity and limiter: the cells are still needed for the quadrature, their smoothness is not.
  for (const char* off :
       {"scheme/artificial viscosity/form=none", "scheme/artificial viscosity/limiter=0"})
    EXPECT_EQ(all.names() - without({off}).names() - permuting, Names{"limit cells"}) << off;

  EXPECT_EQ(all.names() - without({"scheme/quadrature=particle"}).names() - permuting,
            Names{"scale cells"});
  const Cost no_cells =
      without({"scheme/quadrature=particle", "scheme/artificial viscosity/limiter=0"});
  for (const char* kernel :
       {"scatter volume", "describe cells", "scale cells", "limit cells", "fill halo cells"}) {
    EXPECT_TRUE(all.launches(kernel));
    EXPECT_FALSE(no_cells.launches(kernel)) << kernel;
  }

  const Cost whole = without({"scheme/split length=0"});
  EXPECT_EQ(all.names() - whole.names() - permuting,
            (Names{"longest particle", "longest of rows"}));
  EXPECT_EQ(all.bytes() - whole.bytes(), 16);  // extents

  EXPECT_EQ(all.names() - without({"scheme/heat conduction=0"}).names() - permuting,
            (Names{"scatter two means"}));
  EXPECT_EQ(all.names() - without({"scheme/volume relaxation=0"}).names() - permuting,
            (Names{"fullness", "correct volume"}));
  EXPECT_EQ(
      all.names() - without({"scheme/pressure relaxation=0"}).names() - permuting,
      (Names{"load pressure", "propose exchange", "scatter two means", "gather two scalars"}));
  const Cost unrelaxed = without(
      {"scheme/heat conduction=0", "scheme/volume relaxation=0", "scheme/pressure relaxation=0"});
  EXPECT_EQ(unrelaxed.columns.count("compression"), 0u);
  EXPECT_FALSE(unrelaxed.launches("scatter mean"));
  EXPECT_FALSE(unrelaxed.launches("gather scalar"));

  // Linear shapes do not reach over walls, one class needs no common velocity.
  for (const char* kernel : {"fold halo", "fill halo", "mirror momentum", "image momentum",
                             "add class", "common velocity"})
    EXPECT_FALSE(all.launches(kernel)) << kernel;
  EXPECT_TRUE(cost_of(2, {"preset=accurate"}).launches("fold halo"));
  EXPECT_TRUE(cost_of(2, {"preset=accurate"}).launches("image momentum"));
  EXPECT_EQ(all.columns.count("affine"), 0u);
}

TEST(Cost, OfASolidInThePlaneIsThis) {
  List given = test::scene(2, {"bodies/first/pressure=2"});
  given.sublist("materials").sublist("gas") = test::elastic_material();
  const Cost cost = cost_of(complete_scene(given));
  EXPECT_EQ(cost.names() - permuting,
            (sorting + Names{"scatter momentum", "fold halo", "mirror momentum", "hold wall",
                             "nodal velocity", "fill halo", "image momentum", "gather gradient",
                             "signals", "fastest signals", "fastest strain", "half step of solid",
                             "scatter tensor force", "move grid", "finish tensor midpoint",
                             "finish solid"}));
  EXPECT_EQ(cost.columns, (Columns{{"position", 16},
                                   {"velocity", 16},
                                   {"mass", 8},
                                   {"volume", 8},
                                   {"stress", 32},
                                   {"half stress", 32},
                                   {"history", 8},
                                   {"affine", 32},
                                   {"id", 8},
                                   {"bin", 4}}));
  EXPECT_EQ(cost.bytes(), 164);
}

TEST(Cost, OfFreeEndsIsNoWall) {
  const Cost cost = cost_of(1, {"boundaries/x low=free", "boundaries/x high=free"});
  EXPECT_FALSE(cost.launches("hold wall"));
}

TEST(Cost, OfSplittingIsPaidWhenItHappens) {
  // Particles that are too long from the start: the first step cuts them.
  const auto simulation =
      make_simulation(test::scene(1, {"bodies/first/particles per cell=1"}), nullptr);
  const auto kernels = kernels_of([&] { simulation->advance(1); });
  for (const char* kernel : {"longest particle", "place parts", "copy parts", "lay out parts"})
    EXPECT_EQ(kernels.count(kernel), 1u) << kernel;
  EXPECT_EQ(simulation->particle_count(), 10 * 2 + 10 * 3);
}

}  // namespace
}  // namespace brisance
