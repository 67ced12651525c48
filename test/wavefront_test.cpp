#include "core/wavefront.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "core/sort.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using G = PlaneStrain;

enum class Density { even, crowded, sparse };

struct Case {
  Side side;
  const char* shape;
  int chunks;
  Density density;
};

/// Into a tenth of the domain along d.
void squeeze(const Particles<G>& p, int q, int d, const Lattice<2>& lattice) {
  const double low = lattice.origin[d];
  p.position(q, d) = low + 0.1 * (p.position(q, d) - low);
}

/// Particles that move at random, sorted in two ways.
class Pair {
 public:
  explicit Pair(const Case& of) : wave(of.chunks), a(make(of)), b(make(of)), random_(7) {}

  void move() {
    const Lattice<2>& lattice = a.grid.lattice;
    const Ends<2> ends(lattice, a.grid.boundaries);
    std::uniform_real_distribution<double> within(-0.99 * lattice.h, 0.99 * lattice.h);
    std::vector<std::array<double, 2>> by(a.next_id);
    for (auto& one : by) one = {within(random_), within(random_)};
    for (State<G>* state : {&a, &b}) {
      Particles<G>& p = state->groups[0]->particles;
      for (int q = 0; q < p.count; ++q)
        for (int d = 0; d < 2; ++d)
          p.position(q, d) = ends.settle(d, p.position(q, d) + by[p.id(q)][d]);
    }
  }

  /// Particles of b within a sweep, whose other stage counts how often it sees each.
  bool sort_b() {
    Group<G>& g = *b.groups[0];
    g.in_motion = true;
    if (!wave.takes(b.groups, b.grid.lattice, b.grid.boundaries, 0.99 * b.grid.lattice.h))
      return false;
    const Particles<G> points = g.particles;
    Sweep<2> sweep(b.grid.lattice);
    sweep.add("count", [points](const Row<2>& row) {
      for (int q = points.first(row.begin); q < points.first(row.end); ++q)
        points.velocity(q, 0) += 1;
    });
    g.transfer->find_bins(sweep, points);
    wave.run(sweep);
    if (wave.any_left(g)) b.sorter.sort(g.particles, *g.transfer, b.grid.lattice);
    return wave.sorted(g);
  }
  int sort_a() {
    Group<G>& g = *a.groups[0];
    for (int q = 0; q < g.particles.count; ++q) g.particles.velocity(q, 0) += 1;
    return a.sorter.sort(g.particles, *g.transfer, a.grid.lattice);
  }

  void expect_same() const {
    const Particles<G>&p = a.groups[0]->particles, &q = b.groups[0]->particles;
    ASSERT_EQ(p.count, q.count);
    for (int k = 0; k <= a.grid.lattice.size + 1; ++k) ASSERT_EQ(p.first(k), q.first(k)) << k;
    for (int k = 0; k < p.count; ++k) {
      ASSERT_EQ(p.id(k), q.id(k)) << k;
      ASSERT_EQ(p.position(k, 1), q.position(k, 1));
      ASSERT_EQ(p.velocity(k, 0), q.velocity(k, 0));
      ASSERT_EQ(p.history(k, 0), q.history(k, 0));
    }
    const RowLayout<2> layout(a.grid.lattice);
    for (int r = 0; r < layout.rows; ++r) {
      const Row<2> row = layout.row(r);
      if (p.first(row.begin) == p.first(row.end)) continue;
      for (int t = 0; t < Row<2>::tiles; ++t)
        ASSERT_EQ(p.order(r * Row<2>::tiles + t).digits, q.order(r * Row<2>::tiles + t).digits);
    }
  }

  Wavefront<G> wave;
  State<G> a, b;

 private:
  std::mt19937 random_;

  State<G> make(const Case& of) const {
    test::RandomGas gas;
    gas.side = of.side;
    gas.transfer.shape = of.shape;
    gas.cells = 70;
    const bool sparse = of.density == Density::sparse, crowded = of.density == Density::crowded;
    gas.per_cell = sparse ? 1 : 2;
    State<G> state = test::random_gas<G>(gas);
    Group<G>& g = *state.groups[0];
    const Lattice<2>& lattice = state.grid.lattice;
    if (sparse) g.particles.count = 60;  // one a line
    for (int q = 0; q < g.particles.count; ++q) {
      if (sparse) g.particles.position(q, 1) = lattice.origin[1] + (q + 5.5) * lattice.h;
      if (crowded && q % 8 != 0) squeeze(g.particles, q, 0, lattice);
    }
    state.sorter.sort(g.particles, *g.transfer, state.grid.lattice);
    return state;
  }
};

class Waves : public testing::TestWithParam<Case> {};

// Up and down in turn, with margins that change as lines fill.
TEST_P(Waves, SortAsTheSorterDoes) {
  Pair pair(GetParam());
  int left = 0;
  for (int step = 0; step < 6; ++step) {
    pair.move();
    ASSERT_TRUE(pair.sort_b());
    const int now = pair.sort_a();
    left += now;
    pair.expect_same();
    if (HasFatalFailure()) return;
    EXPECT_EQ(pair.wave.any_left(*pair.b.groups[0]), now > 0);
    if (now == 0) {  // what decides the way of the next sort
      EXPECT_EQ(pair.wave.most_moved(*pair.b.groups[0]), pair.a.sorter.most_moved());
    }
  }
  EXPECT_EQ(left > 0, GetParam().side == Side::free);
}

INSTANTIATE_TEST_SUITE_P(OfChunks, Waves,
                         testing::Values(Case{Side::wall, "linear", 1, Density::even},
                                         Case{Side::wall, "linear", 3, Density::even},
                                         Case{Side::wall, "linear", 4, Density::crowded},
                                         Case{Side::wall, "linear", 2, Density::sparse},
                                         Case{Side::free, "linear", 1, Density::even},
                                         Case{Side::free, "cubic", 4, Density::even},
                                         Case{Side::periodic, "linear", 1, Density::even},
                                         Case{Side::periodic, "linear", 2, Density::crowded},
                                         Case{Side::periodic, "quadratic", 1, Density::even},
                                         Case{Side::periodic, "quadratic", 4, Density::even},
                                         Case{Side::periodic, "cubic", 3, Density::even}));

TEST(Waves, TakeOnlyWhatMovesLessThanACellAndHasManyLines) {
  Pair pair({Side::wall, "linear", 1, Density::even});
  State<G>& s = pair.b;
  const double h = s.grid.lattice.h;
  const auto takes = [&](double farthest) {
    return pair.wave.takes(s.groups, s.grid.lattice, s.grid.boundaries, farthest);
  };
  s.groups[0]->in_motion = false;
  EXPECT_FALSE(takes(0.5 * h));
  s.groups[0]->in_motion = true;
  EXPECT_TRUE(takes(0.5 * h));
  EXPECT_TRUE(pair.wave.sorted(*s.groups[0]));
  EXPECT_FALSE(takes(h));
  EXPECT_FALSE(takes(std::nan("")));
  EXPECT_FALSE(pair.wave.sorted(*s.groups[0]));
  Particles<G>& p = s.groups[0]->particles;
  for (int q = 0; q < p.count; ++q) squeeze(p, q, 1, s.grid.lattice);  // into seven lines
  s.sorter.sort(p, *s.groups[0]->transfer, s.grid.lattice);
  EXPECT_FALSE(takes(0.5 * h));
}

}  // namespace
}  // namespace brisance
