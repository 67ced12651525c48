#pragma once
// Concrete after Hu & Chen (2006), Fig. 10. Under tension: damage that grows with the volumetric
// strain and its rate, until the strain can localise; then the damage stays as it is and a plane
// across the major principal strain comes apart. Under pressure: the cone of Drucker and Prager.
// What decides is the sign of the trial mean stress.
#include "materials/decohesion.hpp"
#include "materials/drucker_prager_cone.hpp"
#include "materials/plastic.hpp"
#include "materials/tensile_damage.hpp"

namespace brisance {

struct Concrete : Solid {
  static constexpr const char* name = "concrete";
  static constexpr bool directed = true;

  template <class T>
  struct HistoryOf {
    T energy = 0;
    T crack_density = 0, damage = 0;
    T peak_rate = 0;  ///< largest rate of volume in tension so far
    T lambda = 0;     ///< share of decohesion
    T normal_x = 0, normal_y = 0;
    T strength = 0;           ///< of the plane in tension at onset; 0: there is none
    T opening = 0, slip = 0;  ///< path of the faces away from and along each other
    T plastic_strain = 0;
    T plastic_work = 0, damage_work = 0, decohesion_work = 0;
  };
  using History = HistoryOf<double>;
  static constexpr int field_count = 14;
  static constexpr int deciding = 7;  ///< what the stress depends on is among the first so many
  template <class T>
  static constexpr Field<HistoryOf<T>, T> fields_of[field_count] = {
      {"energy", "J/kg", &HistoryOf<T>::energy},
      {"crack density", "-", &HistoryOf<T>::crack_density},
      {"peak rate", "1/s", &HistoryOf<T>::peak_rate},
      {"decohesion", "-", &HistoryOf<T>::lambda},
      {"normal x", "-", &HistoryOf<T>::normal_x},
      {"normal y", "-", &HistoryOf<T>::normal_y},
      {"strength", "Pa", &HistoryOf<T>::strength},
      {"damage", "-", &HistoryOf<T>::damage},
      {"opening", "m", &HistoryOf<T>::opening},
      {"slip", "m", &HistoryOf<T>::slip},
      {"plastic strain", "-", &HistoryOf<T>::plastic_strain},
      {"plastic work", "J/kg", &HistoryOf<T>::plastic_work},
      {"damage work", "J/kg", &HistoryOf<T>::damage_work},
      {"decohesion work", "J/kg", &HistoryOf<T>::decohesion_work}};
  static constexpr const auto& fields = fields_of<double>;

  /// Where sqrt(J2) is held below k of the cone though the mean stress is tensile.
  enum class ShearLimit { none, before_onset, always };

  TensileDamage damage;
  DruckerPragerCone cone;
  Decohesion decohesion;
  double strain_share = 1. / 3, rate_share = 1;  ///< of the traces, what damage looks at [-]
  double least_rate = 1;                         ///< floor of the peak rate [1/s]
  ShearLimit shear_limit = ShearLimit::before_onset;
  bool recovers = false;  ///< whether cracks that close give the bulk modulus back

  explicit Concrete(const Teuchos::ParameterList& list);
  static Teuchos::ParameterList valid_parameters(const Teuchos::ParameterList& given);

  KOKKOS_INLINE_FUNCTION History initial(double, double, bool) const { return {}; }

  template <class H>
  KOKKOS_FORCEINLINE_FUNCTION static auto whole(const H& h) {
    return !(h.strength > Number<H>(0));
  }

  /// The normal of the plane turns with the matter by R.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static void rotate(HistoryOf<T>& h, const MatOf<T, 3>& R) {
    const T x = R(0, 0) * h.normal_x + R(0, 1) * h.normal_y,
            y = R(1, 0) * h.normal_x + R(1, 1) * h.normal_y, length2 = square(x) + square(y);
    const auto has = length2 > T(0);
    if (!any(has)) return;
    const T per_length = 1 / sqrt(select(has, length2, T(1)));
    h.normal_x = x * per_length;
    h.normal_y = y * per_length;
  }

