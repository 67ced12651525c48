#pragma once
// A scene set up and ready to step, whatever its geometry.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/archive.hpp"
#include "drivers/exact.hpp"
#include "drivers/ledger.hpp"
#include "drivers/snapshot.hpp"
#include "drivers/window.hpp"

namespace brisance {

/// What a scene takes.
struct Footprint {
  struct Part {
    std::string name;
    double bytes = 0;  ///< [B]
  };
  std::vector<Part> columns;  ///< per particle, mean over the groups
  double particles = 0, cells = 0;
  double grid_bytes = 0, sort_bytes = 0;  ///< in all [B]
};

class Simulation {
 public:
  virtual ~Simulation() = default;

  virtual double time() const = 0;  // [s]
  virtual double dt() const = 0;    // of the last step, or of the first to come [s]
  virtual long step_count() const = 0;
  /// Those that sleep included.
  virtual long particle_count() const = 0;
  /// What sleeps, where the scene lets gas sleep.
  struct Sleeping {
    long particles = 0;
    double impulse = 0;  ///< size of the momentum that it has taken so far [N s]
  };
  virtual std::optional<Sleeping> sleeping() const { return {}; }

  /// One step, which does not go beyond `end`. Throws std::runtime_error when the state is no
  /// longer finite.
  virtual void advance(double end) = 0;

  virtual Balance balance() const = 0;
  virtual Snapshot snapshot(Snapshot earlier = {}) const = 0;
  virtual Footprint footprint() const = 0;

  /// All that outlives a step. What is read must belong to the same scene.
  virtual void keep(Archive& archive) = 0;

  /// What matter around some places is like.
  virtual std::vector<Seen> probe(const std::vector<Window>& windows) const = 0;
  /// Moves those windows that ride along with matter, by the last step.
  virtual void carry(std::vector<Window>& windows) = 0;
};

/// Sets up a checked scene. `exact` gives initial states to the bodies that ask for it; may be
/// null.
std::unique_ptr<Simulation> make_simulation(const List& scene, const ExactSolution* exact);

}  // namespace brisance
