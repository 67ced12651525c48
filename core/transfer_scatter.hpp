#pragma once
// The row functions that add to nodes, as function objects: what they add to is a table, or a
// thread's copy of it.
#include "core/transfer_means.hpp"

namespace brisance {

template <class R>
struct ScatterMomentum {
  R rows;
  template <class To>
  KOKKOS_INLINE_FUNCTION void operator()(const Row<R::D>& row, const To& to) const {
    rows.momentum(row, to);
  }
};

template <class R, Stress kind>
struct ScatterForce {
  R rows;
  Table<double> scale;
  template <class To>
  KOKKOS_INLINE_FUNCTION void operator()(const Row<R::D>& row, const To& to) const {
    rows.template force<kind>(row, scale, to);
  }
};

template <class R>
struct ScatterVolume {
  R rows;
  int column;
  template <class To>
  KOKKOS_INLINE_FUNCTION void operator()(const Row<R::D>& row, const To& to) const {
    rows.volume(row, column, to);
  }
};

template <class R>
struct ScatterOverlap {
  R rows;
  int column;
  template <class To>
  KOKKOS_INLINE_FUNCTION void operator()(const Row<R::D>& row, const To& to) const {
    rows.overlap(row, column, to);
  }
};

template <class Means, int C>
struct ScatterMeans {
  Means means;
  Kokkos::Array<Weighted, C> what;
  int column;
  template <class To>
  KOKKOS_INLINE_FUNCTION void operator()(const Row<Means::D>& row, const To& to) const {
    means.template scatter<C>(row, what, column, to);
  }
};

template <class Means, int C>
struct ScatterAllMeans {
  Means means;
  Table<double> values;
  template <class To>
  KOKKOS_INLINE_FUNCTION void operator()(const Row<Means::D>& row, const To& to) const {
    means.template scatter_all<C>(row, values, to);
  }
};

}  // namespace brisance
