#pragma once
// Binds the row functions to the Transfer interface; included by the files that instantiate one
// geometry.
#include <stdexcept>

#include "core/transfer.hpp"
#include "core/transfer_midpoint.hpp"

namespace brisance {

template <class G, class M>
class TransferBy final : public Transfer<G> {
 public:
  static constexpr int D = G::dim;
  using S = typename M::Shape;
  using R = Rows<G, M>;

  bool sized() const override { return S::sized; }
  bool affine() const override { return M::affine; }
  bool cell_quadrature() const override { return M::cells; }
  double affine_inertia(double h) const override { return S::affine_inertia * h * h; }

  void find_bins(const Particles<G>& points, const Lattice<D>& lattice,
                 const Array<int>& bins) const override {
    Kokkos::parallel_for(
        "find bins", Kokkos::RangePolicy<Space>(0, points.count), KOKKOS_LAMBDA(const int p) {
          int base[D];
          bool inside = true;
          for (int d = 0; d < D; ++d) {
            const double at = lattice.in_cells(points.position(p, d), d);
            inside = inside && at >= 0 && at < lattice.cells[d];
            base[d] = inside ? S::base(at) : 0;
          }
          bins(p) = inside ? lattice.index(base) : lattice.size;
        });
  }

  void scatter_momentum(const Particles<G>& points, const Lattice<D>& lattice,
                        const Accumulator& sums) const override {
    const R rows{points, lattice};
    const auto scatter = sums.scatter;
    for_rows(
        "scatter momentum", lattice,
        KOKKOS_LAMBDA(const Row<D>& row) { rows.momentum(row, scatter.access()); });
  }

  void scatter_force(const Particles<G>& points, const Grid<G>& grid, Stress stress,
                     const Accumulator& sums) const override {
    const R rows{points, grid.lattice};
    const auto scatter = sums.scatter;
    const auto scale = grid.scale;
    if (stress == Stress::pressure)
      for_rows(
          "scatter force", grid.lattice, KOKKOS_LAMBDA(const Row<D>& row) {
            rows.template force<Stress::pressure>(row, scale, scatter.access());
          });
    else
      for_rows(
          "scatter tensor force", grid.lattice, KOKKOS_LAMBDA(const Row<D>& row) {
            rows.template force<Stress::tensor>(row, scale, scatter.access());
          });
  }

  void gather_gradient(const Particles<G>& points, const Lattice<D>& lattice,
                       const Table<double>& velocity) const override {
    const R rows{points, lattice};
    for_rows(
        "gather gradient", lattice,
        KOKKOS_LAMBDA(const Row<D>& row) { rows.gradients(row, velocity); });
  }

  void scatter_cells(const Particles<G>& points, const Lattice<D>& lattice,
                     const Accumulator& sums) const override {
    const R rows{points, lattice};
    const auto scatter = sums.scatter;
    for_rows(
        "scatter cells", lattice,
        KOKKOS_LAMBDA(const Row<D>& row) { rows.cells(row, scatter.access()); });
  }

  void scatter_overlap(const Particles<G>& points, const Lattice<D>& lattice, int column,
                       const Accumulator& sums) const override {
    const R rows{points, lattice};
    const auto scatter = sums.scatter;
    for_rows(
        "scatter overlap", lattice,
        KOKKOS_LAMBDA(const Row<D>& row) { rows.overlap(row, column, scatter.access()); });
  }

  void accelerate(const Particles<G>& points, const Grid<G>& grid, int velocity_class,
                  double flip) const override {
    const R rows{points, grid.lattice};
    const auto before = grid.before, after = grid.after, own = grid.own[velocity_class];
    for_rows(
        "accelerate", grid.lattice,
        KOKKOS_LAMBDA(const Row<D>& row) { rows.accelerate(row, before, after, own, flip); });
  }

  void gradient_and_move(const Particles<G>& points, const Grid<G>& grid,
                         const Table<double>& velocity, double dt) const override {
    const R rows{points, grid.lattice};
    const auto after = grid.after;
    const auto boundaries = grid.boundaries;
    for_rows(
        "gradient and move", grid.lattice, KOKKOS_LAMBDA(const Row<D>& row) {
          rows.gradient_and_move(row, velocity, after, boundaries, dt);
        });
  }

