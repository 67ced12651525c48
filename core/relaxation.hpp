#pragma once
// Corrections of fluids whose pressure depends on energy, after a step, each exact in mass,
// momentum and energy:
// - volume: volumes that no longer add up to the space drift back to it;
// - pressure: differences in pressure that no node can see (null-space noise) even out by exchange
// of volume;
// - heat: compressing particles share their internal energy, which heals wall heating.
// All are local means over nodes, S f = sum N w f / sum N w, gathered back with N.
#include <memory>
#include <vector>

#include "core/group.hpp"

namespace brisance {

struct RelaxationRates {
  double volume = 0;    ///< share of the volume error removed in a step [-]
  double pressure = 0;  ///< rate in units of sound speed per cell [-]
  double heat = 0;      ///< rate in units of the compression rate [-]
  bool any() const { return volume > 0 || pressure > 0 || heat > 0; }
};

/// What both accumulators have room for.
constexpr int relaxation_columns = 4;
/// The fullness of nodes whose surroundings are not full: any share of it tells.
constexpr double not_full = 1e30;

/// Of the two accumulators one is read while the other is written. `asleep`: volume at the nodes of
/// gas that sleeps, if any does. [m^D]
template <class G>
void relax(std::vector<std::unique_ptr<Group<G>>>& groups, const Grid<G>& grid, Accumulator& sums,
           Accumulator& spare, const RelaxationRates& rates, double dt,
           const Table<double>& asleep = {});

}  // namespace brisance
