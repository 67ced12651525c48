#include "drivers/exact_layers.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/exact_detonation.hpp"
#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

const char* const kind_doc = "what its material is [-]";

List valid_layer(const List& given) {
  List valid;
  declare_required<std::string>(valid, "law", one_of({"jwl", "perfect gas", "von mises"}),
                                kind_doc);
  const std::string law = peek<std::string>(given, valid, "law");
  declare_required<double>(valid, "thickness", positive(), "of the layer [m]");
  if (law == "jwl") {
    declare_products(valid);
    declare_required<double>(valid, "detonation speed", positive(),
                             "at which it is lit from the origin [m/s]");
  } else if (law == "perfect gas") {
    declare_gamma(valid);
    declare_required<double>(valid, "density", positive(), "at the start [kg/m^3]");
    declare_required<double>(valid, "specific energy", positive(), "at the start [J/kg]");
  } else {
    declare_plate(valid);
    declare_required<double>(valid, "yield stress", positive(), "that of the material [Pa]");
  }
  return valid;
}

Layer layer_of(const List& list, const std::string& name) {
  Layer layer;
  layer.name = name;
  layer.thickness = get<double>(list, "thickness");
  layer.density = get<double>(list, "density");
  const std::string law = get<std::string>(list, "law");
  if (law == "jwl") {
    layer.law = Layer::Law::explosive;
    layer.products = std::make_shared<const Jwl>(products_of(list));
    layer.energy = layer.products->energy0;
    layer.detonation_speed = get<double>(list, "detonation speed");
  } else if (law == "perfect gas") {
    layer.gamma = get<double>(list, "gamma");
    layer.energy = get<double>(list, "specific energy");
  } else {
    layer.law = Layer::Law::steel;
    layer.steel = plate_of(list);
    layer.yield = get<double>(list, "yield stress");
  }
  return layer;
}

Layers::Data data_of(const List& list) {
  Layers::Data data;
  const List& layers = list.sublist("layers");
  for (const auto& name : list_names(layers))
    data.reference.layers.push_back(layer_of(layers.sublist(name), name));
  if (data.reference.layers.empty()) refuse(layers, "", "must name a layer");
  data.reference.cylindrical = get<std::string>(list, "symmetry") == "cylindrical";
  data.reference.low_wall = get<std::string>(list, "inner end") == "wall";
  data.reference.high_wall = get<std::string>(list, "outer end") == "wall";
  data.reference.cell_size = get<double>(list, "cell size");
  double cells = 0;
  for (const Layer& layer : data.reference.layers)
    cells += layer.thickness / data.reference.cell_size;
  if (cells > 1e6) refuse(list, "cell size", "cuts the layers into more than 1e6 cells");
  data.origin = place_of(list, "origin");
  if (!data.reference.cylindrical) data.reference.origin = data.origin[0];
  data.plate = get<std::string>(list, "plate");
  const auto names = list_names(layers);
  if (std::find(names.begin(), names.end(), data.plate) == names.end())
    refuse(list, "plate", "must be the name of a layer");
  return data;
}

}  // namespace

List Layers::valid_parameters(const List& given) {
  List valid = list_for_solution("layers");
  declare(valid, "symmetry", "plane", one_of({"plane", "cylindrical"}),
          "whether layers follow along x, or from an axis outward [-]");
  declare(valid, "origin", std::vector<double>{0}, anything(),
          "where the first layer begins, or where the axis is [m]");
  declare(valid, "inner end", "wall", one_of({"wall", "free"}), "of the first layer [-]");
  declare(valid, "outer end", "wall", one_of({"wall", "free"}), "of the last layer [-]");
  declare_required<double>(valid, "cell size", positive(),
                           "of the cells that move with the matter, at the start [m]");
  declare_required<std::string>(valid, "plate", anything(),
                                "name of the layer whose velocity is measured [-]");
  List& layers = declare_list(valid, "layers",
                              "one list for each layer, outward, under a name of its own; each has "
                              "a material of its own in the scene");
  if (const List* named = find_list(given, "layers"))
    for (const auto& name : list_names(*named))
      declare_list(layers, name, "a layer") = valid_layer(*find_list(*named, name));
  return valid;
}

Layers::Layers(const List& list) : Layers(data_of(list)) {}

Layers::Layers(const Data& data) : data_(data) {
  const auto& layers = data.reference.layers;
  plate_ =
      static_cast<int>(std::find_if(layers.begin(), layers.end(),
                                    [&](const Layer& layer) { return layer.name == data.plate; }) -
                       layers.begin());
}

const Lagrangian& Layers::reference(double t) const {
  if (!latest_ || latest_->time() > t) latest_.emplace(data_.reference);
  latest_->advance_to(t);
  return *latest_;
}

double Layers::distance(const Place& x) const {
  return radial() ? std::hypot(x[0] - data_.origin[0], x[1] - data_.origin[1]) : x[0];
}

int Layers::layer_with(Layer::Law law) const {
  const auto& layers = data_.reference.layers;
  const auto found = std::find_if(layers.begin(), layers.end(),
                                  [&](const Layer& layer) { return layer.law == law; });
  return found == layers.end() ? -1 : static_cast<int>(found - layers.begin());
}

// Cells are interpolated between their centres within a layer.
MatterState Layers::at(const Place& x, double t) const {
  const Lagrangian& r = reference(t);
  const double way = distance(x);
  const auto& ends = r.places();
  MatterState s;
  if (way < ends.front() || way >= ends.back()) return s;
  const std::size_t i = std::upper_bound(ends.begin(), ends.end(), way) - ends.begin() - 1;
  const auto& cells = r.cells();
  std::size_t a = i, b = i;
  if (way < r.centre(i)) {
    if (i > 0 && cells[i - 1].layer == cells[i].layer) --a;
  } else if (i + 1 < cells.size() && cells[i + 1].layer == cells[i].layer) {
    ++b;
  }
  const double share = a == b ? 0 : (way - r.centre(a)) / (r.centre(b) - r.centre(a));
  const auto between = [&](double at_a, double at_b) { return at_a + share * (at_b - at_a); };
  s.rho = between(cells[a].mass / cells[a].volume, cells[b].mass / cells[b].volume);
  s.p = between(cells[a].pressure, cells[b].pressure);
  s.e = between(cells[a].energy, cells[b].energy);
  const double along = (way - ends[i]) / (ends[i + 1] - ends[i]);
  const double v = r.velocities()[i] + along * (r.velocities()[i + 1] - r.velocities()[i]);
  if (!radial()) s.v[0] = v;
  for (int d = 0; d < 2 && radial() && way > 0; ++d) s.v[d] = v * (x[d] - data_.origin[d]) / way;
  return s;
}

std::vector<Measure> Layers::features(double t) const {
  const Lagrangian& r = reference(t);
  return {{"plate velocity", r.mean_velocity(plate_), "m/s", "mean by mass"},
          {"energy error of the reference", r.energy_error(), "-", "over the energy at the start"},
          {"steps of the reference", static_cast<double>(r.steps()), "-", "up to this time"}};
}

}  // namespace brisance
