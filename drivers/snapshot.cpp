#include "drivers/snapshot.hpp"

#include <algorithm>
#include <utility>

#include "core/geometry.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

/// Puts the columns of one group behind those of the group before.
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
      column->resize(all_);
    for (int d = 0; d < D; ++d) {
      place(d).resize(all_);
      motion(d).resize(all_);
    }
    t_.material.resize(all_);
    shot.id.resize(all_);
    for (auto& field : t_.fields) field.values.resize(all_);
  }

  void add(const Group<G>& group, int material) {
    const Particles<G>& p = group.particles;
    end_ = begin_ + p.count;
    const Array<double> pressure(unset("pressure"), p.count), energy(unset("energy"), p.count);
    group.report(pressure, energy);
    for (int d = 0; d < D; ++d) {
      put(place(d), part(p.position, d));
      put(motion(d), part(p.velocity, d));
    }
    put(t_.mass, part(p.mass, 0));
    put(t_.volume, part(p.volume, 0));
    put(t_.pressure, pressure);
    put(t_.energy, energy);
    put(shot_.id, p.id);
    for (std::size_t k = begin_; k < end_; ++k) {
      t_.density[k] = t_.mass[k] / t_.volume[k];
      t_.material[k] = material;
    }
    add_fields(fields_of(group));
    begin_ = end_;
  }

 private:
  using Fields = std::vector<std::pair<FieldName, Array<double>>>;

  Snapshot& shot_;
  ParticleTable& t_;
  std::size_t all_, begin_ = 0, end_ = 0;

  std::vector<double>& place(int d) { return d == 0 ? t_.x : d == 1 ? t_.y : t_.z; }
  std::vector<double>& motion(int d) { return d == 0 ? t_.vx : d == 1 ? t_.vy : t_.vz; }

  static auto unset(const char* name) {
    return Kokkos::view_alloc(std::string(name), Kokkos::WithoutInitializing);
  }
  static Array<double> part(const Table<double>& column, int k) {
    return Kokkos::subview(column, Kokkos::ALL, k);
  }

  template <class T>
  void put(std::vector<T>& to, const Array<T>& from) {
    using Host = Kokkos::View<T*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
    const std::size_t count = end_ - begin_;
    Kokkos::deep_copy(Host(to.data() + begin_, count),
                      Kokkos::subview(from, Kokkos::make_pair(std::size_t{0}, count)));
  }

  static Fields fields_of(const Group<G>& group) {
    const Particles<G>& p = group.particles;
    Fields fields;
    if (group.stress() == Stress::tensor) {
      const auto components = stress_names(G::stress_components);
      for (int k = 0; k < G::stress_components; ++k)
        fields.push_back({{components[k], "Pa"}, part(p.stress, k)});
    }
    const auto names = group.history_fields();
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k].name != "energy")
        fields.push_back({names[k], part(p.history, static_cast<int>(k))});
    return fields;
  }

  /// A group without a field has 0.
  void add_fields(const Fields& own) {
    for (const auto& field : own)
      if (!t_.field(field.first.name))
        t_.fields.push_back({field.first.name, field.first.unit, std::vector<double>(all_)});
    for (auto& field : t_.fields) {
      const auto found = std::find_if(own.begin(), own.end(),
                                      [&](const auto& f) { return f.first.name == field.name; });
      if (found != own.end())
        put(field.values, found->second);
      else
        std::fill(field.values.begin() + begin_, field.values.begin() + end_, 0.0);
    }
  }
};

}  // namespace

template <class G>
Snapshot snapshot_of(const State<G>& state, Snapshot shot) {
  Taker<G> taker(state, shot);
  for (std::size_t g = 0; g < state.groups.size(); ++g)
    state.sleep.for_all(*state.groups[g],
                        [&] { taker.add(*state.groups[g], static_cast<int>(g)); });
  return shot;
}

template Snapshot snapshot_of<Line>(const State<Line>&, Snapshot);
template Snapshot snapshot_of<PlaneStrain>(const State<PlaneStrain>&, Snapshot);

}  // namespace brisance
