#include "drivers/scene.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <array>

#include "core/transfer.hpp"
#include "drivers/checkpoint.hpp"
#include "drivers/checks_schema.hpp"
#include "drivers/exact.hpp"
#include "drivers/lighting.hpp"
#include "drivers/output_choice.hpp"
#include "drivers/plausible.hpp"
#include "drivers/presets.hpp"
#include "drivers/shapes.hpp"
#include "drivers/sleep.hpp"
#include "drivers/springs.hpp"
#include "drivers/watch.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

List empty_or(const List* list) { return list ? *list : List(); }

bool has(const List& list, const std::string& name) {
  const auto present = names(list);
  return std::find(present.begin(), present.end(), name) != present.end();
}

/// The law that is given under a name; "" if there is none such.
std::string law_of(const List& materials, const std::string& name) {
  const List* given = find_list(materials, name);
  if (!given || !has(*given, "law")) return "";
  return peek<std::string>(*given, valid_material(*given, List()), "law");
}

/// Whether a law that is given is that of a fluid, or of a solid.
bool any(const List& materials, bool fluid) {
  for (const auto& name : list_names(materials)) {
    const std::string law = law_of(materials, name);
    if (!law.empty() && is_fluid(law) == fluid) return true;
  }
  return false;
}

Preset chosen_preset(const List& given, const List& materials) {
  List valid;
  declare(valid, "preset", "balanced", one_of({"paper", "fast", "balanced", "accurate"}),
          "scheme whose defaults are used [-]");
  declare(valid, "geometry", "line", one_of({"line", "plane strain"}), "[-]");
  return preset(peek<std::string>(given, valid, "preset"),
                peek<std::string>(given, valid, "geometry") == "line" ? 1 : 2,
                any(materials, false) && any(materials, true));
}

/// A number of a material that is given. One that is missing is left for the check of the materials
/// to tell.
double number_of(const List& materials, const std::string& name, const char* parameter) {
  const List& given = *find_list(materials, name);
  const List valid = valid_material(given, List());
  const bool missing = !has(given, parameter) && described(valid, parameter).required;
  return missing ? 1 : peek<double>(given, valid, parameter);
}

void add_grid(List& valid, int dim) {
  List& grid = declare_list(valid, "grid", "the background grid of square cells");
  declare(grid, "origin", std::vector<double>(dim, 0.0), anything() && entries(dim),
          "low corner [m]");
  declare_required<std::vector<int>>(grid, "cells", at_least(1) && entries(dim),
                                     "cells along each direction [-]");
  declare_required<double>(grid, "cell size", positive(), "edge of a cell [m]");
}

void add_boundaries(List& valid, int dim) {
  List& ends = declare_list(valid, "boundaries", "what happens at the ends of the grid");
  for (int d = 0; d < dim; ++d)
    for (const char* end : {" low", " high"})
      declare(ends, std::string(axes[d]) + end, "wall",
              one_of({"wall", "fixed", "free", "periodic"}),
              "frictionless wall, fixed wall, empty space, or joined to the other end [-]");
}

void add_time(List& valid, const Preset& preset) {
  List& time = declare_list(valid, "time", "how far, and in which steps");
  declare_required<double>(time, "end", positive(), "simulated time [s]");
  declare(time, "CFL", preset.cfl, above(0) && at_most(0.95),
          "cells that the fastest signal may cross in a step [-]");
  declare(time, "largest growth", 1.2, between(1, 10),
          "factor by which a step may exceed the one before [-]");
  declare(time, "largest volume change", preset.largest_volume_change, between(1e-6, 0.9),
          "share of its volume that a particle may gain or lose in a step [-]");
}

