#pragma once
// Periodic boxes of one material in plane strain, with 2 x 2 particles a cell, that drift at 0.3
// and 0.2 of the speed of sound, so that particles change their cells as those of real flows do.
#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <string>

#include "drivers/exact.hpp"
#include "perf/work.hpp"

namespace brisance::perf {

struct Box {
  List scene;                            ///< complete
  std::unique_ptr<ExactSolution> start;  ///< what it holds at time 0
  Work work = {};                        ///< of a particle-step; none where it is not counted
};

/// A vortex in a perfect gas, with the shape of the preset, or quadratic splines.
Box gas_box(const std::string& preset, bool quadratic, int cells);

/// Von Mises steel that vortices of 50 cells shear: for a thousand steps nearly all points yield.
/// Linear shapes and FLIP, or quadratic ones and MLS.
Box steel_box(bool quadratic, int cells);

/// Concrete under pressure with waves of 50 cells in it, whose tension breaks some tenth of its
/// points, and whose compression makes others yield at first.
Box concrete_box(bool quadratic, int cells);

}  // namespace brisance::perf
