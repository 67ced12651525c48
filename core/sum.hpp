#pragma once
// A sum that does not depend on the number of threads.
#include "core/types.hpp"

namespace brisance {

/// f(0) + ... + f(n - 1) in this order, by one thread: for the few sums over a plane of nodes, or
/// over all of them where a scene has springs. Kokkos' own reductions add up what each thread has.
template <class F>
double sum_in_order(const char* name, int n, const F& f) {
  double all = 0;
  Kokkos::parallel_reduce(
      name, Kokkos::RangePolicy<Space>(0, 1),
      KOKKOS_LAMBDA(const int, double& sum) {
        for (int k = 0; k < n; ++k) sum += f(k);
      },
      all);
  return all;
}

}  // namespace brisance
