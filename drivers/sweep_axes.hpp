#pragma once
// What a sweep assigns to the parameters of its scene, run by run.
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace brisance {

/// An assignment to a parameter of the scene, and where in the sweep it stands.
struct Change {
  std::string path, value;
  std::string list, parameter;
  std::string option() const { return path + "=" + value; }
};

struct Axis {
  std::string name;
  std::vector<Change> changes;  ///< one for each value
};

/// The lists of "vary" of a checked sweep. Throws InputError if there are none.
std::vector<Axis> axes_of(const List& sweep);

/// What "changes" says for all runs.
std::vector<Change> changes_of(const List& sweep);

/// One change of each axis, for every run; the last axis varies fastest. Throws InputError for
/// more than 10000 runs, and for values that cannot be paired.
std::vector<std::vector<Change>> combinations(const List& sweep, const std::vector<Axis>& axes);

/// The name of a run for people and for folders: "charge_radius_0.05,end_0.001".
std::string name_of(const std::vector<Axis>& axes, const std::vector<Change>& changes);

}  // namespace brisance
