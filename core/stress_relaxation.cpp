#include "core/stress_relaxation.hpp"

#include "core/geometry.hpp"

namespace brisance {
namespace {

/// scratch <- scratch - S scratch.
template <class G>
void remove_means(Group<G>& group, const Grid<G>& grid, Accumulator& means) {
  const auto values = group.particles.scratch;
  means.clear();
  group.transfer->scatter_means(group.particles, grid.lattice, values, means);
  means.contribute();
  fold(means.total, 0, 4, grid.lattice, grid.boundaries);
  const auto total = means.total;
  Kokkos::parallel_for(
      "nodal means", Kokkos::RangePolicy<Space>(0, grid.lattice.size), KOKKOS_LAMBDA(const int n) {
        const double weight = total(n, 3);
        for (int k = 0; k < 3; ++k) total(n, k) = weight > 0 ? total(n, k) / weight : 0;
      });
  fill(total, 0, 3, grid.lattice, grid.boundaries);
  group.transfer->subtract_means(group.particles, grid.lattice, total, values);
}

}  // namespace

template <class G>
void relax_stress(std::vector<std::unique_ptr<Group<G>>>& groups, const Grid<G>& grid,
                  Accumulator& means, double dt) {
  for (auto& group : groups) {
    if (group->fluid() || !(group->scheme.stress_relaxation > 0)) continue;
    group->load_stress();
    remove_means(*group, grid, means);
    remove_means(*group, grid, means);
    group->relax_stress(dt, grid.lattice.h);
  }
}

template void relax_stress<Line>(std::vector<std::unique_ptr<Group<Line>>>&, const Grid<Line>&,
                                 Accumulator&, double);
template void relax_stress<PlaneStrain>(std::vector<std::unique_ptr<Group<PlaneStrain>>>&,
                                        const Grid<PlaneStrain>&, Accumulator&, double);

}  // namespace brisance
