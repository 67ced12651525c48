#pragma once
// What laws of elastic-plastic solids have in common: their state variables and where the work
// goes.
#include "materials/solid.hpp"

namespace brisance {

struct Plastic : Solid {
  template <class T>
  struct HistoryOf {
    T energy = 0;
    T plastic_strain = 0;  ///< sum of sqrt(2/3 de : de) of the plastic deviator
    T plastic_work = 0;
  };
  using History = HistoryOf<double>;
  static constexpr int field_count = 3, deciding = field_count;
  template <class T>
  static constexpr Field<HistoryOf<T>, T> fields_of[field_count] = {
      {"energy", "J/kg", &HistoryOf<T>::energy},
      {"plastic strain", "-", &HistoryOf<T>::plastic_strain},
      {"plastic work", "J/kg", &HistoryOf<T>::plastic_work}};
  static constexpr const auto& fields = fields_of<double>;

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
template <class M, class T>
KOKKOS_FORCEINLINE_FUNCTION T plastic_work(const IsotropicOf<M>& moduli, const SymOf<T>& mean,
                                           const SymOf<T>& excess) {
  return most(moduli.work(mean, excess), T(0));
}

}  // namespace brisance
