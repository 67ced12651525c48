#pragma once
// Damage of brittle solids in tension, from microcracks that grow with the volumetric strain:
// Taylor, Chen & Kuszmaul (1986), and the loss of ellipticity that ends it: Rudnicki & Rice (1975).
#include "materials/isotropic.hpp"

namespace brisance {

struct TensileDamage {
  double nu = 0;      ///< Poisson's ratio of sound matter [-]
  Isotropic intact;   ///< its moduli
  double growth = 0;  ///< (5/2) k (K_IC / (rho C))^2, C = sqrt(E / rho) [1/s^2]
  double m = 6;       ///< exponent of the flaw density, N = k eps_v^m [-]

  /// E [Pa], rho [kg/m^3], toughness K_IC [Pa m^0.5], flaws k [1/m^3].
  TensileDamage(double E, double nu_, double rho, double toughness, double flaws, double m_)
      : nu(nu_),
        intact(Isotropic::from_young(E, nu_)),
        growth(2.5 * flaws * toughness * toughness / (rho * E)),
        m(m_) {}

  /// Matter with a crack density Cd: secant moduli, D = 1 - K/K0, and derivatives with Cd.
  template <class T>
  struct StateOf {
    IsotropicOf<T> moduli;
    T D = 0;
    T dK = 0, dG = 0;  ///< [Pa]
  };
  using State = StateOf<double>;

  /// Cd over the m-th power of the volumetric strain, fragments being sized by the largest rate of
  /// it [1/s].
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T density_at(const T& rate) const {
    return growth / square(rate);
  }
  /// Cd at a volumetric strain [-], the rate as above.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T crack_density(const T& volume_strain, const T& rate) const {
    return density_at(rate) * raised(volume_strain, m);
  }

  /// At Cd = 9/16 nothing is left. The shear modulus is that of isotropy with the damaged K and nu.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION StateOf<T> at(const T& Cd) const {
    constexpr double c = 16. / 9;
    const auto holds = c * Cd < T(1);
    const T nu_d = nu * (1 - c * Cd), left = 1 - 2 * nu_d, right = 1 + nu_d,
            per_both = 1 / (left * right), per_left = per_both * right, per_shape = per_both * left,
            f = (1 - square(nu_d)) * per_left;
    const double nu_slope = -c * nu;
    const T f_slope = 2 * nu_slope * (f - nu_d) * per_left, shape = left * per_shape,
            shape_slope = -3 * nu_slope * square(per_shape);
    StateOf<T> s;
    s.D = select(holds, c * f * Cd, T(1));
    s.moduli.K = (1 - s.D) * intact.K;
    s.moduli.G = 1.5 * s.moduli.K * shape;
    s.moduli.per_K = 1 / select(holds, s.moduli.K, T(intact.K));
    s.moduli.per_G = (2. / 3) * s.moduli.per_K * right * per_left;
    s.dK = select(holds, -c * intact.K * (f + f_slope * Cd), T(0));
    s.dG = 1.5 * (s.dK * shape + s.moduli.K * shape_slope);
    return s;
  }

  /// While damage grows at a fixed rate, d(stress) = C : d(strain) + this tr(d(strain)): the secant
  /// stiffness C and what softens it. [Pa]
  KOKKOS_INLINE_FUNCTION Sym3 softening(const State& s, double Cd, const Sym3& strain) const {
    const double per_volume = m * Cd / trace(strain);
    const Isotropic slope{s.dK, s.dG, 0, 0};
    return added({}, per_volume, slope.stress(strain));
  }

  /// det Q(n) = G^2 g(n) for the acoustic tensor Q of that tangent; this is g along a principal
  /// direction whose share of the volumetric strain is r. As dG < 0 it is least along the major
  /// one. Where it is not positive, strain can localise across n. [Pa]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T localisation(const StateOf<T>& s, const T& Cd, const T& r) const {
    return s.moduli.constrained() + m * Cd * (s.dK + 2 * s.dG * (r - 1. / 3));
  }
};

}  // namespace brisance
