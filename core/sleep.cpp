#include "core/sleep.hpp"

#include <algorithm>

#include "core/geometry.hpp"
#include "core/lull.hpp"
#include "core/sum.hpp"

namespace brisance {
namespace {

template <class To, class From>
To on_device(const std::string& name, const std::vector<From>& values) {
  const To view(name, values.size());
  const auto host = Kokkos::create_mirror_view(view);
  for (std::size_t k = 0; k < values.size(); ++k) host(k) = values[k];
  Kokkos::deep_copy(view, host);
  return view;
}

/// to(place(p)) <- from(p) where there is a place, in all columns that hold state.
template <class G>
void copy_rows(Particles<G>& from, Particles<G>& to, const Array<int>& place) {
  const Kokkos::RangePolicy<Space> over(0, from.count);
  std::vector<Table<double>> targets;
  to.each_column([&](const char*, Table<double>& column, bool carried) {
    if (carried) targets.push_back(column);
  });
  std::size_t k = 0;
  from.each_column([&](const char*, Table<double>& column, bool carried) {
    if (!carried) return;
    const Table<double> source = column, target = targets[k++];
    const int columns = static_cast<int>(column.extent(1));
    Kokkos::parallel_for(
        "copy sleepers", over, KOKKOS_LAMBDA(const int p) {
          if (place(p) < 0) return;
          for (int c = 0; c < columns; ++c) target(place(p), c) = source(p, c);
        });
  });
  const auto source = from.id, target = to.id;
  Kokkos::parallel_for(
      "copy ids of sleepers", over, KOKKOS_LAMBDA(const int p) {
        if (place(p) >= 0) target(place(p)) = source(p);
      });
}

/// Whether a point is as its cell was at the start.
template <class G>
struct Watch {
  Particles<G> points;
  Array<int> owner;
  Table<double> rest;
  int group;

  KOKKOS_INLINE_FUNCTION bool at_rest(int p, int cell) const {
    if (owner(cell) != group) return false;
    const Vec<G::dim> v = points.v(p);
    const double pressure = rest(cell, 0);
    return fabs(points.stress(p, 0) - pressure) <= Sleep<G>::tolerance * pressure &&
           dot(v, v) <= square(Sleep<G>::tolerance) * rest(cell, 1);
  }
};

/// Ends the sleep of the cells within the margin of one; returns of how many.
template <int D>
KOKKOS_INLINE_FUNCTION int wake_around(int cell, int margin, const Lattice<D>& lattice,
                                       const Array<int>& asleep) {
  int i[D], woken = 0;
  lattice.coordinates(cell, i);
  const int width = 2 * margin + 1;
  for (int k = 0; k < power(width, D); ++k) {
    int neighbour = cell;
    bool inside = true;
    for (int d = 0; d < D; ++d) {
      const int step = k / power(width, d) % width - margin;
      neighbour += step * lattice.stride[d];
      inside = inside && i[d] + step >= 0 && i[d] + step < lattice.cells[d];
    }
    if (inside) woken += Kokkos::atomic_exchange(&asleep(neighbour), 0);
  }
  return woken;
}

}  // namespace

template <class G>
long Sleep<G>::count() const {
  long sum = 0;
  for (const Part& part : parts_) sum += part.points.count;
  return sum;
}

template <class G>
long Sleep<G>::count(const Group<G>& group) const {
  for (const Part& part : parts_)
    if (part.group == &group) return part.points.count;
  return 0;
}

template <class G>
std::size_t Sleep<G>::bytes() const {
  return (asleep_.span() + disturbed_.span() + fresh_.span() + owner_.span()) * sizeof(int) +
         (rest_.span() + force_.span() + volume_.span()) * sizeof(double);
}

template <class G>
void Sleep<G>::lull(const Groups& groups, const std::vector<bool>& may, const Grid<G>& grid,
                    double split_length, Sorter<G>& sorter) {
  lattice_ = grid.lattice;
  const Rest rest = find_rest(groups, may, grid, split_length, margin);
  asleep_ = on_device<Array<int>>("cells asleep", rest.sleeps);
  owner_ = on_device<Array<int>>("owners of cells at rest", rest.owner);
  disturbed_ = Array<int>("cells disturbed", lattice_.size);
  fresh_ = Array<int>("cells disturbed of late", lattice_.size);
  rest_ = Table<double>("cells at rest", lattice_.size, 2);
  const auto host = Kokkos::create_mirror_view(rest_);
  for (int c = 0; c < lattice_.size; ++c) {
    host(c, 0) = rest.pressure[c];
    host(c, 1) = rest.owner[c] < 0 ? 0 : rest.pressure[c] / rest.density[c];
  }
  Kokkos::deep_copy(rest_, host);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!may[g]) continue;
    Group<G>& group = *groups[g];
    Part part{&group, group.particles.none(), {}};
    move(group.particles, part.points, group, 1, sorter);
    sorter.sort(part.points, *group.transfer, lattice_);
    parts_.push_back(part);
  }
  force_ = Table<double>("force of sleepers", lattice_.size, D);
  volume_ = Table<double>("volume of sleepers", lattice_.size, 1);
  settle();
}

