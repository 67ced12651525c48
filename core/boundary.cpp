#include "core/boundary.hpp"

#include "core/sum.hpp"

namespace brisance {
namespace {

/// The halo planes of one direction and the planes that they stand for.
struct Images {
  int count = 0;
  int halo[3] = {}, real[3] = {};
  Side side[3] = {};
  void add(int from, int to, Side kind) {
    halo[count] = from;
    real[count] = to;
    side[count++] = kind;
  }
};

template <int D>
Images images(const Lattice<D>& lattice, const Boundaries<D>& boundaries, int d) {
  const int n = lattice.cells[d];
  const Side low = boundaries.side[d][0], high = boundaries.side[d][1];
  Images list;
  if (low == Side::periodic) {
    list.add(-1, n - 1, low);
    list.add(n, 0, low);
    list.add(n + 1, 1 % n, low);
    return list;
  }
  if (low != Side::free && boundaries.mirrors) list.add(-1, 1, low);
  if (high != Side::free && boundaries.mirrors) list.add(n + 1, n - 1, high);
  return list;
}

/// The nodes of a plane across direction d: `first(k)` is the k-th of the lowest plane.
template <int D>
struct Plane {
  int stride, extent, nodes;
  Plane(const Lattice<D>& lattice, int d)
      : stride(lattice.stride[d]), extent(lattice.extent(d)), nodes(lattice.size / extent) {}
  KOKKOS_INLINE_FUNCTION int node(int k, int coordinate) const {
    return k / stride * stride * extent + k % stride + (coordinate + Lattice<D>::halo) * stride;
  }
};

/// Calls f(halo cell, the cell whose image it is, whether beyond a free end) for all halo cells.
template <int D, class F>
void for_halo_cells(const Lattice<D>& lattice, const Boundaries<D>& boundaries, const char* name,
                    const F& f) {
  for (int d = 0; d < D; ++d) {
    const Plane<D> plane(lattice, d);
    const int n = lattice.cells[d];
    const bool periodic = boundaries.side[d][0] == Side::periodic;
    for (int end = 0; end < 2; ++end) {
      const bool open = boundaries.side[d][end] == Side::free;
      const int halo = end == 0 ? -1 : n;
      const int real = (end == 0) == periodic ? n - 1 : 0;
      Kokkos::parallel_for(
          name, Kokkos::RangePolicy<Space>(0, plane.nodes),
          KOKKOS_LAMBDA(const int k) { f(plane.node(k, halo), plane.node(k, real), open); });
    }
  }
}

/// Whether component c of a vector changes sign in the mirror image across direction d.
KOKKOS_INLINE_FUNCTION bool flips(Side side, int c, int d) {
  return side == Side::fixed || (side == Side::wall && c == d);
}

}  // namespace

template <int D>
Vec<D> fold(const Table<double>& sums, int vectors, int columns, const Lattice<D>& lattice,
            const Boundaries<D>& boundaries, const Table<double>& image_mass) {
  Vec<D> swallowed;
  const bool keep_mass = image_mass.extent(0) > 0;
  for (int d = 0; d < D; ++d) {
    const Images list = images(lattice, boundaries, d);
    if (list.count == 0) continue;
    const Plane<D> plane(lattice, d);
    for (int c = 0; c < vectors; ++c) {
      if (list.side[0] == Side::periodic) break;
      swallowed[c] += sum_in_order(
          "mirror momentum", plane.nodes, KOKKOS_LAMBDA(const int k) {
            double sum = 0;
            for (int i = 0; i < list.count; ++i)
              if (flips(list.side[i], c, d)) sum += 2 * sums(plane.node(k, list.halo[i]), c);
            return sum;
          });
    }
    Kokkos::parallel_for(
        "fold halo", Kokkos::RangePolicy<Space>(0, plane.nodes), KOKKOS_LAMBDA(const int k) {
          for (int i = 0; i < list.count; ++i) {
            if (keep_mass && list.side[i] != Side::periodic)
              image_mass(plane.node(k, list.halo[i]), d) =
                  sums(plane.node(k, list.halo[i]), vectors);
            for (int c = 0; c < columns; ++c) {
              double& ghost = sums(plane.node(k, list.halo[i]), c);
              const bool flip = c < vectors && flips(list.side[i], c, d);
              sums(plane.node(k, list.real[i]), c) += flip ? -ghost : ghost;
              ghost = 0;
            }
          }
        });
  }
  return swallowed;
}

template <int D>
Vec<D> image_momentum(const Table<double>& velocity, const Table<double>& image_mass,
                      const Lattice<D>& lattice, const Boundaries<D>& boundaries) {
  Vec<D> momentum;
  if (image_mass.extent(0) == 0) return momentum;
  for (int d = 0; d < D; ++d) {
    const Images list = images(lattice, boundaries, d);
    const Plane<D> plane(lattice, d);
    for (int c = 0; c < D; ++c) {
      bool any = false;
      for (int i = 0; i < list.count; ++i) any = any || flips(list.side[i], c, d);
      if (!any) continue;
      momentum[c] += sum_in_order(
          "image momentum", plane.nodes, KOKKOS_LAMBDA(const int k) {
            double sum = 0;
            for (int i = 0; i < list.count; ++i) {
              const int n = plane.node(k, list.halo[i]);
              if (flips(list.side[i], c, d)) sum += 2 * image_mass(n, d) * velocity(n, c);
            }
            return sum;
          });
    }
  }
  return momentum;
}

template <int D>
Vec<D> constrain(const Table<double>& sums, const Lattice<D>& lattice,
                 const Boundaries<D>& boundaries) {
  Vec<D> stopped;
  for (int d = 0; d < D; ++d)
    for (int end = 0; end < 2; ++end) {
      const Side side = boundaries.side[d][end];
      if (side != Side::wall && side != Side::fixed) continue;
      const Plane<D> plane(lattice, d);
      const int at = end == 0 ? 0 : lattice.cells[d];
      for (int c = 0; c < D; ++c) {
        if (!flips(side, c, d)) continue;
        stopped[c] += sum_in_order(
            "hold wall", plane.nodes, KOKKOS_LAMBDA(const int k) {
              double& value = sums(plane.node(k, at), c);
              const double held = value;
              value = 0;
              return held;
            });
      }
    }
  return stopped;
}

template <int D>
void fill(const Table<double>& field, int vectors, int columns, const Lattice<D>& lattice,
          const Boundaries<D>& boundaries) {
  for (int d = 0; d < D; ++d) {
    const Images list = images(lattice, boundaries, d);
    if (list.count == 0) continue;
    const Plane<D> plane(lattice, d);
    Kokkos::parallel_for(
        "fill halo", Kokkos::RangePolicy<Space>(0, plane.nodes), KOKKOS_LAMBDA(const int k) {
          for (int i = 0; i < list.count; ++i)
            for (int c = 0; c < columns; ++c) {
              const double value = field(plane.node(k, list.real[i]), c);
              field(plane.node(k, list.halo[i]), c) =
                  c < vectors && flips(list.side[i], c, d) ? -value : value;
            }
        });
  }
}

template <int D>
void fold_cells(const Table<double>& sums, int column, const Lattice<D>& lattice,
                const Boundaries<D>& boundaries) {
  for_halo_cells(
      lattice, boundaries, "fold halo cells", KOKKOS_LAMBDA(int halo, int real, bool open) {
        if (!open) sums(real, column) += sums(halo, column);
        sums(halo, column) = 0;
      });
}

template <int D>
void fill_cells(const Table<double>& field, int zeroed, const Lattice<D>& lattice,
                const Boundaries<D>& boundaries) {
  const int columns = static_cast<int>(field.extent(1));
  for_halo_cells(
      lattice, boundaries, "fill halo cells", KOKKOS_LAMBDA(int halo, int real, bool open) {
        for (int c = 0; c < columns; ++c) field(halo, c) = open && c >= zeroed ? 0 : field(real, c);
      });
}

#define BRISANCE_BOUNDARY(D)                                                                       \
  template Vec<D> fold<D>(const Table<double>&, int, int, const Lattice<D>&, const Boundaries<D>&, \
                          const Table<double>&);                                                   \
  template Vec<D> image_momentum<D>(const Table<double>&, const Table<double>&, const Lattice<D>&, \
                                    const Boundaries<D>&);                                         \
  template Vec<D> constrain<D>(const Table<double>&, const Lattice<D>&, const Boundaries<D>&);     \
  template void fill<D>(const Table<double>&, int, int, const Lattice<D>&, const Boundaries<D>&);  \
  template void fold_cells<D>(const Table<double>&, int, const Lattice<D>&, const Boundaries<D>&); \
  template void fill_cells<D>(const Table<double>&, int, const Lattice<D>&, const Boundaries<D>&);
BRISANCE_BOUNDARY(1)
BRISANCE_BOUNDARY(2)
#undef BRISANCE_BOUNDARY

}  // namespace brisance
