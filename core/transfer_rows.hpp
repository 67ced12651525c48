#pragma once
// The transfers as functions of a row of bins, eight bins at a time; a bin is summed before it is
// scattered. Equation numbers are those of Appendix A of Hu & Chen (2006).
#include "core/geometry.hpp"
#include "core/grid.hpp"
#include "core/particles.hpp"
#include "core/schedule.hpp"
#include "core/shape.hpp"
#include "core/stencil.hpp"
#include "core/tile_sums.hpp"

namespace brisance {

/// A transfer as a type: shape function, APIC's affine field, MLS gradients, quadrature over cells.
template <class Shape_, bool affine_ = false, bool mls_ = false, bool cells_ = false>
struct Method {
  using Shape = Shape_;
  static constexpr bool affine = affine_, mls = mls_, cells = cells_;
};

template <class G, class M>
struct Rows {
  static constexpr int D = G::dim;
  using S = typename M::Shape;
  using At = Stencil<G, S>;
  static constexpr int nodes = At::N::count;
  template <int C>
  using Field = Nodes<G, S, C>;
  template <int C>
  using Smooth = Interpolant<G, S, C>;
  template <int C, class To>
  using Sums = TileSums<D, S::width, C, To>;
  using Base = Wide[D];

  /// The velocities of the nodes of a tile.
  struct Velocities {
    Field<D> nodes;
    Smooth<D> smooth;
    KOKKOS_FORCEINLINE_FUNCTION explicit Velocities(const Field<D>& v) : nodes(v), smooth(v) {}
  };

  Particles<G> points;
  Lattice<D> lattice;

  /// Calls f(tile, integer coordinates of its bins) for the tiles of a row that hold particles.
  template <class F>
  KOKKOS_FORCEINLINE_FUNCTION void for_tiles(const Row<D>& row, const F& f) const {
    points.for_tiles(row, S::width, [&](const Tile& tile) {
      Base base;
      base[0] = tile.digits() + Wide(row.base[0] + (tile.bin - row.begin));
      for (int d = 1; d < D; ++d) base[d] = row.base[d];
      f(tile, base);
    });
  }

  /// The bin of a particle, or of each of a bundle; lattice.size outside the domain.
  template <class I>
  KOKKOS_FORCEINLINE_FUNCTION auto bin_of(const I& p) const {
    using T = decltype(points.get(points.position, p));
    T bin = 0, out = 0;
    for (int d = 0; d < D; ++d) {
      const T at = (points.get(points.position, p, d) - lattice.origin[d]) * lattice.per_h;
      out = select(at < T(0) || !(at < T(lattice.cells[d])), T(1), out);
      bin += (S::base(select(out > T(0), T(0), at)) + lattice.halo) * lattice.stride[d];
    }
    return select(out > T(0), T(lattice.size), bin);
  }

  KOKKOS_INLINE_FUNCTION void find_bins(const Row<D>& row) const {
    points.for_all(row, [&](const auto& p) BRISANCE_INLINE { points.set_bin(p, bin_of(p)); });
  }

  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION At stencil(const Base& base, const Bundle& b) const {
    return At(lattice, base, points, b);
  }

  /// Component d of the gradient used for forces and strain rates: of the weights, or by moving
  /// least squares (N r / inertia). [1/cell]
  KOKKOS_FORCEINLINE_FUNCTION Wide gradient(const At& at, int k, int d) const {
    if constexpr (M::mls)
      return at.weight(k) * at.arm(k, d) * Wide(1 / S::affine_inertia);
    else
      return at.gradient(k, d);
  }

  template <int C>
  KOKKOS_FORCEINLINE_FUNCTION Smooth<C> smooth(const Table<double>& field, const Tile& tile,
                                               int column = 0) const {
    return Smooth<C>(Field<C>(field, lattice, tile, column));
  }

