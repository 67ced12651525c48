#pragma once
// In which order the rows of bins are worked on: today as plain sweeps, one kernel at a time.
// Kernels are written as functions of a row, so that another schedule (a wavefront of rows) can
// call the same functions.
#include <string>

#include "core/lattice.hpp"

namespace brisance {

/// A run of neighbouring bins along x: bins begin .. end, the first of them at integer coordinates
/// `base`.
template <int D>
struct Row {
  int begin, end;
  int base[D];
};

/// Bins in one row: long enough to amortise its start, short enough to feed all threads on a small
/// grid.
constexpr int row_length = 32;

/// Calls f(row) for all rows of the lattice. The split does not depend on the number of threads and
/// the schedule is static, so sums that a thread collects over its rows are the same from run to
/// run.
template <int D, class F>
void for_rows(const std::string& name, const Lattice<D>& lattice, const F& f) {
  const int line = lattice.extent(0);
  const int pieces = (line + row_length - 1) / row_length;
  const int lines = lattice.size / line;
  using Policy = Kokkos::RangePolicy<Space, Kokkos::Schedule<Kokkos::Static>>;
  Kokkos::parallel_for(
      name, Policy(0, pieces * lines), KOKKOS_LAMBDA(const int k) {
        const int piece = k % pieces, start = k / pieces * line;
        Row<D> row;
        row.begin = start + piece * row_length;
        row.end = start + (piece + 1 < pieces ? (piece + 1) * row_length : line);
        lattice.coordinates(row.begin, row.base);
        f(row);
      });
}

}  // namespace brisance
