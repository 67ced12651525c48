#pragma once
// Bodies that cannot be meant: outside of the grid, thinner than their points are apart, over each
// other.
#include <vector>

#include "core/parameters.hpp"
#include "drivers/bodies.hpp"

namespace brisance {

/// Throws InputError for a body of a checked scene that has no part within the grid, that a free
/// or periodic end cuts, or that is solid and thinner than the distance of its points.
void check_extents(const List& scene);

/// Which bodies share places by mistake. The first that holds a place owns it, so that a charge is
/// put into a case by naming it first: then all of the first lies within the other. Two bodies of
/// unlike solids or explosives that share a part of either are not nested but drawn over each
/// other, unless the later says that it 'may overlap'. Fluids fill what is left and may reach
/// under anything; so do bodies without a shape, which hold all of the others.
class Overlaps {
 public:
  Overlaps(const List& scene, const Bodies& bodies);

  /// Takes note of a place and its owner.
  void add(int owner, const Place& x) {
    for (Pair& pair : of_[owner]) {
      if (pair.shared && pair.apart) continue;
      (bodies_.all()[pair.later].shape.holds(x) ? pair.shared : pair.apart) = true;
    }
  }

  /// Throws InputError if two bodies overlap.
  void check() const;

 private:
  struct Pair {
    int later;
    bool shared = false;  ///< some place of the earlier body lies within the later
    bool apart = false;   ///< and some does not
  };
  const List& lists_;
  const Bodies& bodies_;
  std::vector<std::vector<Pair>> of_;  ///< by the earlier body
};

}  // namespace brisance
