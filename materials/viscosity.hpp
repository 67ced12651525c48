#pragma once
// What a fluid may add to its pressure: a Newtonian viscosity (tensor) and an artificial one that
// gives shocks a width. Each has a counterpart that does nothing and costs nothing.
#include "core/particles.hpp"
#include "core/types.hpp"
#include "materials/material.hpp"

namespace Teuchos {
class ParameterList;
}

namespace brisance {

struct Inviscid {
  static constexpr Stress stress = Stress::pressure;
  KOKKOS_INLINE_FUNCTION Sym3 stress_of(const Sym3&) const { return {}; }
  KOKKOS_INLINE_FUNCTION double signal_speed(double, double) const { return 0; }
};

/// sigma = 2 mu D + lambda tr(D) I, eq. (10).
struct Newtonian {
  static constexpr Stress stress = Stress::tensor;
  double mu = 0, lambda = 0;  ///< [Pa s]

  Newtonian(double mu_, double lambda_) : mu(mu_), lambda(lambda_) {}
  explicit Newtonian(const Teuchos::ParameterList& list);
  static Teuchos::ParameterList valid_parameters();

  KOKKOS_INLINE_FUNCTION Sym3 stress_of(const Sym3& rate) const {
    Sym3 s;
    const double mean = lambda * trace(rate);
    for (int k = 0; k < 6; ++k) s[k] = 2 * mu * rate[k] + (k < 3 ? mean : 0);
    return s;
  }
  /// Explicit diffusion is stable for dt < h^2 / (2 dim nu), here as a speed with dim = 3. [m/s]
  KOKKOS_INLINE_FUNCTION double signal_speed(double rho, double h) const {
    return 6 * (2 * mu + lambda) / (rho * h);
  }
};

struct NoShockViscosity {
  KOKKOS_INLINE_FUNCTION double pressure(double, double, double, double, const Strain&) const {
    return 0;
  }
  KOKKOS_INLINE_FUNCTION double speed(double, double, double, double) const { return 0; }
};

/// Artificial viscosity: a pressure q from the jump of velocity across a cell, du = -h D.
/// Compression, von Neumann-Richtmyer (eq. 14): q = rho du (c0 du + c1 c);
/// Kurapatenko (1967): q = rho du (c0 K du + sqrt((c0 K du)^2 + (c1 c)^2)), K from the material's
/// shock slope. Expansion: q = rho du ce c, as a Riemann solver has it too. It damps the train of
/// waves, three to six cells long, that trails a blast in gas that already expands; without it the
/// error of velocity in Sedov's blast is 26 % in place of 17 %. The limiter takes the linear terms
/// away where the flow is smooth (Christensen 1990); the quadratic one vanishes there by itself,
/// and to limit it, too, overshoots in convergent flow.
struct ShockViscosity {
  enum class Form { von_neumann_richtmyer, kurapatenko };
  Form form = Form::kurapatenko;
  double c0 = 1, c1 = 0.85, ce = 0.25;
  double limiter = 1;  ///< share of the linear terms taken away in smooth flow [-]

  ShockViscosity() = default;
  explicit ShockViscosity(const Teuchos::ParameterList& list);

  /// p, c: pressure and sound speed before the step, K: shock slope. [Pa]
  KOKKOS_INLINE_FUNCTION double pressure(double rho, double p, double c, double K,
                                         const Strain& in) const {
    const double du = -in.h * trace(in.rate), rough = 1 - limiter * in.smoothness;
    if (!(du > 0)) return most(rho * du * rough * ce * c, -0.3 * p);
    const double linear = rough * c1 * c;
    if (form == Form::von_neumann_richtmyer) return rho * du * (c0 * du + linear);
    const double quadratic = c0 * K * du;
    return rho * du * (quadratic + sqrt(square(quadratic) + square(linear)));
  }

  /// What viscosity adds to the speed of signals, b in dt = CFL h / (|v| + b + sqrt(b^2 + c^2)).
  /// [m/s]
  KOKKOS_INLINE_FUNCTION double speed(double c, double K, double divergence, double h) const {
    if (!(divergence < 0)) return ce * c;
    return (form == Form::kurapatenko ? c0 * K : c0) * h * -divergence + c1 * c;
  }
};

}  // namespace brisance