List valid_body(const List& given, const List& materials, int dim) {
  List valid;
  declare_required<std::string>(valid, "material", one_of(list_names(materials)),
                                "name of its material [-]");
  const std::string material = peek<std::string>(given, valid, "material"),
                    law = law_of(materials, material);
  const bool solid = !law.empty() && !is_fluid(law), explosive = law == Jwl::name;
  declare(valid, "edge", solid ? "points" : "cells", one_of({"points", "cells"}),
          "whether it owns single points, or whole cells by their centres [-]");
  declare(valid, "particles per cell", 3, at_least(1) && at_most(16),
          "particles along each direction of a cell [-]");
  if (solid || explosive)
    declare(valid, "may overlap", false, anything(),
            "whether earlier bodies of other solids and explosives may own a part of it without "
            "lying within it [-]");
  declare(valid, "initial state", "uniform", one_of({"uniform", "exact"}),
          "uniform, or that of the exact solution at time 0 [-]");
  if (peek<std::string>(given, valid, "initial state") == "uniform") {
    const bool liquid = law == LinearFluid::name;
    if (liquid)
      LinearFluid(number_of(materials, material, "bulk modulus"),
                  number_of(materials, material, "density"))
          .declare_state(valid, given);
    else if (solid || explosive)
      declare(valid, "density", number_of(materials, material, "density"), positive(),
              "density [kg/m^3]");
    else
      declare_required<double>(valid, "density", positive(), "density [kg/m^3]");
    if (has(given, "specific energy") && has(given, "pressure"))
      refuse(given, "specific energy", "is given beside 'pressure': give one of the two");
    if (solid)
      declare(valid, "pressure", 0.0, between(-1e15, 1e15),
              "pressure, compression positive [Pa]");
    else if (explosive && !has(given, "pressure"))
      declare(valid, "specific energy",
              number_of(materials, material, "energy density") /
                  number_of(materials, material, "density"),
              at_least_zero(), "specific internal energy [J/kg]");
    else if (has(given, "specific energy") && !liquid)
      declare_required<double>(valid, "specific energy", at_least_zero(),
                               "specific internal energy [J/kg]");
    else if (!liquid)
      declare_required<double>(valid, "pressure", at_least_zero(), "pressure [Pa]");
    declare(valid, "velocity", std::vector<double>(dim, 0.0), anything() && entries(dim),
            "velocity [m/s]");
  }
  declare_shapes(valid, given, dim);
  return valid;
}

void check_pairs(const List& scene, int dim) {
  const List& ends = scene.sublist("boundaries");
  for (int d = 0; d < dim; ++d) {
    const std::string low = std::string(axes[d]) + " low", high = std::string(axes[d]) + " high";
    const bool a = get<std::string>(ends, low) == "periodic",
               b = get<std::string>(ends, high) == "periodic";
    if (a != b) refuse(ends, a ? high : low, "must be periodic too: the two ends are joined");
  }
  const List& grid = scene.sublist("grid");
  double nodes = 1;
  for (const int n : get<std::vector<int>>(grid, "cells")) nodes *= n + 3.0;
  if (nodes > 2e9) refuse(grid, "cells", "must be fewer than 2e9 in all");
}

void check_transfer(const List& scheme, const std::string& quadrature, bool midpoint) {
  const auto text = [&](const char* name) { return get<std::string>(scheme, name); };
  const std::string rule = broken_rule({text("shape"), text("transfer"), quadrature});
  if (!rule.empty()) refuse(scheme, quadrature == "cell" ? "quadrature" : "transfer", rule);
  if (!midpoint && text("transfer") != "FLIP")
    refuse(scheme, "transfer", "must be 'FLIP' with MUSL");
}

void check_scheme(const List& scene) {
  const List& scheme = scene.sublist("scheme");
  const bool midpoint = get<std::string>(scheme, "integration") == "midpoint";
  check_transfer(scheme, get<std::string>(scheme, "quadrature"), midpoint);
  if (const List* solids = find_list(scheme, "solids"))
    check_transfer(*solids, "particle", midpoint);
  check_sleep(scheme);
  if (midpoint) return;
  for (const char* name : {"volume relaxation", "pressure relaxation", "heat conduction"})
    if (get<double>(scheme, name) > 0)
      refuse(scheme, name, "must be 0 with MUSL: it needs the midpoint's energy");
  if (const List* solids = find_list(scheme, "solids"))
    if (get<double>(*solids, "stress relaxation") > 0)
      refuse(*solids, "stress relaxation", "must be 0 with MUSL");
}

