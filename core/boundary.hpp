#pragma once
// What happens at the ends of the domain. A spline that reaches over an end writes into the halo;
// `fold` brings that back as a mirror image (wall, fixed) or to the other end (periodic),
// `constrain` and `fill` set the halo so that kernels read nodes without asking where they are. A
// free end has neither mirror nor constraint.
#include <limits>

#include "core/lattice.hpp"
#include "core/wide.hpp"

namespace brisance {

enum class Side {
  wall,     ///< frictionless: no velocity across
  fixed,    ///< no velocity at all
  free,     ///< empty space beyond; particles that cross are taken out and counted
  periodic  ///< what leaves here enters at the other end
};

template <int D>
struct Boundaries {
  Side side[D][2] = {};
  bool mirrors = true;  ///< false when every shape is linear: then nothing reaches over a wall

  /// Whether shapes reach over walls that mirror them.
  bool images_beyond_walls() const {
    bool walls = false;
    for (int d = 0; d < D; ++d)
      for (const Side s : side[d]) walls = walls || s == Side::wall || s == Side::fixed;
    return walls && mirrors;
  }

  /// A node on a wall stands for half a cell.
  KOKKOS_INLINE_FUNCTION double nodal_volume(const Lattice<D>& lattice, int node) const {
    int i[D];
    lattice.coordinates(node, i);
    double v = lattice.cell_volume();
    for (int d = 0; d < D; ++d) {
      const bool low = i[d] == 0 && side[d][0] != Side::periodic;
      const bool high = i[d] == lattice.cells[d] && side[d][1] != Side::periodic;
      if (low || high) v *= 0.5;
    }
    return v;
  }
};

/// The ends of a lattice as particles meet them.
template <int D>
struct Ends {
  double low[D], period[D];  ///< period: 0 where nothing wraps [m]
  double inside[D][2];       ///< where walls hold particles; beyond all numbers at free ends

  Ends(const Lattice<D>& lattice, const Boundaries<D>& boundaries) {
    const double skin = 1e-9 * lattice.h, far = std::numeric_limits<double>::infinity();
    for (int d = 0; d < D; ++d) {
      const double length = lattice.cells[d] * lattice.h;
      const bool wraps = boundaries.side[d][0] == Side::periodic;
      low[d] = lattice.origin[d];
      period[d] = wraps ? length : 0;
      inside[d][0] = wraps || boundaries.side[d][0] == Side::free ? -far : low[d] + skin;
      inside[d][1] = wraps || boundaries.side[d][1] == Side::free ? far : low[d] + length - skin;
    }
  }

  /// Where a particle that has moved to x along direction d ends up: inside a wall, wrapped, or out
  /// of a free end.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T settle(int d, T x) const {
    if (period[d] > 0) {
      x = select(x < T(low[d]), x + T(period[d]), x);
      return select(x < T(low[d] + period[d]), x, x - T(period[d]));
    }
    return clamp(x, T(inside[d][0]), T(inside[d][1]));
  }
};

/// Adds what the halo has received to the nodes it stands for. The first `vectors` columns are
/// components of a vector, those up to `columns` scalars. Returns the momentum that mirror images
/// have swallowed. `image_mass`, unless empty, receives for each direction the mass (column
/// `vectors`) that was found at the nodes beyond its walls.
template <int D>
Vec<D> fold(const Table<double>& sums, int vectors, int columns, const Lattice<D>& lattice,
            const Boundaries<D>& boundaries, const Table<double>& image_mass = {});

/// By how much the momentum that particles gather from a nodal velocity, sum m N v, exceeds that of
/// the nodes: beyond a wall they meet the mirror image, -v, where fold has counted their mass with
/// v. Zero without images.
template <int D>
Vec<D> image_momentum(const Table<double>& velocity, const Table<double>& image_mass,
                      const Lattice<D>& lattice, const Boundaries<D>& boundaries);

/// Zeroes the constrained components of a nodal momentum or force (columns 0 .. D-1) and returns
/// their sum.
template <int D>
Vec<D> constrain(const Table<double>& sums, const Lattice<D>& lattice,
                 const Boundaries<D>& boundaries);

/// Sets the halo of a nodal field from the nodes it stands for; vectors change sign as mirror
/// images do.
template <int D>
void fill(const Table<double>& field, int vectors, int columns, const Lattice<D>& lattice,
          const Boundaries<D>& boundaries);

/// Adds what halo cells have received in a column to the cells whose mirror images they are.
template <int D>
void fold_cells(const Table<double>& sums, int column, const Lattice<D>& lattice,
                const Boundaries<D>& boundaries);

/// Sets the halo of a field of cells: copies of the nearest cell, or of the other end where
/// periodic. Beyond a free end the columns from `zeroed` on are 0, the others copied.
template <int D>
void fill_cells(const Table<double>& field, int zeroed, const Lattice<D>& lattice,
                const Boundaries<D>& boundaries);

}  // namespace brisance
