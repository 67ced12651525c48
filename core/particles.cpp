#include "core/particles.hpp"

#include <algorithm>

#include "core/geometry.hpp"

namespace brisance {

template <class G>
Particles<G>::Particles(int capacity, const ColumnNeeds& needs)
    : position("position", capacity, D),
      velocity("velocity", capacity, D),
      gradient("gradient", capacity, D * D),
      mass("mass", capacity, 1),
      volume("volume", capacity, 1),
      stress("stress", capacity, needs.stress == Stress::pressure ? 1 : G::stress_components),
      history("history", capacity, needs.history),
      acting(stress),
      acts_apart(needs.half_stress),
      id("id", capacity),
      bin("bin", capacity) {
  if (acts_apart) acting = Table<double>("half stress", capacity, stress.extent(1));
  if (needs.affine) affine = Table<double>("affine", capacity, D * D);
  if (needs.work) work = Table<double>("work", capacity, 1);
  if (needs.extent) extent = Table<double>("extent", capacity, D);
  if (needs.relaxation) scratch = Table<double>("scratch", capacity, 2);
  if (needs.stress_relaxation) scratch = Table<double>("scratch", capacity, 4);
}

template <class G>
void Particles<G>::reserve(int needed) {
  if (needed <= capacity()) return;
  const int room = std::max(needed, capacity() + capacity() / 4);
  each_column([&](const char*, Table<double>& c, bool) { Kokkos::resize(c, room, c.extent(1)); });
  if (!acts_apart) acting = stress;
  Kokkos::resize(id, room);
  Kokkos::resize(bin, room);
}

template struct Particles<Line>;
template struct Particles<PlaneStrain>;

}  // namespace brisance