void check_bodies(const List& scene) {
  const List& bodies = scene.sublist("bodies");
  for (const auto& name : list_names(bodies)) {
    const List& body = bodies.sublist(name);
    check_shape(body);
    if (get<std::string>(body, "initial state") == "exact" && !find_list(scene, "exact"))
      refuse(body, "initial state", "needs a list 'exact' in the scene");
  }
}

}  // namespace

int dimension(const List& scene) { return get<std::string>(scene, "geometry") == "line" ? 1 : 2; }

List valid_scene(const List& given) {
  List valid;
  declare(valid, "title", "", anything(), "what the scene shows, in a line [-]");
  declare_required<std::string>(valid, "geometry", one_of({"line", "plane strain"}),
                                "line: a slab of unit area; plane strain: unit thickness [-]");
  declare(valid, "preset", "balanced", one_of({"paper", "fast", "balanced", "accurate"}),
          "scheme whose defaults are used [-]");
  const int dim = peek<std::string>(given, valid, "geometry") == "line" ? 1 : 2;
  const List given_materials = empty_or(find_list(given, "materials"));
  const Preset preset = chosen_preset(given, given_materials);
  add_grid(valid, dim);
  add_boundaries(valid, dim);
  add_time(valid, preset);
  List& scheme = declare_list(valid, "scheme", "the method");
  scheme = valid_scheme(preset);
  if (any(given_materials, false))
    declare_list(scheme, "solids", "the method for solids") = valid_solid_scheme(preset);

  List& materials =
      declare_list(valid, "materials", "one list for each material, under a name of its own");
  for (const auto& name : list_names(given_materials))
    declare_list(materials, name, "a material") =
        valid_material(*find_list(given_materials, name), valid_shock_viscosity(preset));

  const List given_bodies = empty_or(find_list(given, "bodies"));
  List& bodies =
      declare_list(valid, "bodies", "one list for each body; the first that holds a place owns it");
  for (const auto& name : list_names(given_bodies))
    declare_list(bodies, name, "a body") =
        valid_body(*find_list(given_bodies, name), given_materials, dim);

  declare_optional_list(valid, "ignition", "what lights the explosives, and when") =
      valid_ignition(empty_or(find_list(given, "ignition")), dim);
  List& springs =
      declare_optional_list(valid, "springs", "one list for each spring that holds a material");
  for (const auto& name : list_names(empty_or(find_list(given, "springs"))))
    declare_list(springs, name, "a spring") = valid_spring(list_names(given_materials), dim);

  declare_list(valid, "output", "what is written while the run goes on") =
      OutputChoice::valid_parameters(given_materials, dim);
  declare_optional_list(valid, "checkpoint", "states of the run, from which it can go on later") =
      Checkpoints::valid_parameters();
  const List* exact = find_list(given, "exact");
  List& exact_list =
      declare_optional_list(valid, "exact", "the known answer that the run is measured against");
  if (exact) exact_list = valid_exact(*exact);
  declare_watches(valid, given, list_names(given_materials), dim);
  declare_checks(valid, given, list_names(given_materials), any(given_materials, false), dim);
  return valid;
}

List complete_scene(const List& given) {
  const List scene = check(given, valid_scene(given));
  if (list_names(scene.sublist("materials")).empty())
    refuse(scene, "materials", "must name a material");
  if (list_names(scene.sublist("bodies")).empty()) refuse(scene, "bodies", "must name a body");
  check_pairs(scene, dimension(scene));
  check_scheme(scene);
  check_springs(scene);
  check_bodies(scene);
  OutputChoice::check(scene.sublist("output"));
  if (const List* ignition = find_list(scene, "ignition")) check_ignition(*ignition);
  make_watches(scene);  // each refuses what it cannot watch
  check_plausible(scene);
  return scene;
}

}  // namespace brisance
