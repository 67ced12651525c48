#pragma once
// What a charge, with or without a case, does in a box: Hu & Chen (2006), section 5. Switched on by
// the scene's list "burst".
#include <array>
#include <string>
#include <vector>

#include "drivers/box.hpp"
#include "drivers/watch.hpp"

namespace brisance {

class BurstWatch final : public Watch {
 public:
  BurstWatch(const List& list, const WatchedMaterials& materials);
  static List valid_parameters(const std::vector<std::string>& materials, int dim);
  /// Of a list as given: what there is no material for is not measured.
  static std::vector<MeasureDoc> measure_docs(const List& given);

  void observe(const ParticleTable& table, double time) override;
  std::vector<Measure> measures() const override;
  void keep(Archive& archive) override;

 private:
  std::vector<bool> fluid_;
  int case_ = -1, wall_ = -1, products_ = -1;  ///< numbers of materials; -1: there is none
  std::array<double, 3> centre_{};
  double inner_ = 0, symmetric_until_ = 0;  // [m], [s]
  std::vector<MeasureDoc> docs_;

  double velocity_, velocity_time_;         ///< of the case, greatest so far [m/s], [s]
  double case_arrival_, products_arrival_;  ///< at the wall; nan: not yet [s]
  double asymmetry_ = 0;
  Overlap overlap_;
  WallDamage damage_;
};

}  // namespace brisance
