#include "drivers/presets.hpp"

#include <Teuchos_ParameterList.hpp>
#include <stdexcept>

namespace brisance {

Preset preset(const std::string& name, int dim, bool solids_meet_fluids) {
  Preset p;
  p.stress_relaxation = solids_meet_fluids ? 0.1 : 0;
  // In the plane a thousandth more than a cell, so that single points that fill theirs do not fall
  // apart when they breathe.
  p.split_length = dim == 1 ? 0.5 : 1.001;
  if (name == "balanced") return p;
  if (name == "paper") {
    p.quadrature = "particle";
    p.integration = "MUSL";
    p.work = "printed";
    p.solid_shape = "linear";
    p.solid_transfer = "FLIP";
    p.damping = p.stress_relaxation = 0;
    p.volume_relaxation = p.pressure_relaxation = p.heat_conduction = p.split_length = 0;
    p.viscosity = "von Neumann-Richtmyer";
    p.quadratic = 2;
    p.linear = 1;
    p.expansion = p.limiter = 0;
    p.cfl = 0.3;
    p.largest_volume_change = 0.1;
    return p;
  }
  if (name == "fast") {
    p.damping = 0.015;
    p.relaxation_interval = 4;  // of the volume alone, which makes no pressure waver
    p.pressure_relaxation = p.heat_conduction = 0;
    p.viscosity = "von Neumann-Richtmyer";
    p.linear = 0.5;
    p.expansion = p.limiter = 0;
    return p;
  }
  if (name == "accurate") {
    p.shape = "quadratic";
    p.transfer = "MLS";
    p.quadrature = "particle";
    return p;
  }
  throw std::logic_error("no preset '" + name + "'");
}

List valid_shock_viscosity(const Preset& p) {
  List valid;
  declare(valid, "form", p.viscosity, one_of({"none", "von Neumann-Richtmyer", "Kurapatenko"}),
          "formula of the artificial viscosity q [-]");
  declare(valid, "quadratic", p.quadratic, between(0, 100),
          "coefficient c0 of the quadratic term [-]");
  declare(valid, "linear", p.linear, between(0, 100), "coefficient c1 of the linear term [-]");
  declare(valid, "expansion", p.expansion, between(0, 100),
          "coefficient of the linear term in expansion [-]");
  declare(valid, "limiter", p.limiter, between(0, 1),
          "share of the linear terms taken away where the flow is smooth [-]");
  return valid;
}

namespace {

void declare_transfer(List& valid, const std::string& shape, const std::string& transfer) {
  declare(valid, "shape", shape, one_of({"linear", "GIMP", "quadratic", "cubic"}),
          "shape function [-]");
  declare(valid, "transfer", transfer, one_of({"FLIP", "APIC", "MLS"}),
          "velocity transfer: FLIP, affine (APIC), affine with moving-least-squares gradients "
          "(MLS) [-]");
}

}  // namespace

List valid_solid_scheme(const Preset& p) {
  List valid;
  declare_transfer(valid, p.solid_shape, p.solid_transfer);
  declare(valid, "damping", 0.0, between(0, 1),
          "FLIP: share of a particle's velocity drawn to the grid's in a sound crossing of a cell "
          "[-]");
  declare(valid, "stress relaxation", p.stress_relaxation, between(0, 1),
          "share of the stress that no node feels, lost in a sound crossing of a cell [-]");
  return valid;
}

List valid_scheme(const Preset& p) {
  List valid;
  declare_transfer(valid, p.shape, p.transfer);
  declare(valid, "quadrature", p.quadrature, one_of({"particle", "cell"}),
          "where stress acts: at each particle, or as the mean of a cell through its centre [-]");
  declare(valid, "integration", p.integration, one_of({"MUSL", "midpoint"}),
          "MUSL (the paper's Appendix A) or midpoint stress with compatible energy [-]");
  declare(valid, "MUSL work", p.work, one_of({"exact", "printed"}),
          "work of pressure on the exact change of specific volume, or divided by the new density "
          "as printed [-]");
  declare(
      valid, "damping", p.damping, between(0, 1),
      "FLIP: share of a particle's velocity drawn to the grid's in a sound crossing of a cell [-]");
  declare(valid, "volume relaxation", p.volume_relaxation, between(0, 1),
          "share of the error in filled volume that is removed in a sound crossing of a cell [-]");
  declare(valid, "pressure relaxation", p.pressure_relaxation, between(0, 100),
          "share of the pressure noise that evens out in a sound crossing of a cell [-]");
  declare(valid, "heat conduction", p.heat_conduction, between(0, 100),
          "share of their heat that particles exchange per unit of compression [-]");
  declare(valid, "relaxation interval", p.relaxation_interval, at_least(1),
          "volume, pressure and heat relax once in so many steps, for all of them [steps]");
  declare(valid, "split length", p.split_length, at_least_zero(),
          "particles of fluids longer than this are split; 0: never [cells]");
  declare(
      valid, "summation", std::string("colours"), one_of({"colours", "duplicates"}),
      "how threads add to one node: in blocks of two colours, with the same bits for any number "
      "of threads, or each into a copy of its own [-]");
  declare(valid, "sleep", false, anything(),
          "whether gas at rest that no wave has reached yet is left out of the steps [-]");
  declare_list(valid, "artificial viscosity", "what gives shocks a width") =
      valid_shock_viscosity(p);
  return valid;
}

}  // namespace brisance