  void finish_midpoint(const Particles<G>& points, const Grid<G>& grid, Stress stress,
                       int velocity_class, double flip, double dt) const override {
    if (stress == Stress::pressure)
      for_rows("finish midpoint", grid.lattice,
               midpoint<Stress::pressure>(points, grid, velocity_class, flip, dt));
    else
      for_rows("finish tensor midpoint", grid.lattice,
               midpoint<Stress::tensor>(points, grid, velocity_class, flip, dt));
  }

  void scatter_mean(const Particles<G>& points, const Lattice<D>& lattice, Entry value,
                    Entry weight, const Accumulator& sums) const override {
    const R rows{points, lattice};
    const auto scatter = sums.scatter;
    for_rows(
        "scatter mean", lattice, KOKKOS_LAMBDA(const Row<D>& row) {
          rows.mean(row, value.table, value.column, weight.table, weight.column, scatter.access());
        });
  }

  void scatter_means(const Particles<G>& points, const Lattice<D>& lattice,
                     const Table<double>& values, const Accumulator& sums) const override {
    const R rows{points, lattice};
    const auto scatter = sums.scatter;
    for_rows(
        "scatter means", lattice,
        KOKKOS_LAMBDA(const Row<D>& row) { rows.means(row, values, scatter.access()); });
  }

  void subtract_means(const Particles<G>& points, const Lattice<D>& lattice,
                      const Table<double>& field, const Table<double>& values) const override {
    const R rows{points, lattice};
    for_rows(
        "subtract means", lattice,
        KOKKOS_LAMBDA(const Row<D>& row) { rows.subtract_means(row, field, values); });
  }

  void gather_scalar(const Particles<G>& points, const Lattice<D>& lattice,
                     const Table<double>& field, int column, Entry value, double keep,
                     double factor) const override {
    const R rows{points, lattice};
    for_rows(
        "gather scalar", lattice, KOKKOS_LAMBDA(const Row<D>& row) {
          rows.gather(row, field, column, value.table, value.column, keep, factor);
        });
  }

 private:
  template <Stress kind>
  static Midpoint<G, M, kind> midpoint(const Particles<G>& points, const Grid<G>& grid,
                                       int velocity_class, double flip, double dt) {
    return {R{points, grid.lattice}, grid.before, grid.after, grid.own[velocity_class], grid.scale,
            grid.boundaries,         flip,        dt};
  }
};

template <class G>
std::unique_ptr<Transfer<G>> make_transfer(const TransferChoice& c) {
  const auto is = [&](const char* shape, const char* scheme, const char* quadrature) {
    return c.shape == shape && c.scheme == scheme && c.quadrature == quadrature;
  };
  if (is("linear", "FLIP", "cell"))
    return std::make_unique<TransferBy<G, Method<Linear, false, false, true>>>();
  if (is("linear", "FLIP", "particle")) return std::make_unique<TransferBy<G, Method<Linear>>>();
  if (is("GIMP", "FLIP", "particle")) return std::make_unique<TransferBy<G, Method<Gimp>>>();
  if (is("quadratic", "FLIP", "particle"))
    return std::make_unique<TransferBy<G, Method<QuadraticSpline>>>();
  if (is("cubic", "FLIP", "particle"))
    return std::make_unique<TransferBy<G, Method<CubicSpline>>>();
  if (is("quadratic", "APIC", "particle"))
    return std::make_unique<TransferBy<G, Method<QuadraticSpline, true>>>();
  if (is("cubic", "APIC", "particle"))
    return std::make_unique<TransferBy<G, Method<CubicSpline, true>>>();
  if (is("quadratic", "MLS", "particle"))
    return std::make_unique<TransferBy<G, Method<QuadraticSpline, true, true>>>();
  if (is("cubic", "MLS", "particle"))
    return std::make_unique<TransferBy<G, Method<CubicSpline, true, true>>>();
  throw std::invalid_argument("no transfer of shape " + c.shape + ", scheme " + c.scheme +
                              ", quadrature " + c.quadrature);
}

}  // namespace brisance
