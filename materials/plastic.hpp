#pragma once
// What laws of elastic-plastic solids have in common: their state variables and where the work
// goes.
#include "materials/solid.hpp"

namespace brisance {

struct Plastic : Solid {
  struct History {
    double energy = 0;
    double plastic_strain = 0;  ///< sum of sqrt(2/3 de : de) of the plastic deviator
    double plastic_work = 0;
  };
  static constexpr int field_count = 3;
  static constexpr Field<History> fields[field_count] = {
      {"energy", "J/kg", &History::energy},
      {"plastic strain", "-", &History::plastic_strain},
      {"plastic work", "J/kg", &History::plastic_work}};

  using Solid::Solid;

  KOKKOS_INLINE_FUNCTION History initial(double, double, bool) const { return {}; }

  KOKKOS_INLINE_FUNCTION Energies energies(const Sym3& sigma, double rho, const History& h) const {
    Energies e;
    e.elastic = intact.energy(sigma) / rho;
    e.plastic = h.plastic_work;
    return e;
  }
};

/// Work per volume on the plastic strain C^-1 : excess, excess being what a return took off the
/// trial stress, by the mean of the stresses before and after the step: what is missing of that
/// mean : de after the elastic energy has been paid, to the last digit. Zero instead where a step
/// is so long that it crosses the yield surface and the mean says nothing. [J/m^3]
KOKKOS_INLINE_FUNCTION double plastic_work(const Isotropic& moduli, const Sym3& mean,
                                           const Sym3& excess) {
  return most(moduli.work(mean, excess), 0);
}

}  // namespace brisance
