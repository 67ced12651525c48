#pragma once
// Explosive, plates and gas in layers, the answer worked out on cells that move with the matter.
#include <optional>

#include "drivers/exact.hpp"
#include "drivers/lagrange.hpp"

namespace brisance {

/// Layers from an origin outward, along x or from an axis; the explosive is lit at the origin.
class Layers final : public ExactSolution {
 public:
  struct Data {
    Lagrangian::Data reference;
    std::string plate;  // the layer whose velocity is measured
    Place origin{};     // where the axis is, or the layers begin [m]
  };
  explicit Layers(const Data& data);
  explicit Layers(const List& list);
  static List valid_parameters(const List& given);
  static std::vector<MeasureDoc> possible_measures();

  bool radial() const override { return data_.reference.cylindrical; }
  Place centre() const override { return data_.origin; }
  int least_dim() const override { return radial() ? 2 : 1; }
  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override;
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
  int plate_ = 0;
  /// At the latest time asked for: times are asked for in ascending order, mostly.
  mutable std::optional<Lagrangian> latest_;

  const Lagrangian& reference(double t) const;
  double distance(const Place& x) const;
  int layer_with(Layer::Law law) const;  // the first one; -1: none
};

}  // namespace brisance