  KOKKOS_INLINE_FUNCTION Energies energies(const Sym3& sigma, double rho, const History& h) const {
    Energies e;
    e.elastic = moduli(h, trace(sigma)).energy(sigma) / rho;
    e.plastic = h.plastic_work;
    e.damage = h.damage_work;
    e.decohesion = h.decohesion_work;
    return e;
  }

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION ResponseOf<T> update(const StrainOf<T>& in, const SymOf<T>& old,
                                                   HistoryOf<T>& h) const {
    PathOf<T> path{old, increment(in), moduli(h, trace(old)), 1 / in.rho0};
    const T volume =  // elastic, of the trial
        (1. / 3) * path.moduli.per_K * trace(old) + trace(path.de);
    const auto stretches = whole(h) && !(volume < T(0));
    ResponseOf<T> r;
    r.sound_speed = speed(in.rho1);
    if (any(stretches)) r.stress = stretch(in, stretches, path, h);
    const auto rest = !stretches || !whole(h);
    if (any(rest)) r.stress = select(rest, bounded(in, rest, path, volume, h), r.stress);
    return r;
  }

 private:
  /// Damage stops short of leaving nothing, so that a stress always has its strain.
  static constexpr double largest_crack_density = 9. / 16 * (1 - 1e-6);

  /// An increment of strain from a state of stress.
  template <class T>
  struct PathOf {
    SymOf<T> stress, de;
    IsotropicOf<T> moduli;  ///< at its start
    T per_rho;              ///< at its start [m^3/kg]
  };

