// Every transfer in every geometry, on gas without anything special about it. Tolerances: sums of a
// few hundred terms of order 1 are good to 1e-13.
#include "core/transfer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/cells.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

using test::every_transfer;
using test::random_gas;
using test::RandomGas;

template <class G>
class EveryTransfer : public testing::Test {
 public:
  static constexpr int D = G::dim;

  /// Calls f(state, group, transfer) for each choice; with cell quadrature, the cells are known.
  template <class F>
  static void for_each(RandomGas of, const F& f) {
    for (const auto& choice : every_transfer()) {
      SCOPED_TRACE(test::name_of(choice));
      of.transfer = choice;
      State<G> state = random_gas<G>(of);
      Group<G>& group = *state.groups[0];
      know_cells(state, group);
      f(state, group, *group.transfer);
    }
  }

  static void know_cells(State<G>& state, const Group<G>& group) {
    if (!group.transfer->cell_quadrature()) return;
    state.sums.clear();
    test::sweep(state.grid.lattice, [&](auto& in) {
      group.transfer->scatter_volume(in, group.particles, D, state.sums);
    });
    state.sums.contribute();
    describe_cells(state.grid, state.sums, group.transfer->beside());
    scale_cells(state.grid);
  }

  static double sum(const State<G>& state, int column) {
    double s = 0;
    for (int n = 0; n < state.grid.lattice.size; ++n) s += state.sums.total(n, column);
    return s;
  }
  static double size(const State<G>& state, int column) {
    double s = 0;
    for (int n = 0; n < state.grid.lattice.size; ++n) s += std::fabs(state.sums.total(n, column));
    return s;
  }

  static Vec<D> place(const Lattice<D>& lattice, int node) {
    int i[D];
    lattice.coordinates(node, i);
    Vec<D> x;
    for (int d = 0; d < D; ++d) x[d] = lattice.origin[d] + i[d] * lattice.h;
    return x;
  }
};
using Geometries = testing::Types<Line, PlaneStrain>;
TYPED_TEST_SUITE(EveryTransfer, Geometries);

TYPED_TEST(EveryTransfer, CarriesMassAndMomentumOfTheParticlesToTheNodes) {
  for (const Side side : {Side::free, Side::wall, Side::periodic}) {
    RandomGas of;
    of.side = side;
    this->for_each(of, [](auto& state, auto& group, auto& transfer) {
      state.sums.clear();
      test::sweep(state.grid.lattice,
                  [&](auto& in) { transfer.scatter_momentum(in, group.particles, state.sums); });
      state.sums.contribute();
      const Totals t = test::totals(state);
      EXPECT_NEAR(TestFixture::sum(state, TypeParam::dim) / t.mass, 1, 1e-13);
      for (int d = 0; d < TypeParam::dim; ++d)
        EXPECT_NEAR(TestFixture::sum(state, d), t.momentum[d], 1e-13 * TestFixture::size(state, d));
    });
  }
}

TYPED_TEST(EveryTransfer, ForcesSumToZero) {
  for (const bool newtonian : {false, true}) {
    RandomGas of;
    of.newtonian = newtonian;
    this->for_each(of, [](auto& state, auto& group, auto& transfer) {
      state.sums.clear();
      test::sweep(state.grid.lattice, [&](auto& in) {
        group.half_step(in, state.grid, 1e-3);
        transfer.scatter_force(in, group.particles, state.grid, group.stress(), state.sums);
      });
      state.sums.contribute();
      for (int d = 0; d < TypeParam::dim; ++d) {
        EXPECT_GT(TestFixture::size(state, d), 0.01);
        EXPECT_NEAR(TestFixture::sum(state, d), 0, 1e-13 * TestFixture::size(state, d));
      }
    });
  }
}

