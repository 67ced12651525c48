#include "drivers/sweep_axes.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cctype>

#include "drivers/sweep.hpp"

namespace brisance {
namespace {

constexpr std::size_t most_runs = 10000;

/// A part of a folder's name: letters, digits and . + -, all others one low line.
std::string speaking(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool kept =
        std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '+' || c == '-';
    if (kept)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  if (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

}  // namespace

std::vector<Axis> axes_of(const List& sweep) {
  const List& vary = sweep.sublist("vary");
  std::vector<Axis> axes;
  for (const auto& name : list_names(vary)) {
    const List& list = vary.sublist(name);
    Axis axis{name, {}};
    for (const auto& value : axis_values(list))
      axis.changes.push_back({get<std::string>(list, "parameter"), value, "vary/" + name,
                              list.isParameter("from") ? "from" : "values"});
    axes.push_back(std::move(axis));
  }
  if (axes.empty()) refuse(vary, "", "must hold a list for a parameter that is varied");
  return axes;
}

std::vector<Change> changes_of(const List& sweep) {
  std::vector<Change> changes;
  for (const auto& part : parts_of(get<std::string>(sweep, "changes"))) {
    const std::size_t equals = part.find('=');
    if (equals == part.npos)
      refuse(sweep, "changes", "must be list/parameter=value, ';' between several");
    changes.push_back({part.substr(0, equals), part.substr(equals + 1), "", "changes"});
  }
  return changes;
}

std::vector<std::vector<Change>> combinations(const List& sweep, const std::vector<Axis>& axes) {
  std::vector<std::vector<Change>> all;
  if (get<std::string>(sweep, "combine") == "zip") {
    const auto count = axes.front().changes.size();
    for (const Axis& axis : axes)
      if (axis.changes.size() != count)
        refuse(sweep.sublist("vary").sublist(axis.name), "",
               "has another number of values than '" + axes.front().name + "', " +
                   std::to_string(axis.changes.size()) + " instead of " + std::to_string(count) +
                   ": combine = zip pairs them");
    for (std::size_t k = 0; k < count; ++k) {
      all.emplace_back();
      for (const Axis& axis : axes) all.back().push_back(axis.changes[k]);
    }
    return all;
  }
  std::size_t count = 1;
  for (const Axis& axis : axes)
    if ((count *= axis.changes.size()) > most_runs)
      refuse(sweep.sublist("vary"), "", "gives more than " + std::to_string(most_runs) + " runs");
  all.resize(count);
  std::size_t repeat = count;
  for (const Axis& axis : axes) {
    repeat /= axis.changes.size();
    for (std::size_t k = 0; k < count; ++k)
      all[k].push_back(axis.changes[k / repeat % axis.changes.size()]);
  }
  return all;
}

std::string name_of(const std::vector<Axis>& axes, const std::vector<Change>& changes) {
  std::string name;
  for (std::size_t k = 0; k < axes.size(); ++k)
    name += (k ? "," : "") + speaking(axes[k].name) + "_" + speaking(changes[k].value);
  return name;
}

}  // namespace brisance
