#include "core/split.hpp"

#include "core/geometry.hpp"

namespace brisance {

namespace {

/// How a particle is to be cut: a bit for each direction.
template <class G>
struct Cut {
  static constexpr int D = G::dim;
  Particles<G> points;
  double longest;  ///< half the greatest length that is left whole [m]

  KOKKOS_INLINE_FUNCTION int mask(int p) const {
    int m = 0;
    for (int d = 0; d < D; ++d)
      if (points.half_size(p, d) > longest) m |= 1 << d;
    return m;
  }
  KOKKOS_INLINE_FUNCTION static int parts(int mask) {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= mask >> d & 1 ? 2 : 1;
    return n;
  }
};

}  // namespace

template <class G>
void find_longest(Sweep<G::dim>& in, const Particles<G>& points, const Array<double>& of_rows) {
  in.add(
      "longest particle", KOKKOS_LAMBDA(const Row<G::dim>& row) {
        Wide longest;
        points.for_all(row, [&](const auto& b) BRISANCE_INLINE {
          for (int d = 0; d < G::dim; ++d) longest = most(longest, points.half_size(b, d));
        });
        of_rows(row.number) = most(of_rows(row.number), 2 * greatest(longest));
      });
}

double take_longest(const Array<double>& of_rows) {
  double longest = 0;
  Kokkos::parallel_reduce(
      "longest of rows", Kokkos::RangePolicy<Space>(0, static_cast<int>(of_rows.extent(0))),
      KOKKOS_LAMBDA(const int k, double& so_far) {
        so_far = most(so_far, of_rows(k));
        of_rows(k) = 0;
      },
      Kokkos::Max<double>(longest));
  return longest;
}

template <class G>
int split(Particles<G>& particles, const Lattice<G::dim>& lattice,
          const Boundaries<G::dim>& boundaries, double length, std::int64_t& next_id) {
  constexpr int D = G::dim;
  const int count = particles.count;
  const Kokkos::RangePolicy<Space> over(0, count);
  const double longest = 0.5 * length * lattice.h;
  int added = 0;
  {
    const Cut<G> cut{particles, longest};
    Kokkos::parallel_reduce(
        "count parts", over,
        KOKKOS_LAMBDA(const int p, int& sum) { sum += cut.parts(cut.mask(p)) - 1; }, added);
  }
  if (added == 0) return 0;
  particles.reserve(count + added);

  const Cut<G> cut{particles, longest};
  const Array<int> mask("directions to cut", count), place("place of parts", count);
  Kokkos::parallel_scan(
      "place parts", over, KOKKOS_LAMBDA(const int p, int& sum, bool last) {
        const int m = cut.mask(p);
        if (last) {
          mask(p) = m;
          place(p) = count + sum;
        }
        sum += cut.parts(m) - 1;
      });
  particles.each_column([&](const char*, Table<double>& column, bool carried) {
    if (!carried) return;
    const auto values = column;
    const int columns = static_cast<int>(column.extent(1));
    Kokkos::parallel_for(
        "copy parts", over, KOKKOS_LAMBDA(const int p) {
          for (int c = 0; c < cut.parts(mask(p)) - 1; ++c)
            for (int k = 0; k < columns; ++k) values(place(p) + c, k) = values(p, k);
        });
  });
  const Particles<G> points = particles;
  const Ends<D> ends(lattice, boundaries);
  const std::int64_t id = next_id;
  Kokkos::parallel_for(
      "lay out parts", over, KOKKOS_LAMBDA(const int p) {
        const int parts = cut.parts(mask(p));
        if (parts == 1) return;
        const Vec<D> x = points.x(p);
        Vec<D> arm;
        for (int d = 0; d < D; ++d) arm[d] = mask(p) >> d & 1 ? 0.5 * points.half_size(p, d) : 0;
        const double m = points.m(p) / parts, v = points.vol(p) / parts;
        for (int c = 0; c < parts; ++c) {
          const int q = c == 0 ? p : place(p) + c - 1;
          int bit = 0;
          for (int d = 0; d < D; ++d) {
            const bool cut_here = mask(p) >> d & 1;
            const double side = cut_here && (c >> bit++ & 1) ? 1 : -1;
            points.position(q, d) = ends.settle(d, x[d] + side * arm[d]);
            if (cut_here && points.extent.extent(1) > 0) points.extent(q, d) *= 0.5;
          }
          points.m(q) = m;
          points.vol(q) = v;
          if (c > 0) points.id(q) = id + (q - count);
        }
      });
  particles.count = count + added;
  next_id += added;
  return added;
}

template void find_longest<Line>(Sweep<1>&, const Particles<Line>&, const Array<double>&);
template void find_longest<PlaneStrain>(Sweep<2>&, const Particles<PlaneStrain>&,
                                        const Array<double>&);
template int split<Line>(Particles<Line>&, const Lattice<1>&, const Boundaries<1>&, double,
                         std::int64_t&);
template int split<PlaneStrain>(Particles<PlaneStrain>&, const Lattice<2>&, const Boundaries<2>&,
                                double, std::int64_t&);

}  // namespace brisance
