#pragma once
// Linear elasticity in rate form: sigma' = C : D, the method turns the stress with the matter.
#include "materials/solid.hpp"

namespace brisance {

struct Elastic : Solid {
  static constexpr const char* name = "elastic";

  template <class T>
  struct HistoryOf {
    T energy = 0;
  };
  using History = HistoryOf<double>;
  static constexpr int field_count = 1, deciding = field_count;
  template <class T>
  static constexpr Field<HistoryOf<T>, T> fields_of[field_count] = {
      {"energy", "J/kg", &HistoryOf<T>::energy}};
  static constexpr const auto& fields = fields_of<double>;

  using Solid::Solid;
  static Teuchos::ParameterList valid_parameters(const Teuchos::ParameterList& given);

  KOKKOS_INLINE_FUNCTION History initial(double, double, bool) const { return {}; }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION ResponseOf<T> update(const StrainOf<T>& in, const SymOf<T>& old,
                                                   HistoryOf<T>&) const {
    return {added(old, in.dt, intact.stress(in.rate)), speed(in.rho1)};
  }

  KOKKOS_INLINE_FUNCTION Energies energies(const Sym3& sigma, double rho, const History&) const {
    Energies e;
    e.elastic = intact.energy(sigma) / rho;
    return e;
  }
};

}  // namespace brisance
