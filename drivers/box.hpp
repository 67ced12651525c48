#pragma once
// Numbers of one table of particles in which a charge bursts in the middle of a square box. All are
// about `centre`, and also right for the quarter of a box whose centre is a corner of the grid.
#include <array>
#include <vector>

#include "drivers/measure.hpp"

namespace brisance {

/// Mean radial velocity of a material, by mass; nan without any. [m/s]
double outward_velocity(const ParticleTable& table, int material,
                        const std::array<double, 3>& centre);

/// Mass and radial momentum, spread linearly on a lattice about the centre (which no point can
/// leave by a round-off, as it can a cell), against their images under the symmetries of the
/// square: sum of differences over sum of both, the larger of the two. 0: all alike, 1: no two. In
/// a quarter only x <-> y is left.
double four_fold_asymmetry(const ParticleTable& table, const std::array<double, 3>& centre);

/// How far fluid has come into solids. The size of a point of fluid is no measure of place, since
/// gas expands manyfold: what counts is where its centre is.
struct Overlap {
  /// Of the fluid's mass, where solids fill more than nine tenths. Solid points are tents as wide
  /// on either side as their size, so that what they fill rises from 0 half a spacing outside of a
  /// regular face to 1 half a spacing inside: counted is what is deeper than 0.4 spacings.
  double share = 0;
  /// Greatest 1 - distance / (half the sum of sizes) of a point of fluid and one of a solid, the
  /// fluid's size no more than the solid's; 0 where none touch.
  double greatest = 0;
};
Overlap overlap_of(const ParticleTable& table, const std::vector<bool>& fluid);

/// Whether a point of one material is closer than `distance` to one of another. [m]
bool within(const ParticleTable& table, int material, int other, double distance);

/// Failure, 1 - (1 - damage)(1 - decohesion), of the four walls whose inner faces are `inner` from
/// the centre [m]. Fields that the wall does not have count as 0.
struct WallDamage {
  double near_middle = 0;  ///< share of failed mass within a quarter of a face of its middle
  double share = 0;        ///< of the wall's mass with a failure above 0.1
  /// (sum f)^2 / (n sum f^2) of the mean failures f along the faces, in n parts of a sixteenth of a
  /// face: 1 where all fail alike, 1 / n where one part does (an inverse participation ratio).
  double spread = 0;
  double length = 0;  ///< share of these parts in which some point has a failure above 0.1
};
/// Without any failure the first and the last are nan.
WallDamage wall_damage(const ParticleTable& table, int wall, const std::array<double, 3>& centre,
                       double inner);

}  // namespace brisance
