#include <algorithm>
#include <cmath>
#include <set>

#include "drivers/exact_layers.hpp"

namespace brisance {
namespace {

/// The particles of one material, the rest without mass and volume.
ParticleTable only(const ParticleTable& table, int material) {
  ParticleTable part = table;
  for (std::size_t k = 0; k < part.size(); ++k)
    if (part.material[k] != material) part.mass[k] = part.volume[k] = 0;
  return part;
}

}  // namespace

std::vector<MeasureDoc> Layers::possible_measures() {
  return {{"plate velocity error", "-",
           "mean velocity of the plate by mass over that of the reference, less 1"},
          {"L1 pressure of products", "-",
           "error of the cells that hold products alone, here and there, over the reference"},
          {"L1 pressure of gas", "-",
           "error of the cells that hold gas alone, here and there, over the reference"},
          {"interpenetration", "m",
           "greatest way of a layer's foremost particle beyond the hindmost one of the next; "
           "negative: gaps everywhere"}};
}

std::vector<MeasureDoc> Layers::measure_docs() const {
  std::vector<MeasureDoc> docs;
  for (const MeasureDoc& doc : possible_measures()) {
    if (doc.name == "L1 pressure of products" && layer_with(Layer::Law::explosive) < 0) continue;
    if (doc.name == "L1 pressure of gas" && layer_with(Layer::Law::gas) < 0) continue;
    docs.push_back(doc);
  }
  return docs;
}

// Layers keep their order: the material with the k-th smallest mean distance is that of layer k.
std::vector<Measure> Layers::measures(const ParticleTable& table, double t) const {
  struct Matter {
    double mass = 0, moment = 0, momentum = 0;  // [kg], [kg m], [kg m/s]
    double least = 1e300, most = -1e300;        // distances [m]
  };
  std::map<int, Matter> materials;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const Place place = table.place(k), v = table.motion(k);
    const double way = distance(place), m = table.mass[k];
    double outward = v[0];
    if (radial() && way > 0)
      outward = (v[0] * (place[0] - data_.origin[0]) + v[1] * (place[1] - data_.origin[1])) / way;
    Matter& of = materials[table.material[k]];
    of.mass += m;
    of.moment += m * way;
    of.momentum += m * outward;
    of.least = std::min(of.least, way);
    of.most = std::max(of.most, way);
  }
  std::vector<std::pair<double, int>> order;
  for (const auto& [number, of] : materials) order.push_back({of.moment / of.mass, number});
  std::sort(order.begin(), order.end());
  if (order.size() != data_.reference.layers.size())
    throw std::runtime_error("the exact solution has as many layers as the scene has materials");

  const Lagrangian& r = reference(t);
  std::map<std::string, double> values;
  const Matter& plate = materials[order[plate_].second];
  const double exact_velocity = r.mean_velocity(plate_);
  values["plate velocity error"] =
      relative(plate.momentum / plate.mass - exact_velocity, exact_velocity);
  values["interpenetration"] = -1e300;
  for (std::size_t k = 0; k + 1 < order.size(); ++k)
    values["interpenetration"] =
        std::max(values["interpenetration"],
                 materials[order[k].second].most - materials[order[k + 1].second].least);

  const std::vector<Sums> all = sums_per_cell(table);
  const auto error_of = [&](int layer) {
    const std::vector<Sums> own = sums_per_cell(only(table, order[layer].second));
    const auto [begin, end] = r.ends_of(layer);
    double error = 0, scale = 0;
    for (std::size_t c = 0; c < own.size(); ++c) {
      if (own[c].empty() || own[c].mass < all[c].mass * (1 - 1e-12)) continue;
      const int i = static_cast<int>(c) % table.cells[0], j = static_cast<int>(c) / table.cells[0];
      const Place centre{table.layer_centre(0, i), table.layer_centre(1, j), 0};
      const double way = distance(centre), half = 0.5 * table.cell_size;
      if (way - half < begin || way + half > end) continue;  // there, two materials share it
      const double exact = at(centre, t).p;
      error += std::abs(own[c].mean_pressure() - exact);
      scale += exact;
    }
    return relative(error, scale);
  };
  const int products = layer_with(Layer::Law::explosive), gas = layer_with(Layer::Law::gas);
  if (products >= 0) values["L1 pressure of products"] = error_of(products);
  if (gas >= 0) values["L1 pressure of gas"] = error_of(gas);
  return with_values(measure_docs(), values);
}

}  // namespace brisance
