#pragma once
// All that looks at a run from outside: its watches, and its exact solution where that is measured
// along the run.
#include <filesystem>
#include <memory>
#include <vector>

#include "drivers/exact.hpp"
#include "drivers/simulation.hpp"
#include "drivers/watch.hpp"

namespace brisance {

class Observers {
 public:
  /// Of a complete scene; `exact` may be null and must outlive them.
  Observers(const List& scene, ExactSolution* exact);

  bool none() const { return watches_.empty() && !recorded_; }
  /// Whether one of them is to see the particles at outputs.
  bool look_at_particles() const;

  /// To be called at the start and after each step.
  void follow(Simulation& simulation);
  /// To be called at each output.
  void observe(const Snapshot& shot);
  /// Their files, into the folder of the run.
  void write(const std::filesystem::path& folder, Backlog* later) const;

  /// To be called after the last output, with that.
  std::vector<Measure> measures(const Snapshot& end) const;
  void keep(Archive& archive);

 private:
  ExactSolution* exact_;
  ExactSolution* recorded_;  ///< the same if it is measured along the run, or null
  std::vector<std::unique_ptr<Watch>> watches_;
};

}  // namespace brisance
