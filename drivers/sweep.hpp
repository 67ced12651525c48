#pragma once
// A sweep: one scene, and parameters of it that are varied. An XML file like a scene's, whose lists
// are told by `brisance describe sweep`.
#include <string>
#include <utility>
#include <vector>

#include "core/parameters.hpp"

namespace brisance {

/// Something that a table or an axis shows: "mid wall arrival", "s". The unit "-" means none.
struct Quantity {
  std::string name, unit;
  /// "mid wall arrival [s]"
  std::string label() const { return unit == "-" ? name : name + " [" + unit + "]"; }
};

/// One run of a batch.
struct PlannedRun {
  std::string name;    ///< of its folder and its scene: "charge_radius_0.05,end_0.001"
  std::string source;  ///< the file that it comes from
  std::string input;   ///< XML of its complete scene
  std::vector<std::pair<Quantity, std::string>> varied;  ///< with their values
  int threads = 1;                                       ///< as many as pay
};

/// Results against a parameter that is varied.
struct Picture {
  std::string file, title;  ///< "sweep_charge.png"
  Quantity x;
  std::vector<Quantity> by, y;  ///< a line for each combination of `by`
};

struct BatchPlan {
  std::string name;
  std::vector<PlannedRun> runs;
  std::vector<Quantity> results;
  std::vector<Picture> pictures;
};

/// Whether an input that was read is a sweep and no scene.
bool is_sweep(const List& given);

/// The schema of a sweep; `given` decides where there is a choice.
List valid_sweep(const List& given);

/// The schema of one of its lists "vary/NAME".
List valid_axis(const List& given);

/// The values of a checked list "vary/NAME" as they would stand in a scene.
std::vector<std::string> axis_values(const List& axis);

/// "a; b" -> {"a", "b"}
std::vector<std::string> parts_of(const std::string& text);

/// All runs of a sweep, each with a scene that is complete and consistent. Throws InputError with
/// file and line: of the sweep for what it varies, of the scene for the rest.
BatchPlan expand_sweep(const std::string& file);

}  // namespace brisance
