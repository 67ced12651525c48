#pragma once
// Binds the row functions to the Transfer interface; included by the files that instantiate one
// geometry.
#include <stdexcept>

#include "core/transfer.hpp"
#include "core/transfer_midpoint.hpp"
#include "core/transfer_scatter.hpp"

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
  double beside() const override { return S::beside; }
  double affine_inertia(double h) const override { return S::affine_inertia * h * h; }

  void find_bins(Sweep<D>& in, const Particles<G>& points) const override {
    const R rows{points, in.lattice()};
    in.add(
        "find bins", KOKKOS_LAMBDA(const Row<D>& row) { rows.find_bins(row); });
  }
  void find_bins(const Lattice<D>& lattice, const Particles<G>& points) const override {
    const R rows{points, lattice};
    Kokkos::parallel_for(
        "find all bins", Kokkos::RangePolicy<Space>(0, points.count),
        KOKKOS_LAMBDA(const int p) { points.set_bin(p, rows.bin_of(p)); });
  }

  void scatter_momentum(Sweep<D>& in, const Particles<G>& points,
                        const Accumulator& sums) const override {
    in.add("scatter momentum", sums, ScatterMomentum<R>{{points, in.lattice()}});
  }

  void scatter_force(Sweep<D>& in, const Particles<G>& points, const Grid<G>& grid, Stress stress,
                     const Accumulator& sums) const override {
    const R rows{points, in.lattice()};
    if (stress == Stress::pressure)
      in.add("scatter force", sums, ScatterForce<R, Stress::pressure>{rows, grid.scale});
    else
      in.add("scatter tensor force", sums, ScatterForce<R, Stress::tensor>{rows, grid.scale});
  }

  void gather_gradient(Sweep<D>& in, const Particles<G>& points,
                       const Table<double>& velocity) const override {
    const R rows{points, in.lattice()};
    in.add(
        "gather gradient", KOKKOS_LAMBDA(const Row<D>& row) { rows.gradients(row, velocity); });
  }

  void scatter_volume(Sweep<D>& in, const Particles<G>& points, int column,
                      const Accumulator& sums) const override {
    in.add("scatter volume", sums, ScatterVolume<R>{{points, in.lattice()}, column});
  }

  void scatter_overlap(Sweep<D>& in, const Particles<G>& points, int column,
                       const Accumulator& sums) const override {
    in.add("scatter overlap", sums, ScatterOverlap<R>{{points, in.lattice()}, column});
  }

  void accelerate(Sweep<D>& in, const Particles<G>& points, const Grid<G>& grid, int velocity_class,
                  double flip) const override {
    const R rows{points, in.lattice()};
    const auto before = grid.before, after = grid.after, own = grid.own[velocity_class];
    in.add(
        "accelerate",
        KOKKOS_LAMBDA(const Row<D>& row) { rows.accelerate(row, before, after, own, flip); });
  }

  void gradient_and_move(Sweep<D>& in, const Particles<G>& points, const Grid<G>& grid,
                         const Table<double>& velocity, double dt) const override {
    const R rows{points, in.lattice()};
    const auto after = grid.after;
    const Ends<D> ends(grid.lattice, grid.boundaries);
    in.add(
        "gradient and move", KOKKOS_LAMBDA(const Row<D>& row) {
          rows.gradient_and_move(row, velocity, after, ends, dt);
        });
  }

  void finish_midpoint(Sweep<D>& in, const Particles<G>& points, const Grid<G>& grid, Stress stress,
                       int velocity_class, double flip, double dt) const override {
    if (stress == Stress::pressure)
      in.add("finish midpoint", midpoint<Stress::pressure>(points, grid, velocity_class, flip, dt));
    else
      in.add("finish tensor midpoint",
             midpoint<Stress::tensor>(points, grid, velocity_class, flip, dt));
  }

  void scatter_mean(Sweep<D>& in, const Particles<G>& points, const Weighted& one, int column,
                    const Accumulator& sums) const override {
    in.add("scatter mean", sums,
           ScatterMeans<Means<G, M>, 1>{{{points, in.lattice()}}, {{one}}, column});
  }
  void scatter_two_means(Sweep<D>& in, const Particles<G>& points, const Weighted& one,
                         const Weighted& other, const Accumulator& sums) const override {
    in.add("scatter two means", sums,
           ScatterMeans<Means<G, M>, 2>{{{points, in.lattice()}}, {{one, other}}, 0});
  }

  void scatter_means(Sweep<D>& in, const Particles<G>& points, const Table<double>& values,
                     const Accumulator& sums) const override {
    in.add("scatter means", sums,
           ScatterAllMeans<Means<G, M>, 3>{{{points, in.lattice()}}, values});
  }

  void gather_scalar(Sweep<D>& in, const Particles<G>& points,
                     const Gathering& one) const override {
    gather<1>(in, "gather scalar", points, {{one}});
  }
  void gather_two_scalars(Sweep<D>& in, const Particles<G>& points, const Gathering& one,
                          const Gathering& other) const override {
    gather<2>(in, "gather two scalars", points, {{one, other}});
  }
  void subtract_means(Sweep<D>& in, const Particles<G>& points, const Table<double>& field,
                      const Table<double>& values) const override {
    const auto each = [&](int k) { return Gathering{{field, k}, {values, k}, 1, -1}; };
    gather<3>(in, "subtract means", points, {{each(0), each(1), each(2)}});
  }

 private:
  template <int C>
  static void gather(Sweep<D>& in, const char* name, const Particles<G>& points,
                     const Kokkos::Array<Gathering, C>& what) {
    const Means<G, M> means{{points, in.lattice()}};
    in.add(
        name, KOKKOS_LAMBDA(const Row<D>& row) { means.template gather<C>(row, what); });
  }

  template <Stress kind>
  static Midpoint<G, M, kind> midpoint(const Particles<G>& points, const Grid<G>& grid,
                                       int velocity_class, double flip, double dt) {
    return {R{points, grid.lattice},
            grid.before,
            grid.after,
            grid.own[velocity_class],
            grid.scale,
            Ends<D>(grid.lattice, grid.boundaries),
            flip,
            dt};
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
