#include "drivers/probe.hpp"

#include "core/geometry.hpp"

namespace brisance {
namespace {

/// The quadratic B-spline of knots one apart, 0 beyond 1.5. [-]
KOKKOS_INLINE_FUNCTION double spline(double z) {
  const double r = fabs(z);
  if (r < 0.5) return 0.75 - r * r;
  return r < 1.5 ? 0.5 * square(1.5 - r) : 0;
}

constexpr double reach = 1.5;  // of the spline, in radii

KOKKOS_INLINE_FUNCTION int round_up(int n, int unit) { return (n + unit - 1) / unit * unit; }

template <int D>
struct Look {
  Vec<D> place;
  double radius = 0;
  bool looks = false;  ///< whether the material at hand counts
};

template <int D>
struct Sum {
  double volume = 0, pressure = 0, mass = 0;  ///< weighted
  Vec<D> momentum;
  int points = 0;
};

/// The sums of the particles of one material.
template <class G>
struct Eye {
  static constexpr int D = G::dim;
  Particles<G> points;
  Array<double> pressure;
  Lattice<D> lattice;
  Boundaries<D> boundaries;

  KOKKOS_INLINE_FUNCTION void operator()(const Look<D>& look, Sum<D>& sum) const {
    // Across a joined end the window is seen at its images, too.
    for (int image = 0; image < power(3, D); ++image) {
      Vec<D> place = look.place;
      bool there = true;
      for (int d = 0; d < D; ++d) {
        const int turn = image / power(3, d) % 3 - 1;
        there = there && (turn == 0 || boundaries.side[d][0] == Side::periodic);
        place[d] += turn * lattice.cells[d] * lattice.h;
      }
      if (there) at(place, look.radius, sum);
    }
  }

 private:
  /// A bin is named by a node up to one before the cell of its particles.
  KOKKOS_INLINE_FUNCTION void at(const Vec<D>& place, double radius, Sum<D>& sum) const {
    int low[D], high[D], rows = 1;
    for (int d = 0; d < D; ++d) {
      const double end = lattice.cells[d];
      const double from = lattice.in_cells(place[d] - reach * radius, d),
                   to = lattice.in_cells(place[d] + reach * radius, d);
      if (!(to >= 0 && from <= end)) return;
      low[d] = static_cast<int>(floor(most(from, 0))) - 1;
      high[d] = static_cast<int>(floor(least(to, end)));
      if (d > 0) rows *= high[d] - low[d] + 1;
    }
    for (int row = 0; row < rows; ++row) {
      int i[D], rest = row;
      for (int d = 1; d < D; ++d) {
        i[d] = low[d] + rest % (high[d] - low[d] + 1);
        rest /= high[d] - low[d] + 1;
      }
      i[0] = low[0];
      // Whole tiles: their particles do not lie bin by bin.
      const int bin = lattice.index(i), in_line = i[0] + lattice.halo;
      const int begin = bin - in_line % Wide::lanes,
                end = begin + round_up(bin - begin + high[0] - low[0] + 1, Wide::lanes),
                line_end = bin - in_line + lattice.extent(0);
      for (int p = points.first(begin); p < points.first(end < line_end ? end : line_end); ++p)
        add(p, place, radius, sum);
    }
  }

  KOKKOS_INLINE_FUNCTION void add(int p, const Vec<D>& place, double radius, Sum<D>& sum) const {
    double w = 1;
    for (int d = 0; d < D; ++d) w *= spline((points.position(p, d) - place[d]) / radius);
    if (!(w > 0)) return;
    const double wv = w * points.vol(p), wm = w * points.m(p);
    sum.volume += wv;
    sum.pressure += wv * pressure(p);
    sum.mass += wm;
    for (int d = 0; d < D; ++d) sum.momentum[d] += wm * points.velocity(p, d);
    ++sum.points;
  }
};

/// Whether a group counts for a window, fluids first where it names none.
template <class G>
bool counts(const State<G>& state, std::size_t g, const Window& window, bool fluid) {
  if (window.material >= 0) return window.material == static_cast<int>(g);
  return state.groups[g]->fluid() == fluid;
}

template <class G>
void look(const Group<G>& group, const Grid<G>& grid, const Array<Look<G::dim>>& looks,
          const Array<Sum<G::dim>>& sums) {
  if (group.particles.count == 0) return;
  const Array<double> pressure("pressure", group.particles.count);
  const Array<double> energy("energy", group.particles.count);
  group.report(pressure, energy);
  const Eye<G> eye{group.particles, pressure, grid.lattice, grid.boundaries};
  Kokkos::parallel_for(
      "look", Kokkos::RangePolicy<Space>(0, static_cast<int>(looks.extent(0))),
      KOKKOS_LAMBDA(const int k) {
        if (looks(k).looks) eye(looks(k), sums(k));
      });
}

/// Sums over the fluids, or the solids, that count for each window.
template <class G>
std::vector<Sum<G::dim>> sums_over(const State<G>& state, const std::vector<Window>& windows,
                                   bool fluid) {
  constexpr int D = G::dim;
  const std::size_t count = windows.size();
  const Array<Look<D>> looks("windows", count);
  const Array<Sum<D>> sums("seen in windows", count);
  const auto host = Kokkos::create_mirror_view(looks);
  for (std::size_t g = 0; g < state.groups.size(); ++g) {
    Group<G>& group = *state.groups[g];
    if (group.fluid() != fluid) continue;
    bool any = false;
    for (std::size_t k = 0; k < count; ++k) {
      for (int d = 0; d < D; ++d) host(k).place[d] = windows[k].place[d];
      host(k).radius = windows[k].radius;
      host(k).looks = counts(state, g, windows[k], fluid);
      any = any || host(k).looks;
    }
    if (!any) continue;
    Kokkos::deep_copy(looks, host);
    state.sleep.for_all(group, [&] { look(group, state.grid, looks, sums); });
  }
  const auto seen = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), sums);
  return {seen.data(), seen.data() + count};
}

}  // namespace