TYPED_TEST(EveryTransfer, FindsTheGradientOfALinearVelocity) {
  RandomGas of;
  of.side = Side::free;
  of.passing_lasts = true;
  Mat<TypeParam::dim> truth;
  for (int k = 0; k < TypeParam::dim * TypeParam::dim; ++k) truth.a[k] = 1 - 0.7 * k;
  this->for_each(of, [&](auto& state, auto& group, auto& transfer) {
    const auto& lattice = state.grid.lattice;
    const Table<double> velocity("velocity", lattice.size, TypeParam::dim);
    for (int n = 0; n < lattice.size; ++n)
      for (int i = 0; i < TypeParam::dim; ++i)
        for (int j = 0; j < TypeParam::dim; ++j)
          velocity(n, i) += truth(i, j) * TestFixture::place(lattice, n)[j];
    test::sweep(lattice,
                [&](auto& in) { transfer.gather_gradient(in, group.particles, velocity); });
    for (int p = 0; p < group.particles.count; ++p)
      for (int k = 0; k < TypeParam::dim * TypeParam::dim; ++k)
        ASSERT_NEAR(group.particles.gradient(p, k), truth.a[k], 1e-13 * 10);
  });
}

// sum f . v over the nodes is -sum V sigma : L(v) over the particles: what the midpoint rule lives
// by.
TYPED_TEST(EveryTransfer, ForceAndGradientAreAdjoint) {
  RandomGas of;
  of.newtonian = true;
  of.passing_lasts = true;
  of.side = Side::wall;
  this->for_each(of, [](auto& state, auto& group, auto& transfer) {
    const auto& lattice = state.grid.lattice;
    const auto& p = group.particles;
    state.sums.clear();
    test::sweep(lattice, [&](auto& in) {
      group.half_step(in, state.grid, 1e-3);
      transfer.scatter_force(in, p, state.grid, group.stress(), state.sums);
    });
    state.sums.contribute();
    const Table<double> velocity("velocity", lattice.size, TypeParam::dim);
    double of_nodes = 0, of_particles = 0, size = 0;
    for (int n = 0; n < lattice.size; ++n)
      for (int i = 0; i < TypeParam::dim; ++i) {
        velocity(n, i) = std::sin(1 + 3 * n + 17 * i);
        of_nodes += state.sums.total(n, i) * velocity(n, i);
        size += std::fabs(state.sums.total(n, i) * velocity(n, i));
      }
    test::sweep(lattice, [&](auto& in) { transfer.gather_gradient(in, p, velocity); });
    for (int q = 0; q < p.count; ++q) {
      const double fill =
          transfer.cell_quadrature() ? state.grid.scale(lattice.cell_of(p.x(q)), 0) : 1;
      of_particles -= fill * p.vol(q) *
                      contract(p.template sigma<Stress::tensor>(q),
                               strain_rate<TypeParam>(p.matrix(p.gradient, q)));
    }
    EXPECT_NEAR(of_nodes, of_particles, 1e-13 * size);
  });
}

// However unevenly the particles lie and whatever their volumes: in full cells the volumes are
// scaled to fill them. Each nodal force is a sum of 2^D terms p h^(D-1) / 2^(D-1) that cancel.
TYPED_TEST(EveryTransfer, ByCellsMakesNoForceOutOfUniformPressure) {
  for (const Side side : {Side::periodic, Side::wall})
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
      RandomGas of;
      of.transfer = {"linear", "FLIP", "cell"};
      of.side = side;
      of.pressure_range = 0;
      of.per_cell = 3;
      of.seed = seed;
      State<TypeParam> state = random_gas<TypeParam>(of);
      Group<TypeParam>& group = *state.groups[0];
      this->know_cells(state, group);
      state.sums.clear();
      test::sweep(state.grid.lattice, [&](auto& in) {
        group.transfer->scatter_force(in, group.particles, state.grid, group.stress(), state.sums);
      });
      state.sums.contribute();
      const auto& lattice = state.grid.lattice;
      fold(state.sums.total, TypeParam::dim, TypeParam::dim, lattice, state.grid.boundaries);
      constrain(state.sums.total, lattice, state.grid.boundaries);
      for (int n = 0; n < lattice.size; ++n)
        for (int d = 0; d < TypeParam::dim; ++d)
          EXPECT_NEAR(state.sums.total(n, d), 0, 2e-15 * power(2, TypeParam::dim)) << "node " << n;
    }
}

