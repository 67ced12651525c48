#include "core/lull.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry.hpp"

namespace brisance {
namespace {

template <class T>
auto on_host(const T& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

/// States that come from the same numbers differ by round-off.
bool same(double a, double b) { return std::fabs(a - b) <= 1e-12 * std::fabs(b); }

template <class G>
class Finder {
 public:
  static constexpr int D = G::dim, corners = power(2, D);

  explicit Finder(const Grid<G>& grid)
      : lattice_(grid.lattice),
        boundaries_(grid.boundaries),
        share_(lattice_.size * std::size_t{corners}) {
    rest.owner.assign(lattice_.size, nobody);
    rest.pressure.resize(lattice_.size);
    rest.density.resize(lattice_.size);
    rest.sleeps.assign(lattice_.size, 0);
  }

  Rest rest;

  void look(const Particles<G>& p, int group, bool may, double longest) {
    const auto position = on_host(p.position), velocity = on_host(p.velocity),
               volume = on_host(p.volume), mass = on_host(p.mass), stress = on_host(p.stress),
               extent = on_host(p.extent);
    for (int q = 0; q < p.count; ++q) {
      Vec<D> x;
      bool at_rest = may;
      double box = 1;
      for (int d = 0; d < D; ++d) {
        x[d] = position(q, d);
        at_rest = at_rest && velocity(q, d) == 0;
        if (extent.extent(1) > 0) box *= extent(q, d);
      }
      const double v = volume(q, 0), scale = Particles<G>::root(v / box);
      for (int d = 0; d < D; ++d) {
        const double length = extent.extent(1) > 0 ? extent(q, d) * scale : Particles<G>::root(v);
        at_rest = at_rest && !(longest > 0 && length > longest);
      }
      const double density = mass(q, 0) / v, pressure = stress(q, 0);
      at_rest = at_rest && pressure > 0 && density > 0;
      const int c = lattice_.cell_of(x);
      int& owner = rest.owner[c];
      if (!at_rest) {
        owner = mixed;
      } else if (owner == nobody) {
        owner = group;
        rest.pressure[c] = pressure;
        rest.density[c] = density;
      } else if (owner != group || !same(pressure, rest.pressure[c]) ||
                 !same(density, rest.density[c])) {
        owner = mixed;
      }
      share(c, x, v);
    }
  }

  void decide(int margin) {
    for (int c = 0; c < lattice_.size; ++c)
      if (rest.owner[c] < 0 || !full(c)) rest.owner[c] = -1;
    for (int c = 0; c < lattice_.size; ++c)
      rest.sleeps[c] = rest.owner[c] >= 0 && quiet_around(c, margin) ? 1 : 0;
  }

 private:
  static constexpr int nobody = -1, mixed = -2;
  Lattice<D> lattice_;
  Boundaries<D> boundaries_;
  std::vector<double> share_;  ///< sum N V at each corner of each cell [m^D]

  void share(int cell, const Vec<D>& x, double volume) {
    int i[D];
    lattice_.coordinates(cell, i);
    for (int k = 0; k < corners; ++k) {
      double weight = volume;
      for (int d = 0; d < D; ++d) {
        const double within = lattice_.in_cells(x[d], d) - i[d];
        weight *= k >> d & 1 ? within : 1 - within;
      }
      share_[cell * std::size_t{corners} + k] += weight;
    }
  }

  /// Each corner has its part of the volume: so the pressure of the cell's neighbours balances its
  /// own at every node, and no relaxation finds anything to do.
  bool full(int cell) const {
    const double part = lattice_.cell_volume() / corners;
    for (int k = 0; k < corners; ++k)
      if (std::fabs(share_[cell * std::size_t{corners} + k] - part) > 1e-9 * part) return false;
    return true;
  }

  /// Beyond a wall lies the mirror image; beyond another end nobody knows.
  bool quiet_around(int cell, int margin) const {
    int i[D];
    lattice_.coordinates(cell, i);
    for (int k = 0; k < power(2 * margin + 1, D); ++k) {
      int neighbour = cell;
      bool inside = true;
      for (int d = 0; d < D; ++d) {
        const int step = k / power(2 * margin + 1, d) % (2 * margin + 1) - margin;
        neighbour += step * lattice_.stride[d];
        const int end = i[d] + step < 0 ? 0 : (i[d] + step >= lattice_.cells[d] ? 1 : -1);
        if (end < 0) continue;
        inside = false;
        const Side side = boundaries_.side[d][end];
        if (side != Side::wall && side != Side::fixed) return false;
      }
      if (inside && !(rest.owner[neighbour] == rest.owner[cell] &&
                      same(rest.pressure[neighbour], rest.pressure[cell]) &&
                      same(rest.density[neighbour], rest.density[cell])))
        return false;
    }
    return true;
  }
};

}  // namespace

template <class G>
Rest find_rest(const std::vector<std::unique_ptr<Group<G>>>& groups, const std::vector<bool>& may,
               const Grid<G>& grid, double split_length, int margin) {
  Finder<G> finder(grid);
  for (std::size_t g = 0; g < groups.size(); ++g)
    finder.look(groups[g]->particles, static_cast<int>(g), may[g],
                1.001 * split_length * grid.lattice.h);
  finder.decide(margin);
  return finder.rest;
}

#define BRISANCE_LULL(G)                                                    \
  template Rest find_rest<G>(const std::vector<std::unique_ptr<Group<G>>>&, \
                             const std::vector<bool>&, const Grid<G>&, double, int);
BRISANCE_LULL(Line)
BRISANCE_LULL(PlaneStrain)
#undef BRISANCE_LULL

}  // namespace brisance
