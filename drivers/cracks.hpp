#pragma once
// What a hit has done to a wall of concrete: where it is damaged and has come apart, measured about
// the line of the hit. Switched on by the scene's list "cracks".
#include <map>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/watch.hpp"

namespace brisance {

class CrackPattern final : public Watch {
 public:
  explicit CrackPattern(const List& list);
  static List valid_parameters(int dim);
  static std::vector<MeasureDoc> measure_docs();

  /// Throws std::runtime_error if there is no concrete.
  void observe(const ParticleTable& table, double time) override;
  /// In the order of measure_docs().
  std::vector<Measure> measures() const override;
  void keep(Archive& archive) override;

 private:
  int along_ = 0;        ///< direction of the hit
  double middle_ = 0;    ///< where its line is across [m]
  double size_ = 1;      ///< of what hits [m]
  double pressure_ = 0;  ///< greatest so far [Pa]
  double onset_ = 0;     ///< time of the first output with decohesion; 0: none so far [s]
  std::map<std::string, double> last_;  ///< measures of the last output

  std::map<std::string, double> pattern_of(const ParticleTable& table) const;
};

}  // namespace brisance