TYPED_TEST(EveryTransfer, OfOneVelocityForAllChangesNothing) {
  RandomGas of;
  of.damping = 0.5;
  of.pressure_range = 0;
  of.passing_lasts = true;
  this->for_each(of, [](auto& state, auto& group, auto& transfer) {
    const auto& p = group.particles;
    for (int n = 0; n < state.grid.lattice.size; ++n)
      for (int d = 0; d < TypeParam::dim; ++d)
        state.grid.before(n, d) = state.grid.after(n, d) = 3 - d;
    for (int q = 0; q < p.count; ++q) {
      for (int d = 0; d < TypeParam::dim; ++d) p.velocity(q, d) = 3 - d;
      for (std::size_t c = 0; c < p.affine.extent(1); ++c) p.affine(q, c) = 0;
    }
    const Vec<TypeParam::dim> x = p.x(5);
    test::sweep(state.grid.lattice, [&](auto& in) {
      transfer.finish_midpoint(in, p, state.grid, group.stress(), 0, 0.9, 0.01);
    });
    for (int q = 0; q < p.count; ++q) {
      for (int d = 0; d < TypeParam::dim; ++d) ASSERT_NEAR(p.velocity(q, d), 3 - d, 1e-14);
      ASSERT_NEAR(p.work(q, 0), 0, 1e-14);
    }
    for (int d = 0; d < TypeParam::dim; ++d)
      EXPECT_NEAR(p.position(5, d), x[d] + 0.01 * (3 - d), 1e-14);
  });
}

TYPED_TEST(EveryTransfer, KnowsTheMeanOfAConstant) {
  this->for_each({}, [](auto& state, auto& group, auto& transfer) {
    const auto& p = group.particles;
    const auto& lattice = state.grid.lattice;
    for (int q = 0; q < p.count; ++q) p.scratch(q, 0) = 7;
    state.sums.clear();
    test::sweep(lattice, [&](auto& in) {
      transfer.scatter_mean(in, p, {{p.scratch, 0}, {p.mass}}, 0, state.sums);
    });
    state.sums.contribute();
    const Table<double> mean("mean", lattice.size, 1);
    for (int n = 0; n < lattice.size; ++n)
      mean(n, 0) = state.sums.total(n, 1) > 0 ? state.sums.total(n, 0) / state.sums.total(n, 1) : 0;
    test::sweep(lattice, [&](auto& in) {
      transfer.gather_scalar(in, p, {{mean}, {p.scratch, 1}, 0, 2});
      transfer.gather_scalar(in, p, {{mean}, {p.scratch, 0}, 1, -1});
    });
    for (int q = 0; q < p.count; ++q) {
      ASSERT_NEAR(p.scratch(q, 1), 14, 1e-13);
      ASSERT_NEAR(p.scratch(q, 0), 0, 1e-13);
    }
  });
}

TEST(TransferChoices, ThatLoseMomentumOrEnergyAreRefused) {
  EXPECT_EQ(broken_rule({"quadratic", "MLS", "particle"}), "");
  EXPECT_EQ(broken_rule({"linear", "FLIP", "cell"}), "");
  EXPECT_NE(broken_rule({"linear", "APIC", "particle"}), "");
  EXPECT_NE(broken_rule({"GIMP", "MLS", "particle"}), "");
  EXPECT_NE(broken_rule({"quadratic", "FLIP", "cell"}), "");
  EXPECT_THROW(make_transfer<Line>({"linear", "APIC", "particle"}), std::invalid_argument);
}

TEST(TransferChoices, ThatAreAllowedExist) {
  int allowed = 0;
  for (const char* shape : {"linear", "GIMP", "quadratic", "cubic"})
    for (const char* scheme : {"FLIP", "APIC", "MLS"})
      for (const char* quadrature : {"particle", "cell"}) {
        const TransferChoice choice{shape, scheme, quadrature};
        if (!broken_rule(choice).empty()) continue;
        EXPECT_NO_THROW(make_transfer<Line>(choice)) << test::name_of(choice);
        EXPECT_NO_THROW(make_transfer<PlaneStrain>(choice)) << test::name_of(choice);
        ++allowed;
      }
  EXPECT_EQ(allowed, static_cast<int>(every_transfer().size()));
}

}  // namespace
}  // namespace brisance
