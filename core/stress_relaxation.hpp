#pragma once
// A correction of solids after a step: stress that no node feels, because the forces of the points
// around cancel, is never driven back by motion. It comes from points that cross cells beside a
// surface, and stays. With the local mean S f = sum N w f / sum N w, gathered back with N, it is
// r = (1 - S S+)^2 sigma; a share of r is taken away, its energy stays as heat. Direct stresses
// only: the mirror image of a shear stress at a wall has the other sign.
#include <memory>
#include <vector>

#include "core/group.hpp"

namespace brisance {

/// `means` has four columns for each node.
template <class G>
void relax_stress(std::vector<std::unique_ptr<Group<G>>>& groups, const Grid<G>& grid,
                  Accumulator& means, double dt);

}  // namespace brisance