template <class G>
void Sleep<G>::wake(const Groups& groups, Sorter<G>& sorter) {
  if (!any()) return;
  int disturbed = 0;
  for (std::size_t g = 0; g < groups.size(); ++g)
    disturbed += disturb(groups[g]->particles, static_cast<int>(g));
  if (disturbed == 0 || wake_cells() == 0) return;
  for (Part& part : parts_) {
    Particles<G>& awake = part.group->particles;
    if (move(part.points, awake, *part.group, 0, sorter) == 0) continue;
    sorter.sort(awake, *part.group->transfer, lattice_);
    const Signals fastest = part.group->signals();  // of those that were awake
    part.group->set_signals(lattice_, {std::max(fastest.over_grid, part.signals.over_grid),
                                       std::max(fastest.in_matter, part.signals.in_matter)});
  }
  settle();
}

template <class G>
void Sleep<G>::resume(const Vec<D>& impulse, Sorter<G>& sorter) {
  impulse_ = impulse;
  for (Part& part : parts_) sorter.sort(part.points, *part.group->transfer, lattice_);
  settle();
}

/// Marks the cells where points are not at rest that were not known to be disturbed. Returns how
/// many they are.
template <class G>
int Sleep<G>::disturb(const Particles<G>& points, int group) {
  int found = 0;
  const Watch<G> watch{points, owner_, rest_, group};
  const auto disturbed = disturbed_, fresh = fresh_;
  const Lattice<D> lattice = lattice_;
  Kokkos::parallel_reduce(
      "watch for sleepers", Kokkos::RangePolicy<Space>(0, points.count),
      KOKKOS_LAMBDA(const int p, int& sum) {
        const int c = lattice.cell_of(points.x(p));
        if (disturbed(c) == 0 && !watch.at_rest(p, c))
          sum += 1 - Kokkos::atomic_exchange(&fresh(c), 1);
      },
      found);
  return found;
}

/// Returns how many wake.
template <class G>
int Sleep<G>::wake_cells() {
  int woken = 0;
  const auto disturbed = disturbed_, fresh = fresh_, asleep = asleep_;
  const Lattice<D> lattice = lattice_;
  Kokkos::parallel_reduce(
      "wake cells", Kokkos::RangePolicy<Space>(0, lattice.size),
      KOKKOS_LAMBDA(const int c, int& sum) {
        if (fresh(c) == 0) return;
        fresh(c) = 0;
        disturbed(c) = 1;
        sum += wake_around(c, margin, lattice, asleep);
      },
      woken);
  return woken;
}

