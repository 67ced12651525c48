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

  struct History {
    double energy = 0;
    double crack_density = 0, damage = 0;
    double peak_rate = 0;  ///< largest rate of volume in tension so far
    double lambda = 0;     ///< share of decohesion
    double normal_x = 0, normal_y = 0;
    double strength = 0;           ///< of the plane in tension at onset; 0: there is none
    double opening = 0, slip = 0;  ///< path of the faces away from and along each other
    double plastic_strain = 0;
    double plastic_work = 0, damage_work = 0, decohesion_work = 0;
  };
  static constexpr int field_count = 14;
  static constexpr Field<History> fields[field_count] = {
      {"energy", "J/kg", &History::energy},
      {"crack density", "-", &History::crack_density},
      {"damage", "-", &History::damage},
      {"peak rate", "1/s", &History::peak_rate},
      {"decohesion", "-", &History::lambda},
      {"normal x", "-", &History::normal_x},
      {"normal y", "-", &History::normal_y},
      {"strength", "Pa", &History::strength},
      {"opening", "m", &History::opening},
      {"slip", "m", &History::slip},
      {"plastic strain", "-", &History::plastic_strain},
      {"plastic work", "J/kg", &History::plastic_work},
      {"damage work", "J/kg", &History::damage_work},
      {"decohesion work", "J/kg", &History::decohesion_work}};

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

  KOKKOS_INLINE_FUNCTION static bool whole(const History& h) { return !(h.strength > 0); }

  /// The normal of the plane turns with the matter by R.
  KOKKOS_INLINE_FUNCTION static void rotate(History& h, const Mat<3>& R) {
    const double x = R(0, 0) * h.normal_x + R(0, 1) * h.normal_y,
                 y = R(1, 0) * h.normal_x + R(1, 1) * h.normal_y;
    const double length = sqrt(square(x) + square(y));
    if (!(length > 0)) return;
    h.normal_x = x / length;
    h.normal_y = y / length;
  }

  KOKKOS_INLINE_FUNCTION Energies energies(const Sym3& sigma, double rho, const History& h) const {
    Energies e;
    e.elastic = moduli(h, trace(sigma)).energy(sigma) / rho;
    e.plastic = h.plastic_work;
    e.damage = h.damage_work;
    e.decohesion = h.decohesion_work;
    return e;
  }

  KOKKOS_INLINE_FUNCTION Response update(const Strain& in, const Sym3& old, History& h) const {
    const Sym3 de = increment(in);
    const Isotropic start = moduli(h, trace(old));
    const double volume = trace(old) / (3 * start.K) + trace(de);  // elastic, of the trial
    Response r;
    r.sound_speed = speed(in.rho1);
    if (h.strength > 0) {
      r.stress = part(in, old, de, start, volume, h);
    } else if (volume < 0) {
      const Isotropic now = recovers ? moduli(h, volume) : start;
      const Sym3 trial = tried(old, de, start, now, volume);
      r.stress = trial;
      if (cone.bring_back(now, r.stress, h.plastic_strain)) {
        h.plastic_work +=
            plastic_work(now, middle(old, r.stress), added(trial, -1, r.stress)) / in.rho0;
      }
    } else {
      r.stress = stretch(in, old, de, start, volume, h);
    }
    return r;
  }

 private:
  /// Damage stops short of leaving nothing, so that a stress always has its strain.
  static constexpr double largest_crack_density = 9. / 16 * (1 - 1e-6);

  /// Moduli of the damaged matter for a mean stress of that sign.
  KOKKOS_INLINE_FUNCTION Isotropic moduli(const History& h, double sign) const {
    if (!(h.crack_density > 0)) return intact;
    Isotropic now = damage.at(h.crack_density).moduli;
    if (recovers && sign < 0) now.K = intact.K;
    return now;
  }

  /// Elastic from `old` with the bulk modulus that belongs to the sign of the new volume strain.
  KOKKOS_INLINE_FUNCTION static Sym3 tried(const Sym3& old, const Sym3& de, const Isotropic& start,
                                           const Isotropic& now, double volume) {
    Sym3 s = added(old, 1, start.stress(de));
    if (start.K == now.K) return s;
    const double change = now.K * volume - trace(s) / 3;
    for (int k = 0; k < 3; ++k) s[k] += change;
    return s;
  }

  KOKKOS_INLINE_FUNCTION DruckerPragerCone shear_only() const { return {0, 0, cone.k}; }

  /// Where a stretch has come to at some share of its increment.
  struct Stretched {
    double Cd = 0;
    TensileDamage::State state;
    Sym3 trial, stress;         ///< before and after the limit of shear
    double plastic_strain = 0;  ///< with what the limit adds
    Vec<2> n;                   ///< of the major principal strain
    bool localised = false;     ///< damage grows and the strain can localise across n
  };

  KOKKOS_INLINE_FUNCTION Stretched stretched(const Sym3& strain, double rate,
                                             const History& h) const {
    Stretched s;
    const double volume = trace(strain);
    const double Cd = volume > 0 ? damage.crack_density(strain_share * volume, rate) : 0;
    const bool grows = Cd > h.crack_density;
    s.Cd = grows ? least(Cd, largest_crack_density) : h.crack_density;
    s.state = damage.at(s.Cd);
    s.trial = s.stress = s.state.moduli.stress(strain);
    s.plastic_strain = h.plastic_strain;
    if (shear_limit != ShearLimit::none) {
      shear_only().bring_back(s.state.moduli, s.stress, s.plastic_strain);
    }
    if (!grows) return s;
    s.n = major_direction(s.stress);
    const double normal = along(s.stress, s.n), mean = trace(s.stress) / 3;
    const double r =
        1. / 3 + (normal - mean) / (2 * s.state.moduli.G * volume);  // strain along n over volume
    s.localised = normal > 0 && !(damage.localisation(s.state, s.Cd, r) > 0);
    return s;
  }

  /// Tension before there is a plane. Where a step reaches the onset, it is looked for within the
  /// step, and the rest of the step goes on from there: the strength of the plane does not depend
  /// on how long steps are.
  KOKKOS_INLINE_FUNCTION Sym3 stretch(const Strain& in, const Sym3& old, const Sym3& de,
                                      const Isotropic& start, double volume, History& h) const {
    h.peak_rate = most(h.peak_rate, rate_share * trace(in.rate));
    const double rate = most(h.peak_rate, least_rate);
    const Sym3 strain = start.strain(old);
    Stretched end = stretched(added(strain, 1, de), rate, h);
    double share = 1;
    if (end.localised) {
      double low = 0;
      for (int k = 0; k < 48; ++k) {
        const double mid = 0.5 * (low + share);
        const Stretched there = stretched(added(strain, mid, de), rate, h);
        if (there.localised) {
          share = mid;
          end = there;
        } else {
          low = mid;
        }
      }
    }
    if (end.Cd > h.crack_density) {
      const Isotropic before = damage.at(h.crack_density).moduli, now = end.state.moduli;
      h.damage_work += damage_work(before, now, strain, now.strain(end.stress)) / in.rho0;
      h.crack_density = end.Cd;
      h.damage = end.state.D;
    }
    if (end.plastic_strain > h.plastic_strain) {
      h.plastic_strain = end.plastic_strain;
      h.plastic_work += plastic_work(end.state.moduli, middle(old, end.stress),
                                     added(end.trial, -1, end.stress)) /
                        in.rho0;
    }
    if (!end.localised) return end.stress;
    h.strength = along(end.stress, end.n);
    h.normal_x = end.n[0];
    h.normal_y = end.n[1];
    const Sym3 rest = added({}, 1 - share, de);
    return part(in, end.stress, rest, end.state.moduli, volume, h);
  }

  /// -strain0 : dC : strain1 / 2, what (stress0 + stress1) / 2 : (strain1 - strain0) does beyond
  /// the elastic energy. Only matter that was stretched can lose bulk modulus by being stretched.
  /// [J/m^3]
  KOKKOS_INLINE_FUNCTION static double damage_work(const Isotropic& before, const Isotropic& now,
                                                   const Sym3& strain0, const Sym3& strain1) {
    const double volume0 = trace(strain0), volume1 = trace(strain1);
    const double shear = contract(strain0, strain1) - volume0 * volume1 / 3;
    return most(0.5 * (before.K - now.K) * most(volume0, 0) * volume1 + (before.G - now.G) * shear,
                0);
  }

  /// Strain of matter with a plane in it: the cone bounds the matter, the plane what is left across
  /// it. The length that shares its volume with the plane is the chord of a cell, not that of a
  /// point: all points of a cell see one strain.
  KOKKOS_INLINE_FUNCTION Sym3 part(const Strain& in, const Sym3& old, const Sym3& de,
                                   const Isotropic& start, double volume, History& h) const {
    const Isotropic now = recovers ? moduli(h, volume) : start;
    const Sym3 trial = tried(old, de, start, now, volume);
    Sym3 bounded = trial;
    bool flows = false;
    if (volume < 0) {
      flows = cone.bring_back(now, bounded, h.plastic_strain);
    } else if (shear_limit == ShearLimit::always) {
      flows = shear_only().bring_back(now, bounded, h.plastic_strain);
    }

    Vec<2> n;
    n[0] = h.normal_x;
    n[1] = h.normal_y;
    const double length = in.h * most(fabs(n[0]), fabs(n[1]));
    Decohesion::Plane plane{h.strength, h.lambda};
    Decohesion::Traction tau{along(bounded, n), across(bounded, n)};
    const Decohesion::Opening du = decohesion.update(plane, tau, {along(old, n), across(old, n)},
                                                     {now.constrained(), now.G, length});
    h.lambda = plane.lambda;
    h.opening += du.n;
    h.slip += fabs(du.t);
    h.decohesion_work += du.work / (length * in.rho0);
    Sym3 sigma = bounded;
    if (du.n != 0 || du.t != 0) sigma = added(bounded, -1, now.stress(opened(n, du, length)));
    if (flows) {
      h.plastic_work += plastic_work(now, middle(old, sigma), added(trial, -1, bounded)) / in.rho0;
    }
    return sigma;
  }

  /// (n du + du n) / (2 length) with du in the frame of n and t = (-n_y, n_x).
  KOKKOS_INLINE_FUNCTION static Sym3 opened(const Vec<2>& n, const Decohesion::Opening& du,
                                            double length) {
    const double x = du.n * n[0] - du.t * n[1], y = du.n * n[1] + du.t * n[0];
    Sym3 e;
    e[0] = n[0] * x / length;
    e[1] = n[1] * y / length;
    e[3] = 0.5 * (n[0] * y + n[1] * x) / length;
    return e;
  }
};

}  // namespace brisance
