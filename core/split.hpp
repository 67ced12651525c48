#pragma once
// Numerical fracture of a gas: particles that expansion has drawn further apart than a cell leave
// empty cells behind.
#include "core/boundary.hpp"
#include "core/particles.hpp"
#include "core/schedule.hpp"

namespace brisance {

/// Each row's value <- the greatest length of its particles, if that is more. [m]
template <class G>
void find_longest(Sweep<G::dim>& in, const Particles<G>& particles, const Array<double>& of_rows);

/// The greatest of the lengths of rows, which are 0 afterwards. [m]
double take_longest(const Array<double>& of_rows);

/// Cuts each particle in two along every direction in which it is longer than `length` cells. The
/// parts share its mass and volume and copy all that is intensive, so mass, momentum and energy are
/// exact. New particles get ids from `next_id` on. Returns how many were added.
template <class G>
int split(Particles<G>& particles, const Lattice<G::dim>& lattice,
          const Boundaries<G::dim>& boundaries, double length, std::int64_t& next_id);

}  // namespace brisance
