// Particles as they are copied for outputs, and two works of an output at once.
#include "drivers/snapshot.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <stdexcept>

#include "drivers/at_once.hpp"
#include "drivers/simulation.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

/// Every column of numbers in a plane.
std::vector<const std::vector<double>*> columns_of(const ParticleTable& t) {
  std::vector<const std::vector<double>*> all = {
      &t.x, &t.y, &t.vx, &t.vy, &t.mass, &t.volume, &t.density, &t.pressure, &t.energy};
  for (const auto& field : t.fields) all.push_back(&field.values);
  return all;
}

// Fluids have none of the fields of solids, and must not show what lay there before.
TEST(Snapshot, InTheMemoryOfAnEarlierOneIsTheSame) {
  const auto simulation = make_simulation(test::shortened("bomb_cased", 24, 0), nullptr);
  for (const std::size_t count : {std::size_t{10}, std::size_t{1000000}}) {
    Snapshot earlier = simulation->snapshot();
    for (const auto* column : columns_of(earlier.table))
      const_cast<std::vector<double>*>(column)->assign(count, 7e77);
    earlier.table.material.assign(count, 9);
    earlier.id.assign(count, -1);
    simulation->advance(1);
    const Snapshot again = simulation->snapshot(std::move(earlier)), fresh = simulation->snapshot();
    EXPECT_EQ(again.time, fresh.time);
    EXPECT_EQ(again.id, fresh.id);
    EXPECT_EQ(again.table.material, fresh.table.material);
    const auto a = columns_of(again.table), b = columns_of(fresh.table);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(*a[k], *b[k]) << "column " << k;
  }
}

TEST(Snapshot, OfTwoWorksAtOnceBothAreDone) {
  int first = 0, second = 0;
  at_once([&] { first = 1; }, [&] { second = 2; });
  EXPECT_EQ(first, 1);
  EXPECT_EQ(second, 2);
}

TEST(Snapshot, OfTwoWorksThatFailTheFirstIsTold) {
  int second = 0;
  EXPECT_THROW(at_once([] { throw std::runtime_error("full"); }, [&] { second = 2; }),
               std::runtime_error);
  EXPECT_EQ(second, 2);
  const auto both = [] {
    at_once([] { throw std::runtime_error("full"); }, [] { throw std::logic_error("other"); });
  };
  EXPECT_THROW(both(), std::runtime_error);
}

}  // namespace
}  // namespace brisance
