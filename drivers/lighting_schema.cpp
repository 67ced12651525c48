// The list "ignition".
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/exact_parameters.hpp"
#include "drivers/lighting.hpp"

namespace brisance {
namespace {

using Doubles = std::vector<double>;

void declare_place(List& valid, const std::string& name, int dim, const std::string& doc) {
  declare_required<Doubles>(valid, name, anything() && entries(dim), doc);
}

List valid_source(const List& given, int dim) {
  List valid;
  declare(valid, "delay", 0.0, anything(), "when it lights [s]");
  const auto present = names(given);
  const auto has = [&](const char* name) {
    return std::find(present.begin(), present.end(), name) != present.end();
  };
  if (has("line") + has("plane") + has("point") > 1)
    refuse(given, "", "has more than one of 'point', 'line' and 'plane'");
  if (!has("line") && !has("plane")) declare_place(valid, "point", dim, "it is a point: where [m]");
  List& line = declare_optional_list(valid, "line", "it is a straight line");
  declare_place(line, "from", dim, "one end [m]");
  declare_place(line, "to", dim, "the other end [m]");
  List& plane = declare_optional_list(
      valid, "plane", "it is a plane without end, from which waves run in both directions");
  declare_place(plane, "point", dim, "a place in it [m]");
  declare_place(plane, "normal", dim, "direction across it, of any length [-]");
  return valid;
}

/// Declares a list that holds lists of names of their own, all of one kind.
template <class F>
void fill_kinds(List& valid, const List& given, const std::string& name, const std::string& doc,
                const F& valid_one) {
  const List* lists = find_list(given, name);
  if (!lists) return;
  for (const auto& one : list_names(*lists))
    declare_list(valid, one, doc) = valid_one(lists->sublist(one));
}

}  // namespace

List valid_ignition(const List& given, int dim) {
  List valid;
  declare(valid, "path", "straight", one_of({"straight", "through explosive"}),
          "straight: whatever lies between, at the speed of the explosive that is lit; through "
          "explosive: along the fastest way through explosives, round what is inert; what no way "
          "leads to has the lighting time 1e30 s [-]");
  declare(valid, "refinement", 1, at_least(1) && at_most(16),
          "cells, along the edge of a cell of the grid, on which ways through explosive are found; "
          "gaps narrower than two of them may be closed [-]");
  fill_kinds(declare_list(valid, "sources", "one list for each, under a name of its own"), given,
             "sources", "where a detonation starts",
             [&](const List& one) { return valid_source(one, dim); });
  fill_kinds(declare_optional_list(valid, "obstacles",
                                   "round inert bodies that ways through explosive run round, one "
                                   "list for each, under a name of its own"),
             given, "obstacles", "a disc", [&](const List&) {
               List disc;
               declare_place(disc, "centre", dim, "centre [m]");
               declare_required<double>(disc, "radius", positive(), "radius [m]");
               return disc;
             });
  return valid;
}

void check_ignition(const List& checked) {
  const List& sources = checked.sublist("sources");
  if (list_names(sources).empty()) refuse(sources, "", "must name a source");
  for (const auto& name : list_names(sources)) {
    const List* plane = find_list(sources.sublist(name), "plane");
    if (!plane) continue;
    const auto normal = get<Doubles>(*plane, "normal");
    if (std::all_of(normal.begin(), normal.end(), [](double n) { return n == 0; }))
      refuse(*plane, "normal", "must have a direction");
  }
  const List* obstacles = find_list(checked, "obstacles");
  if (!obstacles) return;
  if (get<std::string>(checked, "path") == "straight")
    refuse(*obstacles, "", "needs 'path' = 'through explosive': straight paths see none");
  for (const auto& name : list_names(*obstacles))
    if (get<Doubles>(obstacles->sublist(name), "centre").size() < 2)
      refuse(*obstacles, "", "needs a plane: on a line nothing runs round a disc");
}

}  // namespace brisance
