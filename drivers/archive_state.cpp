#include "drivers/archive_state.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/geometry.hpp"

namespace brisance {
namespace {

void expect(bool right, const std::string& what) {
  if (!right) throw std::runtime_error("the checkpoint does not fit the scene: " + what);
}

/// The first `count` rows of a column, component after component as they lie in memory.
void keep_column(Archive& archive, const std::string& name, const Table<double>& column,
                 int count) {
  const std::size_t rows = count, components = column.extent(1);
  Archive::Doubles values;
  const auto part = [&](std::size_t k) {
    return Kokkos::subview(column, Kokkos::make_pair(std::size_t{0}, rows), k);
  };
  using Host = Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  if (!archive.reading()) {
    values.resize(rows * components);
    for (std::size_t k = 0; k < components; ++k)
      Kokkos::deep_copy(Host(values.data() + k * rows, rows), part(k));
  }
  archive.keep(name, values, components);
  if (!archive.reading()) return;
  expect(values.size() == rows * components, "size of '" + name + "'");
  for (std::size_t k = 0; k < components; ++k)
    Kokkos::deep_copy(part(k), Host(values.data() + k * rows, rows));
}

void keep_ids(Archive& archive, const Array<std::int64_t>& id, int count) {
  const auto part = Kokkos::subview(id, Kokkos::make_pair(0, count));
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), part);
  Archive::Integers ids(host.data(), host.data() + count);
  archive.keep("id", ids);
  if (!archive.reading()) return;
  expect(ids.size() == static_cast<std::size_t>(count), "number of ids");
  for (int p = 0; p < count; ++p) host(p) = ids[p];
  Kokkos::deep_copy(part, host);
}

template <class G>
void keep_particles(Archive& archive, Particles<G>& p) {
  archive.keep("count", p.count);
  expect(p.count >= 0, "number of particles");
  if (archive.reading()) p.reserve(p.count);
  keep_ids(archive, p.id, p.count);
  p.each_column([&](const char* name, Table<double>& column, bool carried) {
    if (carried) keep_column(archive, name, column, p.count);
  });
}

/// Found at the end of a step for the next.
template <class G>
void keep_signals(Archive& archive, Group<G>& group, const Lattice<G::dim>& lattice) {
  Signals fastest;
  if (!archive.reading()) fastest = group.signals();
  archive.keep("fastest over grid", fastest.over_grid);
  archive.keep("fastest in matter", fastest.in_matter);
  if (archive.reading()) group.set_signals(lattice, fastest);
}

template <class G>
void keep_vector(Archive& archive, const std::string& name, Vec<G::dim>& vector) {
  Archive::Doubles values(vector.a, vector.a + G::dim);
  archive.keep(name, values);
  expect(values.size() == G::dim, "number of directions");
  std::copy(values.begin(), values.end(), vector.a);
}

void keep_cells(Archive& archive, const std::string& name, const Array<int>& cells) {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), cells);
  Archive::Integers values(host.data(), host.data() + host.extent(0));
  archive.keep(name, values);
  expect(values.size() == host.extent(0), "number of cells");
  for (std::size_t c = 0; c < values.size(); ++c) host(c) = static_cast<int>(values[c]);
  Kokkos::deep_copy(cells, host);
}

template <class G>
void keep_sleep(Archive& archive, Sleep<G>& sleep, Sorter<G>& sorter) {
  const Archive::Part part(archive, "sleep");
  sleep.each_part([&](const Group<G>& group, Particles<G>& points) {
    const Archive::Part of_group(archive, "material " + group.label);
    keep_particles(archive, points);
  });
  keep_cells(archive, "cells asleep", sleep.asleep());
  keep_cells(archive, "cells disturbed", sleep.disturbed());
  Vec<G::dim> impulse = sleep.impulse();
  keep_vector<G>(archive, "impulse", impulse);
  if (archive.reading()) sleep.resume(impulse, sorter);
}

}  // namespace

void keep(Archive& archive, const std::string& name, Totals& t) {
  const Archive::Part part(archive, name);
  const std::pair<const char*, double*> numbers[] = {
      {"mass", &t.mass},
      {"momentum x", &t.momentum[0]},
      {"momentum y", &t.momentum[1]},
      {"momentum z", &t.momentum[2]},
      {"kinetic", &t.kinetic},
      {"internal", &t.internal},
      {"absolute momentum x", &t.absolute_momentum[0]},
      {"absolute momentum y", &t.absolute_momentum[1]},
      {"absolute momentum z", &t.absolute_momentum[2]},
      {"motion", &t.motion},
      {"elastic", &t.work.elastic},
      {"plastic", &t.work.plastic},
      {"damage", &t.work.damage},
      {"decohesion", &t.work.decohesion}};
  static_assert(sizeof(Totals) == sizeof numbers / sizeof numbers[0] * sizeof(double),
                "every number of the totals must be kept");
  for (const auto& [key, value] : numbers) archive.keep(key, *value);
}

template <class G>
void keep(Archive& archive, State<G>& state) {
  archive.keep("time", state.time);
  archive.keep("step", state.step);
  archive.keep("next id", state.next_id);
  archive.keep("left", state.left);
  keep(archive, "outflow", state.outflow);
  keep_vector<G>(archive, "wall impulse", state.wall_impulse);

  if (!state.springs.empty()) {
    Archive::Doubles displacements = state.springs.displacements();
    const std::size_t count = displacements.size();
    archive.keep("springs", displacements);
    expect(displacements.size() == count, "number of springs");
    state.springs.set_displacements(displacements);
  }
  if (state.debt.extent(0) > 0) {
    const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), state.debt);
    Archive::Doubles debt(host.data(), host.data() + host.extent(0));
    archive.keep("energy owed", debt);
    expect(debt.size() == host.extent(0), "number of nodes");
    std::copy(debt.begin(), debt.end(), host.data());
    Kokkos::deep_copy(state.debt, host);
  }
  for (auto& group : state.groups) {
    {
      const Archive::Part part(archive, "material " + group->label);
      long floors = group->floors();
      archive.keep("floors", floors);
      group->set_floors(floors);
      long in_motion = group->in_motion;
      archive.keep("in motion", in_motion);
      group->in_motion = in_motion != 0;
      keep_signals(archive, *group, state.grid.lattice);
      keep_particles(archive, group->particles);
    }
    // Particles are in the order of their bins already, which a stable sort keeps: this finds where
    // each bin begins.
    if (archive.reading())
      state.sorter.sort(group->particles, *group->transfer, state.grid.lattice);
  }
  if (state.sleep.on()) keep_sleep(archive, state.sleep, state.sorter);
}

template void keep<Line>(Archive&, State<Line>&);
template void keep<PlaneStrain>(Archive&, State<PlaneStrain>&);

}  // namespace brisance
