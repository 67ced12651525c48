#pragma once
// What the stages of one sweep pass on to each other and nobody asks for afterwards: velocity
// gradients and work. On the host each thread has room for the particles of one row, which stays in
// its nearest cache: 32 bytes a particle less with the scheme of the paper, and 4 % of the time of
// `fast`, than columns of all particles. Elsewhere stages are kernels of their own, and there is a
// place for each particle.
#include "core/tile.hpp"

namespace brisance {

/// Its values belong to the particle p at p + shift, where the shift is that of a row.
struct Passing {
  Table<double> table;

  KOKKOS_FORCEINLINE_FUNCTION double& operator()(int place, int k) const { return table(place, k); }
  KOKKOS_FORCEINLINE_FUNCTION double get(int p, int k) const { return table(p, k); }
  KOKKOS_FORCEINLINE_FUNCTION double get(const Single& p, int k) const {
    return table(p.first + p.shift, k);
  }
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION Wide get(const Bundle<full, repeats>& b, int k) const {
    return b.read(&table(0, k) + b.shift);
  }
  KOKKOS_FORCEINLINE_FUNCTION void put(int p, int k, double value) const { table(p, k) = value; }
  KOKKOS_FORCEINLINE_FUNCTION void put(const Single& p, int k, double value) const {
    table(p.first + p.shift, k) = value;
  }
  template <bool full, bool repeats>
  KOKKOS_FORCEINLINE_FUNCTION void put(const Bundle<full, repeats>& b, int k,
                                       const Wide& value) const {
    b.write(&table(0, k) + b.shift, value);
  }
};

}  // namespace brisance