  /// Moduli of the damaged matter for a mean stress of that sign.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION IsotropicOf<T> moduli(const HistoryOf<T>& h, const T& sign) const {
    const auto damaged = h.crack_density > T(0);
    if (!any(damaged)) return {intact.K, intact.G, intact.per_K, intact.per_G};
    const IsotropicOf<T> now = damage.at(h.crack_density).moduli;
    const auto softer = damaged && !(T(recovers ? 1 : 0) * sign < T(0));
    return {select(softer, now.K, T(intact.K)), select(damaged, now.G, T(intact.G)),
            select(softer, now.per_K, T(intact.per_K)),
            select(damaged, now.per_G, T(intact.per_G))};
  }

  KOKKOS_INLINE_FUNCTION DruckerPragerCone shear_only() const { return {0, 0, cone.k}; }

  /// Where a stretch has come to at some share of its increment.
  template <class T>
  struct StretchedOf {
    T Cd = 0, D = 0;  ///< D where damage grows
    IsotropicOf<T> moduli;
    SymOf<T> trial, stress;           ///< before and after the limit of shear
    T plastic_strain = 0;             ///< with what the limit adds
    Truth<T> localised = Truth<T>{};  ///< damage grows and the strain can localise across the major
                                      ///< principal one
  };

  /// What of a stretch does not depend on how far it goes.
  template <class T>
  struct StretchOf {
    Truth<T> wanted;
    T density;              ///< see TensileDamage::density_at
    IsotropicOf<T> moduli;  ///< before
    T crack_density, plastic_strain;
  };

  template <class T>
  KOKKOS_INLINE_FUNCTION StretchedOf<T> stretched(const StretchOf<T>& of,
                                                  const SymOf<T>& strain) const {
    StretchedOf<T> s;
    const T volume = trace(strain);
    const T Cd = of.density * raised(strain_share * most(volume, T(0)), damage.m);
    const auto grows = of.wanted && Cd > of.crack_density;
    const bool any_grow = any(grows);
    s.Cd = select(grows, least(Cd, T(largest_crack_density)), of.crack_density);
    s.moduli = of.moduli;
    TensileDamage::StateOf<T> state;
    if (any_grow) {
      state = damage.at(s.Cd);
      s.moduli = select(grows, state.moduli, of.moduli);
      s.D = state.D;
    }
    s.trial = s.stress = s.moduli.stress(strain);
    s.plastic_strain = of.plastic_strain;
    if (shear_limit != ShearLimit::none)
      shear_only().bring_back(s.moduli, s.stress, s.plastic_strain, of.wanted);
    if (any_grow) {
      const T mean = trace(s.stress) * (1. / 3),
              normal = 0.5 * (s.stress[0] + s.stress[1]) + shear_in_plane(s.stress),
              r = 1. / 3 +  // strain along the normal over volume
                  (normal - mean) * (0.5 * s.moduli.per_G) / select(grows, volume, T(1));
      s.localised = grows && normal > T(0) && !(damage.localisation(state, s.Cd, r) > T(0));
    }
    return s;
  }

  /// Tension before there is a plane. Where a step reaches the onset, it is looked for within the
  /// step, and the rest of the step is left as the path: the strength of the plane does not depend
  /// on how long steps are.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION SymOf<T> stretch(const StrainOf<T>& in, const Truth<T>& wanted,
                                               PathOf<T>& path, HistoryOf<T>& h) const {
    h.peak_rate = select(wanted, most(h.peak_rate, rate_share * trace(in.rate)), h.peak_rate);
    const SymOf<T> strain = path.moduli.strain(path.stress);
    const StretchOf<T> of{wanted, damage.density_at(most(h.peak_rate, T(least_rate))),
                          recovers ? moduli(h, T(1)) : path.moduli, h.crack_density,
                          h.plastic_strain};
    const auto at = [&](const T& share) { return stretched(of, added(strain, share, path.de)); };
    StretchedOf<T> end = at(T(1));
    const auto onset = end.localised;
    T share = 1;
    if (any(onset)) {
      T low = 0;
      for (int k = 0; k < 24; ++k) {
        const T mid = 0.5 * (low + share);
        const auto there = onset && at(mid).localised;
        share = select(there, mid, share);
        low = select(onset && !there, mid, low);
      }
      end = at(share);
    }
    const IsotropicOf<T> now = end.moduli;
    const auto grows = end.Cd > h.crack_density;
    if (any(grows)) {
      const T lost = damage_work(of.moduli, now, strain, now.strain(end.stress)) * path.per_rho;
      h.damage_work += select(grows, lost, T(0));
      h.crack_density = end.Cd;
      h.damage = select(grows, end.D, h.damage);
    }
    const auto flows = end.plastic_strain > h.plastic_strain;
    if (any(flows)) {
      h.plastic_strain = end.plastic_strain;
      h.plastic_work += flow_work(flows, path.per_rho, now, middle(path.stress, end.stress),
                                  added(end.trial, -1, end.stress));
    }
    if (any(onset)) {
      const VecOf<T, 2> n = major_direction(end.stress);
      h.strength = select(onset, along(end.stress, n), h.strength);
      h.normal_x = select(onset, n[0], h.normal_x);
      h.normal_y = select(onset, n[1], h.normal_y);
      const SymOf<T> left = added(SymOf<T>{}, 1 - share, path.de);
      path = {select(onset, end.stress, path.stress), select(onset, left, path.de),
              select(onset, now, path.moduli), path.per_rho};
    }
    return end.stress;
  }

  /// -strain0 : dC : strain1 / 2, what (stress0 + stress1) / 2 : (strain1 - strain0) does beyond
  /// the elastic energy. Only matter that was stretched can lose bulk modulus by being stretched.
  /// [J/m^3]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T damage_work(const IsotropicOf<T>& before,
                                                   const IsotropicOf<T>& now,
                                                   const SymOf<T>& strain0,
                                                   const SymOf<T>& strain1) {
    const T volume0 = trace(strain0), volume1 = trace(strain1);
    const T shear = contract(strain0, strain1) - volume0 * volume1 * (1. / 3);
    return most(
        0.5 * (before.K - now.K) * most(volume0, T(0)) * volume1 + (before.G - now.G) * shear,
        T(0));
  }

  /// Of the points that flow. [J/kg]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T flow_work(const Truth<T>& flows, const T& per_rho,
                                                 const IsotropicOf<T>& now, const SymOf<T>& mean,
                                                 const SymOf<T>& excess) {
    return select(flows, plastic_work(now, mean, excess) * per_rho, T(0));
  }

  /// Matter that is pressed, or has a plane in it: the cone bounds the matter, the plane what is
  /// left across it.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION SymOf<T> bounded(const StrainOf<T>& in, const Truth<T>& wanted,
                                               const PathOf<T>& path, const T& volume,
                                               HistoryOf<T>& h) const {
    const IsotropicOf<T> now = recovers ? moduli(h, volume) : path.moduli;
    SymOf<T> trial = added(path.stress, 1, path.moduli.stress(path.de));
    if (recovers) {  // the bulk modulus belongs to the sign of the new strain of volume
      const T change = select(now.K > path.moduli.K || now.K < path.moduli.K,
                              now.K * volume - trace(trial) * (1. / 3), T(0));
      for (int k = 0; k < 3; ++k) trial[k] += change;
    }
    SymOf<T> in_matter = trial;
    const auto pressed = volume < T(0), parted = wanted && !whole(h);
    auto flows = cone.bring_back(now, in_matter, h.plastic_strain, wanted && pressed);
    if (shear_limit == ShearLimit::always)
      flows =
          flows || shear_only().bring_back(now, in_matter, h.plastic_strain, parted && !pressed);
    SymOf<T> sigma = in_matter;
    if (any(parted)) sigma = across_plane(in, parted, path, in_matter, now, h);
    if (any(flows))
      h.plastic_work += flow_work(flows, path.per_rho, now, middle(path.stress, sigma),
                                  added(trial, -1, in_matter));
    return sigma;
  }

  /// The stress that a plane leaves of that of the matter. The length that shares its volume with
  /// the plane is the chord of a cell, not that of a point: all points of a cell see one strain.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION SymOf<T> across_plane(const StrainOf<T>& in, const Truth<T>& parted,
                                                    const PathOf<T>& path,
                                                    const SymOf<T>& in_matter,
                                                    const IsotropicOf<T>& now,
                                                    HistoryOf<T>& h) const {
    using Plane = Decohesion::PlaneOf<T>;
    using Traction = Decohesion::TractionOf<T>;
    const VecOf<T, 2> n{h.normal_x, h.normal_y};
    const T length = in.h * select(parted, most(fabs(n[0]), fabs(n[1])), T(1)),
            per_length = 1 / length;
    Plane plane{select(parted, h.strength, T(1)), select(parted, h.lambda, T(0))};
    Traction tau{select(parted, along(in_matter, n), T(0)),
                 select(parted, across(in_matter, n), T(0))};
    const Traction before{along(path.stress, n), across(path.stress, n)};
    const Decohesion::OpeningOf<T> du =
        decohesion.update(plane, tau, before, {now.constrained(), now.G, length});
    h.lambda = select(parted, plane.lambda, h.lambda);
    h.opening += du.n;
    h.slip += fabs(du.t);
    h.decohesion_work += du.work * per_length * path.per_rho;
    return added(in_matter, -1, now.stress(opened(n, du, per_length)));
  }

  /// (n du + du n) / 2 over a length with du in the frame of n and t = (-n_y, n_x).
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static SymOf<T> opened(const VecOf<T, 2>& n,
                                                     const Decohesion::OpeningOf<T>& du,
                                                     const T& per_length) {
    const T x = (du.n * n[0] - du.t * n[1]) * per_length,
            y = (du.n * n[1] + du.t * n[0]) * per_length;
    SymOf<T> e;
    e[0] = n[0] * x;
    e[1] = n[1] * y;
    e[3] = 0.5 * (n[0] * y + n[1] * x);
    return e;
  }
};

}  // namespace brisance
