#include "core/sort.hpp"

#include <algorithm>

#include "core/geometry.hpp"

namespace brisance {
namespace {

/// column(i) <- column(source(i)) for begin <= i < end.
template <class T>
void permute(const T& column, const Array<int>& source, const T& spare, int begin, int end) {
  const Kokkos::RangePolicy<Space> range(begin, end);
  Kokkos::parallel_for(
      "permute", range, KOKKOS_LAMBDA(const int i) { spare(i) = column(source(i)); });
  Kokkos::parallel_for(
      "permute back", range, KOKKOS_LAMBDA(const int i) { column(i) = spare(i); });
}

}  // namespace

template <class G>
int Sorter<G>::sort(Particles<G>& particles, const Transfer<G>& transfer,
                    const Lattice<G::dim>& lattice) {
  transfer.find_bins(lattice, particles);
  return sort(particles, lattice);
}

template <class G>
int Sorter<G>::sort(Particles<G>& particles, const Lattice<G::dim>& lattice) {
  const int count = particles.count,
            bins = lattice.size + 1;  // the last bin: particles that have left
  const int chunks = std::max(1, std::min<int>(Space().concurrency(), count / 1024));
  const int per_chunk = (count + chunks - 1) / chunks;
  if (static_cast<int>(source_.extent(0)) < count) {
    Kokkos::realloc(source_, particles.capacity());
    Kokkos::realloc(spare_, particles.capacity());
  }
  if (static_cast<int>(counts_.extent(0)) < chunks || static_cast<int>(counts_.extent(1)) != bins)
    counts_ = Table<int>("bin counts", chunks, bins);
  if (static_cast<int>(particles.first.extent(0)) != bins + 1)
    particles.first = Array<int>("first of bin", bins + 1);

  const auto bin = particles.bin, source = source_;
  const auto counts = counts_;
  const auto first = particles.first;
  Kokkos::deep_copy(counts, 0);
  const Kokkos::RangePolicy<Space> over_chunks(0, chunks);
  Kokkos::parallel_for(
      "count bins", over_chunks, KOKKOS_LAMBDA(const int c) {
        const int end = (c + 1) * per_chunk < count ? (c + 1) * per_chunk : count;
        for (int p = c * per_chunk; p < end; ++p) ++counts(c, bin(p));
      });
  Kokkos::parallel_scan(
      "places of bins", Kokkos::RangePolicy<Space>(0, bins),
      KOKKOS_LAMBDA(const int b, int& place, bool last) {
        if (last) first(b) = place;
        for (int c = 0; c < chunks; ++c) {
          const int n = counts(c, b);
          if (last) counts(c, b) = place;
          place += n;
        }
        if (last && b == bins - 1) first(bins) = place;
      });
  Kokkos::parallel_for(
      "order of particles", over_chunks, KOKKOS_LAMBDA(const int c) {
        const int end = (c + 1) * per_chunk < count ? (c + 1) * per_chunk : count;
        for (int p = c * per_chunk; p < end; ++p) source(counts(c, bin(p))++) = p;
      });

  // Only the stretch between the first and the last particle out of place is rewritten: ahead of a
  // blast nothing moves.
  Kokkos::MinMaxScalar<int> moved;
  Kokkos::parallel_reduce(
      "out of place", Kokkos::RangePolicy<Space>(0, count),
      KOKKOS_LAMBDA(const int i, Kokkos::MinMaxScalar<int>& range) {
        if (source(i) == i) return;
        range.min_val = i < range.min_val ? i : range.min_val;
        range.max_val = i > range.max_val ? i : range.max_val;
      },
      Kokkos::MinMax<int>(moved));
  if (moved.min_val <= moved.max_val) {
    const int begin = moved.min_val, end = moved.max_val + 1;
    const auto spare = spare_;
    particles.each_column([&](const char*, Table<double>& column, bool carried) {
      if (!carried) return;
      for (std::size_t k = 0; k < column.extent(1); ++k)
        permute(Array<double>(Kokkos::subview(column, Kokkos::ALL, k)), source, spare, begin, end);
    });
    const Array<std::int64_t> spare_id(reinterpret_cast<std::int64_t*>(spare.data()),
                                       spare.extent(0));
    permute(particles.id, source, spare_id, begin, end);
  }

  int inside = 0;
  Kokkos::deep_copy(inside, Kokkos::subview(first, lattice.size));
  particles.count = inside;
  return count - inside;
}

template class Sorter<Line>;
template class Sorter<PlaneStrain>;

}  // namespace brisance
