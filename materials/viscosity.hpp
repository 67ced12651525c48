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
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION SymOf<T> stress_of(const SymOf<T>&) const {
    return {};
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T signal_speed(const T&, double) const {
    return 0;
  }
};

/// sigma = 2 mu D + lambda tr(D) I, eq. (10).
struct Newtonian {
  static constexpr Stress stress = Stress::tensor;
  double mu = 0, lambda = 0;  ///< [Pa s]

  Newtonian(double mu_, double lambda_) : mu(mu_), lambda(lambda_) {}
  explicit Newtonian(const Teuchos::ParameterList& list);
  static Teuchos::ParameterList valid_parameters();

  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION SymOf<T> stress_of(const SymOf<T>& rate) const {
    SymOf<T> s;
    const T mean = lambda * trace(rate);
    for (int k = 0; k < 6; ++k) s[k] = 2 * mu * rate[k] + (k < 3 ? mean : T(0));
    return s;
  }
  /// Explicit diffusion is stable for dt < h^2 / (2 dim nu), here as a speed with dim = 3. [m/s]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T signal_speed(const T& rho, double h) const {
    return 6 * (2 * mu + lambda) / (rho * h);
  }
};

struct NoShockViscosity {
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T pressure(const Same<T>&, const Same<T>&, const Same<T>&, double,
                                         const StrainOf<T>&) const {
    return 0;
  }
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T speed(const T&, double, const Same<T>&, double) const {
    return 0;
  }
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
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T pressure(const Same<T>& rho, const Same<T>& p, const Same<T>& c,
                                         double K, const StrainOf<T>& in) const {
    const T du = -in.h * trace(in.rate), rough = 1 - limiter * in.smoothness;
    const T expanding = most(rho * du * rough * ce * c, -0.3 * p);
    const T linear = rough * c1 * c;
    T jump = c0 * du + linear;
    if (form == Form::kurapatenko) {
      const T quadratic = c0 * K * du;
      jump = quadratic + sqrt(square(quadratic) + square(linear));
    }
    return select(du > T(0), rho * du * jump, expanding);
  }

  /// What viscosity adds to the speed of signals, b in dt = CFL h / (|v| + b + sqrt(b^2 + c^2)).
  /// [m/s]
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION T speed(const T& c, double K, const Same<T>& divergence,
                                      double h) const {
    const double quadratic = (form == Form::kurapatenko ? c0 * K : c0) * h;
    return select(divergence < T(0), c1 * c - quadratic * divergence, ce * c);
  }
};

}  // namespace brisance