/// Moves the points in cells that sleep (1) or do not (0) behind those of `to`, in their order.
template <class G>
int Sleep<G>::move(Particles<G>& from, Particles<G>& to, const Group<G>& group, int asleep,
                   Sorter<G>& sorter) const {
  const Kokkos::RangePolicy<Space> over(0, from.count);
  const Array<int> place("places of sleepers", from.count);
  const Particles<G> points = from;
  const auto sleeps = asleep_;
  const Lattice<D> lattice = lattice_;
  const int begin = to.count;
  int moved = 0;
  Kokkos::parallel_scan(
      "place sleepers", over,
      KOKKOS_LAMBDA(const int p, int& sum, bool last) {
        const bool goes = sleeps(lattice.cell_of(points.x(p))) == asleep;
        if (last) place(p) = goes ? begin + sum : -1;
        sum += goes;
      },
      moved);
  if (moved == 0) return 0;
  to.reserve(begin + moved);
  copy_rows(from, to, place);
  to.count += moved;
  // Out of the domain: the sort puts them behind the rest and counts them out.
  Kokkos::parallel_for(
      "leave", over, KOKKOS_LAMBDA(const int p) {
        if (place(p) >= 0) points.position(p, 0) = lattice.origin[0] - lattice.h;
      });
  sorter.sort(from, *group.transfer, lattice_);
  return moved;
}

template <class G>
Signals Sleep<G>::signals_of(Group<G>& group) const {
  const Signals awake = group.signals();
  Sweep<D> sweep(lattice_);
  group.find_signals(sweep);
  sweep.run();
  const Signals asleep = group.signals();
  group.set_signals(lattice_, awake);
  return asleep;
}

/// What those that still sleep are to others.
template <class G>
void Sleep<G>::settle() {
  for (Part& part : parts_) in_place(part, [&] { part.signals = signals_of(*part.group); });
  const auto asleep = asleep_;
  const auto rest = rest_, force = force_, volume = volume_;
  const Lattice<D> lattice = lattice_;
  const double corner = lattice.cell_volume() / power(2, D);
  Kokkos::parallel_for(
      "settle", Kokkos::RangePolicy<Space>(0, lattice.size), KOKKOS_LAMBDA(const int n) {
        int i[D];
        lattice.coordinates(n, i);
        for (int d = 0; d < D; ++d) force(n, d) = 0;
        volume(n, 0) = 0;
        for (int k = 0; k < power(2, D); ++k) {
          int cell = n;
          bool inside = true;
          for (int d = 0; d < D; ++d) {
            const int below = k >> d & 1;
            cell -= below * lattice.stride[d];
            inside = inside && i[d] - below >= 0 && i[d] - below < lattice.cells[d];
          }
          if (!inside || asleep(cell) == 0) continue;
          volume(n, 0) += corner;
          // -V sigma . grad N at the centre of the cell: 1 / h for D = 1, half as much for 2, ...
          const double push = 2 * corner * rest(cell, 0) / lattice.h;
          for (int d = 0; d < D; ++d) force(n, d) += k >> d & 1 ? push : -push;
        }
      });
}

template <class G>
void Sleep<G>::press(const Accumulator& sums) const {
  const auto total = sums.total, force = force_, volume = volume_;
  Kokkos::parallel_for(
      "press of sleepers", Kokkos::RangePolicy<Space>(0, lattice_.size),
      KOKKOS_LAMBDA(const int n) {
        if (!(volume(n, 0) > 0)) return;
        for (int d = 0; d < D; ++d) total(n, d) += force(n, d);
      });
}

template <class G>
void Sleep<G>::fill(const Accumulator& sums) const {
  const auto total = sums.total;
  const auto asleep = asleep_;
  const double full = lattice_.cell_volume();
  Kokkos::parallel_for(
      "fill of sleepers", Kokkos::RangePolicy<Space>(0, lattice_.size), KOKKOS_LAMBDA(const int c) {
        if (asleep(c) != 0) total(c, D) += full;
      });
}

template <class G>
Vec<Sleep<G>::D> Sleep<G>::hold(const Table<double>& sums) const {
  const auto volume = volume_;
  Vec<D> held;
  for (int d = 0; d < D; ++d)
    held[d] = sum_in_order(
        "hold sleepers", lattice_.size, KOKKOS_LAMBDA(const int n) {
          if (!(volume(n, 0) > 0)) return 0.;
          const double here = sums(n, d);
          sums(n, d) = 0;
          return here;
        });
  return held;
}

template <class G>
Signals Sleep<G>::signals(const Group<G>& group) const {
  for (const Part& part : parts_)
    if (part.group == &group) return part.signals;
  return {};
}

template class Sleep<Line>;
template class Sleep<PlaneStrain>;

}  // namespace brisance
