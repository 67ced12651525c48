#pragma once
// Drives the law of a solid at one point along a path of strain.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <random>
#include <string>

#include "core/parameters.hpp"
#include "materials/material.hpp"

namespace brisance {

/// A law with the parameters given, as the input would make it.
template <class M>
M law_of(const List& given) {
  return M(check(given, M::valid_parameters(given)));
}

/// The one line with which parameters are refused.
template <class M>
std::string refusal(const List& given) {
  try {
    law_of<M>(given);
  } catch (const InputError& wrong) {
    return wrong.what();
  }
  return "accepted";
}

inline Sym3 tensor(double xx, double yy, double zz, double xy) {
  Sym3 a;
  a[0] = xx;
  a[1] = yy;
  a[2] = zz;
  a[3] = xy;
  return a;
}

/// `angle` turns x towards y.
inline Sym3 turned(const Sym3& a, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return tensor(c * c * a[0] + s * s * a[1] - 2 * s * c * a[3],
                s * s * a[0] + c * c * a[1] + 2 * s * c * a[3], a[2],
                s * c * (a[0] - a[1]) + (c * c - s * s) * a[3]);
}

inline Strain strain_step(const Sym3& de, double dt, double rho, double h) {
  Strain in;
  for (int k = 0; k < 6; ++k) in.rate[k] = de[k] / dt;
  in.dt = dt;
  in.rho0 = in.rho1 = rho;
  in.h = h;
  return in;
}

/// A point at rest, and the work that has been done on it. Strains are small: the density stays.
template <class M>
struct Point {
  M law;
  double h = 0.025;
  Sym3 stress = {};
  typename M::History history = {};
  double work = 0;  ///< [J/kg]

  void strain(const Sym3& de, double dt) {
    const Sym3 before = stress;
    stress = law.update(strain_step(de, dt, law.density(), h), before, history).stress;
    work += 0.5 * (contract(before, de) + contract(stress, de)) / law.density();
  }
  /// The same in equal parts.
  void strain(const Sym3& total, double dt, int steps) {
    Sym3 de;
    for (int k = 0; k < 6; ++k) de[k] = total[k] / steps;
    for (int k = 0; k < steps; ++k) strain(de, dt / steps);
  }
  Energies energies() const { return law.energies(stress, law.density(), history); }
  double dissipated() const {
    const Energies e = energies();
    return e.plastic + e.damage + e.decohesion;
  }
  /// Work that is neither stored nor dissipated. [J/kg]
  double missing() const { return work - energies().elastic - dissipated(); }
};

/// Walks at random in strain, `most` at a step in each component, and calls f(before, after) each
/// time.
template <class M, class F>
void wander(Point<M>& point, double most, int steps, std::mt19937& random, const F& f) {
  std::uniform_real_distribution<double> any(-most, most);
  for (int k = 0; k < steps; ++k) {
    const Energies before = point.energies();
    const Sym3 de = tensor(any(random), any(random), 0, any(random));
    point.strain(de, 1e-6);
    f(before, point.energies());
  }
}

inline List steel(double yield = 500e6) {
  List list;
  list.set("Young's modulus", 200e9);
  list.set("Poisson's ratio", 0.29);
  list.set("density", 7850.);
  if (yield > 0) list.set("yield stress", yield);
  return list;
}

}  // namespace brisance
