#pragma once
// When a run writes: its outputs, by simulated time or by steps, and lines of the history between.
#include "core/parameters.hpp"
#include "drivers/cadence.hpp"

namespace brisance {

class OutputTimes {
 public:
  /// Of a complete scene.
  explicit OutputTimes(const List& scene);

  /// Whether a list "output" asks for outputs by steps. One of an earlier version does not know it.
  static bool by_steps(const List& output);

  enum class Due { nothing, line, output };
  /// To be asked after each step.
  Due due(long step, double time);

  void keep(Archive& archive);

 private:
  long steps_;
  Cadence outputs_, lines_;
};

}  // namespace brisance
