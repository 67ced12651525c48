// What the machine can do, by which kernels are judged: the triad of STREAM, and multiplications
// with additions in registers.
#include <benchmark/benchmark.h>

#include "core/types.hpp"
#include "perf/benchmarks.hpp"

namespace brisance::perf {
namespace {

/// Three arrays of 64 MB: beyond the caches.
void triad(benchmark::State& state) {
  constexpr int n = 1 << 23;
  const Array<double> a("a", n), b("b", n), c("c", n);
  Kokkos::deep_copy(b, 1.0);
  Kokkos::deep_copy(c, 2.0);
  for ([[maybe_unused]] auto once : state) {
    Kokkos::parallel_for(
        "triad", Kokkos::RangePolicy<Space>(0, n),
        KOKKOS_LAMBDA(const int k) { a(k) = b(k) + 3.0 * c(k); });
    Kokkos::fence();
  }
  state.counters["GB/s"] = benchmark::Counter(24e-9 * n * static_cast<double>(state.iterations()),
                                              benchmark::Counter::kIsRate);
}

/// As many chains as hide the delay of one and still fit the registers.
void multiply_add(benchmark::State& state) {
  constexpr int chains = 48, length = 1 << 18;
  const int threads = Space().concurrency();
  const Array<double> sums("sums", threads);
  for ([[maybe_unused]] auto once : state) {
    Kokkos::parallel_for(
        "multiply and add", Kokkos::RangePolicy<Space>(0, threads), KOKKOS_LAMBDA(const int t) {
          double a[chains];
          for (int c = 0; c < chains; ++c) a[c] = 1e-9 * (c + t);
          for (int k = 0; k < length; ++k)
            for (int c = 0; c < chains; ++c) a[c] = 0.999999 * a[c] + 1e-6;
          double sum = 0;
          for (int c = 0; c < chains; ++c) sum += a[c];
          sums(t) = sum;
        });
    Kokkos::fence();
  }
  state.counters["GFLOP/s"] =
      benchmark::Counter(2e-9 * chains * length * threads * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

}  // namespace

void register_machine() {
  benchmark::RegisterBenchmark("machine/triad", triad)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("machine/multiply and add", multiply_add)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace brisance::perf
