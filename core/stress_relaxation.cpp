#include "core/stress_relaxation.hpp"

#include "core/geometry.hpp"

namespace brisance {
namespace {

/// scratch <- scratch - S scratch, after what the sweep has to do before; the end of it is left to
/// the sweep.
template <class G>
void remove_means(Sweep<G::dim>& in, Group<G>& group, const Grid<G>& grid, Accumulator& means) {
  const auto values = group.particles.scratch;
  in.clear(means, 4);
  group.transfer->scatter_means(in, group.particles, values, means);
  in.run();
  means.contribute();
  fold(means.total, 0, 4, grid.lattice, grid.boundaries);
  const auto total = means.total;
  Kokkos::parallel_for(
      "nodal means", Kokkos::RangePolicy<Space>(0, grid.lattice.size), KOKKOS_LAMBDA(const int n) {
        const double weight = total(n, 3);
        for (int k = 0; k < 3; ++k) total(n, k) = weight > 0 ? total(n, k) / weight : 0;
      });
  fill(total, 0, 3, grid.lattice, grid.boundaries);
  group.transfer->subtract_means(in, group.particles, total, values);
}

}  // namespace

template <class G>
void relax_stress(std::vector<std::unique_ptr<Group<G>>>& groups, const Grid<G>& grid,
                  Accumulator& means, double dt) {
  for (auto& group : groups) {
    if (group->fluid() || !(group->scheme.stress_relaxation > 0)) continue;
    Sweep<G::dim> sweep(grid.lattice);
    group->load_stress(sweep);
    remove_means(sweep, *group, grid, means);
    sweep.run();  // before the means are made anew
    remove_means(sweep, *group, grid, means);
    group->relax_stress(sweep, dt);
    sweep.run();
  }
}

template void relax_stress<Line>(std::vector<std::unique_ptr<Group<Line>>>&, const Grid<Line>&,
                                 Accumulator&, double);
template void relax_stress<PlaneStrain>(std::vector<std::unique_ptr<Group<PlaneStrain>>>&,
                                        const Grid<PlaneStrain>&, Accumulator&, double);

}  // namespace brisance
