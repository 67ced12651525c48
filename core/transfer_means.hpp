#pragma once
// Means over nodes, to them and back, as functions of a row: what relaxations are made of.
#include "core/transfer_rows.hpp"

namespace brisance {

template <class G, class M>
struct Means {
  using R = Rows<G, M>;
  using Base = typename R::Base;
  static constexpr int D = G::dim, nodes = R::nodes;

  R rows;

  /// sums <- N w v, N w for each of C values v with their weights w, from a column on.
  template <int C, class To>
  KOKKOS_INLINE_FUNCTION void scatter(const Row<D>& row, const Kokkos::Array<Weighted, C>& what,
                                      int column, const To& to) const {
    const Particles<G>& points = rows.points;
    typename R::template Sums<2 * C, To> sums(to, rows.lattice, column);
    rows.for_tiles(row, [&](const Tile& tile, const Base& base) {
      typename R::template Field<2 * C> sum;
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        points.ask_for(points.position, D, b);
        const typename R::At at = rows.stencil(base, b);
        for (int c = 0; c < C; ++c) {
          const Weighted& one = what[c];
          points.ask_for(one.weight, b);
          points.ask_for(one.value, b);
          const Wide w = points.get(one.weight.table, b, one.weight.column),
                     v = w * points.get(one.value.table, b, one.value.column);
          for (int k = 0; k < nodes; ++k) {
            const Wide n = at.weight(k);
            sum.value[2 * c][k] += n * v;
            sum.value[2 * c + 1][k] += n * w;
          }
        }
      });
      sums.add(tile, sum.value);
    });
    sums.flush();
  }

  /// sums <- N w v for the C columns v of a table (columns 0 .. C-1) and N w (column C), w being
  /// the column after them.
  template <int C, class To>
  KOKKOS_INLINE_FUNCTION void scatter_all(const Row<D>& row, const Table<double>& values,
                                          const To& to) const {
    const Particles<G>& points = rows.points;
    typename R::template Sums<C + 1, To> sums(to, rows.lattice);
    rows.for_tiles(row, [&](const Tile& tile, const Base& base) {
      typename R::template Field<C + 1> sum;
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        const typename R::At at = rows.stencil(base, b);
        const Wide w = points.get(values, b, C);
        Wide v[C];
        for (int c = 0; c < C; ++c) v[c] = points.get(values, b, c);
        for (int k = 0; k < nodes; ++k) {
          const Wide share = at.weight(k) * w;
          for (int c = 0; c < C; ++c) sum.value[c][k] += share * v[c];
          sum.value[C][k] += share;
        }
      });
      sums.add(tile, sum.value);
    });
    sums.flush();
  }

  /// Each of C values <- keep * value + factor * sum over nodes of N field.
  template <int C>
  KOKKOS_INLINE_FUNCTION void gather(const Row<D>& row,
                                     const Kokkos::Array<Gathering, C>& what) const {
    const Particles<G>& points = rows.points;
    rows.for_tiles(row, [&](const Tile& tile, const Base& base) {
      typename R::template Smooth<1> fields[C];
      for (int c = 0; c < C; ++c)
        fields[c] = rows.template smooth<1>(what[c].field.table, tile, what[c].field.column);
      tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
        points.ask_for(points.position, D, b);
        const typename R::At at = rows.stencil(base, b);
        for (int c = 0; c < C; ++c) {
          const Entry& to = what[c].value;
          points.ask_for(to, b);
          Wide value = what[c].factor * fields[c].at(at, 0);
          if (what[c].keep != 0) value += what[c].keep * points.get(to.table, b, to.column);
          points.put(to.table, b, to.column, value);
        }
      });
    });
  }
};

}  // namespace brisance
