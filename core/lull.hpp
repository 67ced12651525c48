#pragma once
// Which cells may sleep at the start: those in the midst of gas that is uniform and at rest.
#include <memory>
#include <vector>

#include "core/group.hpp"

namespace brisance {

/// Of each cell of the lattice, on the host.
struct Rest {
  std::vector<int> owner;  ///< the group that fills it, uniform and at rest; else -1
  std::vector<double> pressure, density;
  std::vector<int> sleeps;  ///< 1: so are all cells within the margin, with the same state
};

template <class G>
Rest find_rest(const std::vector<std::unique_ptr<Group<G>>>& groups, const std::vector<bool>& may,
               const Grid<G>& grid, double split_length, int margin);

}  // namespace brisance
