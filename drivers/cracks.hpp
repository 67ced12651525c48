#pragma once
// What a hit has done to a wall of concrete: where it is damaged and has come apart, measured about
// the line of the hit. Switched on by the scene's list "cracks".
#include <vector>

#include "core/parameters.hpp"
#include "drivers/archive.hpp"
#include "drivers/measure.hpp"

namespace brisance {

class CrackPattern {
 public:
  explicit CrackPattern(const List& list);
  static List valid_parameters(int dim);
  static std::vector<MeasureDoc> measure_docs();

  /// To be called at each output: notes what is largest on the way.
  void observe(const ParticleTable& table, double time);
  /// Of the table at the end, in the order of measure_docs().
  std::vector<Measure> measures(const ParticleTable& table) const;
  /// All that it remembers from one output to the next, for restart.
  void keep(Archive& archive);

 private:
  int along_ = 0;        ///< direction of the hit
  double middle_ = 0;    ///< where its line is across [m]
  double size_ = 1;      ///< of what hits [m]
  double pressure_ = 0;  ///< greatest so far [Pa]
  double onset_ = 0;     ///< time of the first output with decohesion; 0: none so far [s]
};

}  // namespace brisance