template <class G>
std::vector<Seen> probe(const State<G>& state, const std::vector<Window>& windows) {
  const auto fluids = sums_over(state, windows, true), solids = sums_over(state, windows, false);
  std::vector<Seen> all(windows.size());
  for (std::size_t k = 0; k < windows.size(); ++k) {
    const auto& sum = fluids[k].points > 0 ? fluids[k] : solids[k];
    if (sum.points == 0) continue;
    all[k].points = sum.points;
    all[k].pressure = sum.pressure / sum.volume;
    for (int d = 0; d < G::dim; ++d) all[k].velocity[d] = sum.momentum[d] / sum.mass;
  }
  return all;
}

template <class G>
void Riders<G>::carry(const State<G>& state, double dt, std::vector<Window>& windows) {
  const auto of_group = [&](const Window& w) {
    if (w.material >= 0) return static_cast<std::size_t>(w.material);
    std::size_t g = 0;
    while (g < state.groups.size() && !state.groups[g]->fluid()) ++g;
    return g < state.groups.size() ? g : 0;
  };
  for (std::size_t g = 0; g < state.groups.size(); ++g) {
    std::vector<int> riders;
    for (std::size_t k = 0; k < windows.size(); ++k)
      if (windows[k].rides && of_group(windows[k]) == g) riders.push_back(static_cast<int>(k));
    if (!riders.empty()) carry_with(*state.groups[g], state, dt, windows, riders);
  }
}

template <class G>
void Riders<G>::carry_with(const Group<G>& group, const State<G>& state, double dt,
                           std::vector<Window>& windows, const std::vector<int>& riders) {
  const Transfer<G>& transfer = *group.transfer;
  const Lattice<D>& lattice = state.grid.lattice;
  const int count = static_cast<int>(riders.size());
  if (points_.capacity() < count) points_ = Particles<G>(static_cast<int>(windows.size()), {});
  points_.count = count;
  const auto place = Kokkos::create_mirror(points_.position);  // which the sort moves
  const auto id = Kokkos::create_mirror(points_.id);
  for (int q = 0; q < count; ++q) {
    id(q) = riders[q];
    for (int d = 0; d < D; ++d) place(q, d) = windows[riders[q]].place[d];
  }
  Kokkos::deep_copy(points_.position, place);
  Kokkos::deep_copy(points_.id, id);
  sorter_.sort(points_, transfer, lattice);

  // Particles move with the mean of the grid's velocities before and after, or with those after
  // (A.9).
  const double before = state.scheme.midpoint ? 0.5 : 0;
  Sweep<D> sweep(lattice);
  for (int d = 0; d < D; ++d) {
    const Entry v{points_.velocity, d};
    transfer.gather_scalar(sweep, points_, {{state.grid.before, d}, v, 0, before});
    transfer.gather_scalar(sweep, points_, {{state.grid.after, d}, v, 1, 1 - before});
  }
  sweep.run();
  const Particles<G> points = points_;
  const Ends<D> ends(lattice, state.grid.boundaries);
  Kokkos::parallel_for(
      "ride", Kokkos::RangePolicy<Space>(0, points.count), KOKKOS_LAMBDA(const int p) {
        for (int d = 0; d < D; ++d)
          points.position(p, d) =
              ends.settle(d, points.position(p, d) + dt * points.velocity(p, d));
      });
  Kokkos::deep_copy(place, points_.position);
  Kokkos::deep_copy(id, points_.id);
  for (int q = 0; q < points_.count; ++q)
    for (int d = 0; d < D; ++d) windows[id(q)].place[d] = place(q, d);
}

#define BRISANCE_PROBE(G)                                                           \
  template std::vector<Seen> probe<G>(const State<G>&, const std::vector<Window>&); \
  template class Riders<G>;
BRISANCE_PROBE(Line)
BRISANCE_PROBE(PlaneStrain)
#undef BRISANCE_PROBE

}  // namespace brisance
