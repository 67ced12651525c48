#pragma once
// What a scene can be run with, from cheap to accurate, and how wrong a run of it is. The scene's
// list "tradeoff" says both; without one a scene can only be run with a setting that is named.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/batch_record.hpp"
#include "drivers/sweep.hpp"

namespace brisance {

/// What error and cost depend on, in words that mean the same in every scene.
struct Setting {
  std::string preset;
  double resolution = 1;  ///< cells along each direction, over those of the scene
  std::string particles =
      "own";  ///< per cell and direction, in all bodies; or as the scene has them
  double cfl = 0;
  std::string shape;  ///< of fluids; of solids, where there is no fluid

  /// "balanced,x2,particles_3,CFL_0.8,linear": a run and its folder.
  std::string name() const;
  bool operator==(const Setting& other) const { return name() == other.name(); }
};

/// The schema of the list "tradeoff" of a scene that has these measures.
List valid_tradeoff(const std::vector<std::string>& measures);

class TradeoffScene {
 public:
  /// Throws InputError.
  explicit TradeoffScene(const std::string& file);

  const std::string& file() const { return file_; }
  std::string name() const;
  /// Scenes that are alike: "fluid on a line", "fluid and solid in the plane".
  const std::string& family() const { return family_; }
  /// Whether it has the list.
  bool measured() const;

  /// As the scene is with a preset alone.
  Setting preset_alone(const std::string& preset, double resolution) const;

  /// At every resolution each preset alone, with every number of particles and CFL number, and with
  /// every other shape. `quick`: presets alone at the two coarsest. Needs the list.
  std::vector<Setting> settings(bool quick) const;

  /// Whether its cells can be made so much finer or coarser in whole numbers.
  bool allows(double resolution) const;

  /// What --set assigns for a setting, beside --preset. Throws InputError unless allows().
  std::vector<std::string> assignments(const Setting& setting) const;

  /// "brisance run SCENE --preset ... --set ..."
  std::string command(const Setting& setting) const;

  /// On one thread, without files of particles and grid, and without what is checked in the scene.
  PlannedRun planned(const Setting& setting) const;

  /// The run that errors are taken against; false if they are taken against an exact answer.
  bool reference(Setting& setting) const;

  /// Mean of the measures: their magnitudes, or their relative distances from those of the
  /// reference. NaN if one has no value.
  double error(const Record& record, const Record* reference) const;

 private:
  const List& with_preset(const std::string& preset) const;
  std::string own_particles() const;
  const List& tradeoff() const;

  std::string file_;
  std::shared_ptr<const List> scene_;
  mutable std::map<std::string, std::shared_ptr<const List>> with_;  ///< by preset, once asked for
  bool fluid_ = false;
  std::string family_;
};

}  // namespace brisance
