#pragma once
// The named schemes. A preset is nothing but defaults: every knob can be set one by one over it.
#include <string>

#include "core/parameters.hpp"

namespace brisance {

/// paper: Appendix A of Hu & Chen (2006) as printed, for comparison. fast, balanced, accurate: with
/// compatible energy; what each reaches and costs stands in the README.
struct Preset {
  // transfer
  std::string shape = "linear", transfer = "FLIP", quadrature = "cell", integration = "midpoint";
  std::string work = "exact";
  double damping = 0.03;
  std::string solid_shape = "quadratic", solid_transfer = "MLS";
  // corrections
  double volume_relaxation = 0.15, pressure_relaxation = 1, heat_conduction = 1, split_length = 0.5;
  // artificial viscosity
  std::string viscosity = "Kurapatenko";
  double quadratic = 1, linear = 0.85, expansion = 0.25, limiter = 1;
  // time step
  double cfl = 0.8, largest_volume_change = 0.5;
};

/// "paper", "fast", "balanced" or "accurate", for so many dimensions.
Preset preset(const std::string& name, int dim);

/// Schemas with the defaults of a preset.
List valid_scheme(const Preset& preset);
List valid_solid_scheme(const Preset& preset);
List valid_shock_viscosity(const Preset& preset);

}  // namespace brisance
