#pragma once
// The geometry policies: how many directions the grid resolves, and what a point's velocity
// gradient means in the three dimensions in which every material law works.
#include "core/types.hpp"

namespace brisance {

/// One direction, truly: a slab of unit area, nothing moves across.
struct Line {
  static constexpr const char* name = "line";
  static constexpr int dim = 1;
};

/// Two directions, unit thickness, no motion and no strain along the third.
struct PlaneStrain {
  static constexpr const char* name = "plane strain";
  static constexpr int dim = 2;
};

/// The rate of deformation sym(L) in three dimensions; directions that the grid does not resolve do
/// not strain. [1/s]
template <class G>
KOKKOS_INLINE_FUNCTION Sym3 strain_rate(const Mat<G::dim>& gradient) {
  Sym3 rate;
  for (int i = 0; i < G::dim; ++i)
    for (int j = i; j < G::dim; ++j) rate[Sym3::at(i, j)] = 0.5 * (gradient(i, j) + gradient(j, i));
  return rate;
}

}  // namespace brisance