  /// (A.1), (A.2); with an affine field m (v + C r) as in APIC (Jiang et al. 2015).
  template <class To>
  KOKKOS_INLINE_FUNCTION void momentum(const Row<D>& row, const To& to) const {
    Sums<D + 1, To> sums(to, lattice);
    for_tiles(row, [&](const Tile& tile, const Base& base) {
      Field<D + 1> sum;
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        points.ask_for(points.position, D, b);
        points.ask_for(points.velocity, D, b);
        points.ask_for(points.mass, 1, b);
        if constexpr (M::affine) points.ask_for(points.affine, D * D, b);
        const At at = stencil(base, b);
        const Wide m = points.get(points.mass, b);
        Wide v[D];
        for (int i = 0; i < D; ++i) v[i] = points.get(points.velocity, b, i);
        [[maybe_unused]] Wide affine[D * D];
        if constexpr (M::affine)
          for (int k = 0; k < D * D; ++k)
            affine[k] = points.get(points.affine, b, k) * Wide(lattice.h);
        for (int k = 0; k < nodes; ++k) {
          const Wide nm = at.weight(k) * m;
          sum.value[D][k] += nm;
          for (int i = 0; i < D; ++i) {
            Wide u = v[i];
            if constexpr (M::affine)
              for (int j = 0; j < D; ++j) u += affine[i * D + j] * at.arm(k, j);
            sum.value[i][k] += nm * u;
          }
        }
      });
      sums.add(tile, sum.value);
    });
    sums.flush();
  }

  /// (A.3): -V sigma . grad N. With cell quadrature the mean stress of the cell acts through the
  /// gradient at its centre, so that a uniform pressure in full cells gives exactly no force.
  template <Stress kind, class To>
  KOKKOS_INLINE_FUNCTION void force(const Row<D>& row, const Table<double>& scale,
                                    const To& to) const {
    Sums<D, To> sums(to, lattice);
    for_tiles(row, [&](const Tile& tile, [[maybe_unused]] const Base& base) {
      Field<D> sum;
      if constexpr (M::cells) {
        Pull<kind> total;
        tile.for_bundles([&](const auto& b) BRISANCE_INLINE { total.add(points, b); });
        total.act(sum, tile.read(scale) * Wide(lattice.per_h),
                  [&](int k, int d) { return Wide(centre_gradient<G>(k, d)); });
      } else {
        tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
          const At at = stencil(base, b);
          Pull<kind> total;
          total.add(points, b);
          total.act(sum, lattice.per_h, [&](int k, int d) { return gradient(at, k, d); });
        });
      }
      sums.add(tile, sum.value);
    });
    sums.flush();
  }

  /// Stress times volume. [J/m^(3-D)]
  template <Stress kind>
  struct Pull {
    static constexpr int count = kind == Stress::pressure ? 1 : D * D;
    Wide s[count];

    template <class Bundle>
    KOKKOS_FORCEINLINE_FUNCTION void add(const Particles<G>& of, const Bundle& b) {
      of.ask_for(of.volume, 1, b);
      of.ask_for(of.acting, kind == Stress::pressure ? 1 : G::stress_components, b);
      const Wide v = of.get(of.volume, b);
      if constexpr (kind == Stress::pressure)
        s[0] -= v * of.get(of.acting, b);
      else
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j) s[i * D + j] += v * of.get(of.acting, b, Sym3::at(i, j));
    }

    template <class Gradient>
    KOKKOS_FORCEINLINE_FUNCTION void act(Field<D>& force, const Wide& factor,
                                         const Gradient& g) const {
      Wide pull[count];
      for (int k = 0; k < count; ++k) pull[k] = factor * s[k];
      for (int k = 0; k < nodes; ++k)
        for (int i = 0; i < D; ++i) {
          if constexpr (kind == Stress::pressure)
            force.value[i][k] -= pull[0] * g(k, i);
          else
            for (int j = 0; j < D; ++j) force.value[i][k] -= pull[i * D + j] * g(k, j);
        }
    }
  };

  /// (A.13): sum over nodes of v grad N. [1/s]
  KOKKOS_FORCEINLINE_FUNCTION MatOf<Wide, D> velocity_gradient(const Velocities& v,
                                                               const At& at) const {
    MatOf<Wide, D> sum;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        if constexpr (M::cells)
          sum(i, j) = v.smooth.centre_slope(i, j);
        else if constexpr (M::mls)
          for (int k = 0; k < nodes; ++k) sum(i, j) += gradient(at, k, j) * v.nodes.value[i][k];
        else
          sum(i, j) = v.smooth.slope(at, i, j);
        sum(i, j) *= Wide(lattice.per_h);
      }
    return sum;
  }

  KOKKOS_INLINE_FUNCTION void gradients(const Row<D>& row, const Table<double>& velocity) const {
    for_tiles(row, [&](const Tile& tile, const Base& base) {
      const Velocities v(Field<D>(velocity, lattice, tile));
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        points.ask_for(points.position, D, b);
        points.set_matrix(points.gradient, b, velocity_gradient(v, stencil(base, b)));
      });
    });
  }

  /// A step along the grid velocity (A.9), then what the ends of the domain demand.
  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION void move(const Bundle& b, const Smooth<D>& v, const At& at,
                                        double dt, const Ends<D>& ends) const {
    for (int d = 0; d < D; ++d)
      points.put(points.position, b, d,
                 ends.settle(d, points.get(points.position, b, d) + Wide(dt) * v.at(at, d)));
  }

  /// (A.6), (A.8), and a blend of `1 - flip` toward the grid velocity.
  KOKKOS_INLINE_FUNCTION void accelerate(const Row<D>& row, const Table<double>& before,
                                         const Table<double>& after, const Table<double>& own,
                                         double flip) const {
    const double drawn = 1 - flip;
    for_tiles(row, [&](const Tile& tile, const Base& base) {
      const Field<D> v0(before, lattice, tile);
      Field<D> gain(after, lattice, tile);
      for (int d = 0; d < D; ++d)
        for (int k = 0; k < nodes; ++k) gain.value[d][k] -= v0.value[d][k];
      const Smooth<D> change(gain);
      Smooth<D> mine;
      if (drawn != 0) mine = smooth<D>(own, tile);
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        points.ask_for(points.position, D, b);
        points.ask_for(points.velocity, D, b);
        const At at = stencil(base, b);
        for (int i = 0; i < D; ++i) {
          Wide v = points.get(points.velocity, b, i);
          Wide next = v + change.at(at, i);
          if (drawn != 0) next -= Wide(drawn) * (v - mine.at(at, i));
          points.put(points.velocity, b, i, next);
        }
      });
    });
  }

  KOKKOS_INLINE_FUNCTION void gradient_and_move(const Row<D>& row, const Table<double>& velocity,
                                                const Table<double>& after, const Ends<D>& ends,
                                                double dt) const {
    for_tiles(row, [&](const Tile& tile, const Base& base) {
      const Smooth<D> v1 = smooth<D>(after, tile);
      const Velocities v(Field<D>(velocity, lattice, tile));
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        points.ask_for_all(b);
        const At at = stencil(base, b);
        points.set_matrix(points.gradient, b, velocity_gradient(v, at));
        points.stretch(b, dt);
        move(b, v1, at, dt, ends);
      });
    });
  }

  /// sums(column) <- V of each particle, in the cell that holds it.
  template <class To>
  KOKKOS_INLINE_FUNCTION void volume(const Row<D>& row, int column, const To& to) const {
    constexpr int W = S::holding;
    using C = Around<D, W>;
    TileSums<D, W, 1, To> sums(to, lattice, column, first_cell());
    for_tiles(row, [&](const Tile& tile, [[maybe_unused]] const Base& base) {
      Wide sum[1][C::count];
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        points.ask_for(points.volume, 1, b);
        const Wide v = points.get(points.volume, b);
        for (int k = 0; k < C::count; ++k) {
          if constexpr (W == 1) {
            sum[0][k] += v;
          } else {
            WideBool here = holds(b, base, C::digit(k, 0), 0);
            for (int d = 1; d < D; ++d) here = here && holds(b, base, C::digit(k, d), d);
            sum[0][k] += select(here, v, 0);
          }
        }
      });
      sums.add(tile, sum);
    });
    sums.flush();
  }

  /// sums(column) <- V of each particle, spread over the cells that its shape overlaps.
  template <class To>
  KOKKOS_INLINE_FUNCTION void overlap(const Row<D>& row, int column, const To& to) const {
    constexpr int W = S::cells;
    using C = Around<D, W>;
    TileSums<D, W, 1, To> sums(to, lattice, column);
    for_tiles(row, [&](const Tile& tile, const Base& base) {
      Wide sum[1][C::count];
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        points.ask_for(points.volume, 1, b);
        const At at = stencil(base, b);
        Wide w[D][W];
        for (int d = 0; d < D; ++d) {
          Wide half;
          if constexpr (S::sized) half = points.half_length(b, d, lattice.h);
          S::overlap(at.t[d], half, w[d]);
        }
        for (int k = 0; k < C::count; ++k) {
          Wide share = points.get(points.volume, b);
          for (int d = 0; d < D; ++d) share *= w[d][C::digit(k, d)];
          sum[0][k] += share;
        }
      });
      sums.add(tile, sum);
    });
    sums.flush();
  }

 private:
  /// The cell that may hold a particle first, seen from its bin.
  KOKKOS_FORCEINLINE_FUNCTION int first_cell() const {
    int sum = 0;
    for (int d = 0; d < D; ++d) sum += S::first_holding * lattice.stride[d];
    return sum;
  }

  /// Whether a particle lies, along d, in the k-th cell that may hold it.
  template <class Bundle>
  KOKKOS_FORCEINLINE_FUNCTION WideBool holds(const Bundle& b, const Base& base, int k,
                                             int d) const {
    const Wide t =
        (points.get(points.position, b, d) - Wide(lattice.origin[d])) * Wide(lattice.per_h) -
        base[d] - Wide(S::first_holding + 1);
    return k == 0 ? t < Wide(0) : !(t < Wide(0));
  }
};

}  // namespace brisance
