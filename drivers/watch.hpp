#pragma once
// What looks at a run from outside, at each of its outputs or after every step, and has something
// to say at its end. A watch is switched on by a list of the scene that bears its name.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/archive.hpp"
#include "drivers/measure.hpp"

namespace brisance {

class Backlog;
class Simulation;

class Watch {
 public:
  virtual ~Watch() = default;
  /// To be called at each output, the last one at the end of the run, if it looks at particles.
  virtual void observe(const ParticleTable& /*table*/, double /*time*/) {}
  virtual bool looks_at_particles() const { return true; }
  /// To be called at the start and after each step.
  virtual void follow(Simulation& /*simulation*/) {}
  /// Of all that has been observed.
  virtual std::vector<Measure> measures() const = 0;
  /// All that it remembers from one output to the next, for restart.
  virtual void keep(Archive& archive) = 0;
  /// Files of its own, into the folder of the run; forced to the disk as a file is (files.hpp).
  virtual void write(const std::filesystem::path& /*folder*/, Backlog* /*later*/) const {}
};

/// The materials of a scene, in its order.
struct WatchedMaterials {
  std::vector<std::string> names;
  std::vector<bool> fluid;
  /// The place of the name; -1 for a name that there is not.
  int number(const std::string& name) const;
};

/// Adds the lists of all watches to the schema of a scene.
void declare_watches(List& valid, const List& given, const std::vector<std::string>& materials,
                     int dim);
/// What the watches of a scene, as given, will measure.
std::vector<MeasureDoc> watch_docs(const List& given);
/// The watches of a checked scene. Throws InputError for a list that does not fit the scene.
std::vector<std::unique_ptr<Watch>> make_watches(const List& scene);

}  // namespace brisance
