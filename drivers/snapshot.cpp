#include "drivers/snapshot.hpp"

#include <algorithm>

#include "core/geometry.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

/// Appends the columns of one group after the other, with room made for all of them at once.
template <class G>
class Taker {
 public:
  static constexpr int D = G::dim;

  Taker(const State<G>& state, Snapshot& shot)
      : shot_(shot), t_(shot.table), all_(static_cast<std::size_t>(state.particles())) {
    shot.time = state.time;
    const Lattice<D>& lattice = state.grid.lattice;
    t_.dim = D;
    t_.cell_size = lattice.h;
    for (int d = 0; d < D; ++d) {
      t_.origin[d] = lattice.origin[d];
      t_.cells[d] = lattice.cells[d];
    }
    for (auto* column : {&t_.mass, &t_.volume, &t_.density, &t_.pressure, &t_.energy})
      column->reserve(all_);
    for (int d = 0; d < D; ++d) {
      place(d).reserve(all_);
      motion(d).reserve(all_);
    }
    t_.material.reserve(all_);
    shot.id.reserve(all_);
  }

  void add(const Group<G>& group, int material) {
    const Particles<G>& p = group.particles;
    const std::size_t before = shot_.id.size(), after = before + p.count;
    const Array<double> pressure(unset("pressure"), p.count), energy(unset("energy"), p.count);
    group.report(pressure, energy);
    for (int d = 0; d < D; ++d) {
      append(place(d), part(p.position, d), p.count);
      append(motion(d), part(p.velocity, d), p.count);
    }
    append(t_.mass, part(p.mass, 0), p.count);
    append(t_.volume, part(p.volume, 0), p.count);
    append(t_.pressure, pressure, p.count);
    append(t_.energy, energy, p.count);
    for (std::size_t k = before; k < after; ++k) t_.density.push_back(t_.mass[k] / t_.volume[k]);
    t_.material.resize(after, material);
    append(shot_.id, p.id, p.count);
    if (group.stress() == Stress::tensor) {
      const auto components = stress_names(G::stress_components);
      for (int k = 0; k < G::stress_components; ++k)
        append(field({components[k], "Pa"}, before), part(p.stress, k), p.count);
    }
    const auto names = group.history_fields();
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k].name != "energy")
        append(field(names[k], before), part(p.history, static_cast<int>(k)), p.count);
    for (auto& one : t_.fields) one.values.resize(after);
  }

 private:
  Snapshot& shot_;
  ParticleTable& t_;
  std::size_t all_;

  std::vector<double>& place(int d) { return d == 0 ? t_.x : d == 1 ? t_.y : t_.z; }
  std::vector<double>& motion(int d) { return d == 0 ? t_.vx : d == 1 ? t_.vy : t_.vz; }

  static auto unset(const char* name) {
    return Kokkos::view_alloc(std::string(name), Kokkos::WithoutInitializing);
  }
  static Array<double> part(const Table<double>& column, int k) {
    return Kokkos::subview(column, Kokkos::ALL, k);
  }

  template <class T>
  static void append(std::vector<T>& to, const Array<T>& from, int count) {
    const auto host = Kokkos::create_mirror_view_and_copy(
        Kokkos::HostSpace(), Kokkos::subview(from, Kokkos::make_pair(0, count)));
    to.insert(to.end(), host.data(), host.data() + count);
  }

  /// Of the groups before, those without it have 0.
  std::vector<double>& field(const FieldName& named, std::size_t before) {
    const auto known = std::find_if(t_.fields.begin(), t_.fields.end(),
                                    [&](const auto& f) { return f.name == named.name; });
    if (known != t_.fields.end()) return known->values;
    t_.fields.push_back({named.name, named.unit, {}});
    auto& values = t_.fields.back().values;
    values.reserve(all_);
    values.resize(before);
    return values;
  }
};

}  // namespace

template <class G>
Snapshot snapshot_of(const State<G>& state) {
  Snapshot shot;
  Taker<G> taker(state, shot);
  for (std::size_t g = 0; g < state.groups.size(); ++g)
    state.sleep.for_all(*state.groups[g],
                        [&] { taker.add(*state.groups[g], static_cast<int>(g)); });
  return shot;
}

template Snapshot snapshot_of<Line>(const State<Line>&);
template Snapshot snapshot_of<PlaneStrain>(const State<PlaneStrain>&);

}  // namespace brisance
