#pragma once
// Parameters on top of Teuchos. A schema is a Teuchos::ParameterList of defaults whose entries
// carry a rule and a documentation: declare() builds it, check() completes by it what was given,
// get() reads the result. T is one of double, int, bool, std::string and the vectors of double, int
// and std::string. Host only.
#include <string>
#include <vector>

#include "core/rule.hpp"

namespace Teuchos {
class ParameterList;
}

namespace brisance {

using List = Teuchos::ParameterList;

/// Adds a parameter to a schema. The documentation ends with the unit: "ratio of specific heats
/// [-]". Throws InputError when the default breaks its own rule, std::logic_error without a unit.
template <class T>
void declare(List& valid, const std::string& name, const T& standard, const Rule& rule,
             const std::string& doc);
void declare(List& valid, const std::string& name, const char* standard, const Rule& rule,
             const std::string& doc);

/// The same for a parameter that has no default and must be given.
template <class T>
void declare_required(List& valid, const std::string& name, const Rule& rule,
                      const std::string& doc);

/// Adds a list that is always there: check() fills in its defaults. Fill it entry by entry or by
/// assignment: `declare_list(valid, "air", "...") = PerfectGas::valid_parameters();`
List& declare_list(List& valid, const std::string& name, const std::string& doc);

/// Adds a list that switches something on by its presence: check() leaves it out unless it was
/// given.
List& declare_optional_list(List& valid, const std::string& name, const std::string& doc);

/// What was given, completed by the defaults, in the order of the schema, without rules and
/// documentation. An int given for a double becomes one. Throws InputError: unknown, missing, wrong
/// type, rule broken.
List check(const List& given, const List& valid);

/// One parameter of `given` as check() would complete it, for schemas that depend on a choice
/// ("law").
template <class T>
T peek(const List& given, const List& valid, const std::string& name);

/// The value of a parameter; InputError when it is missing or of another type. The second form
/// keeps Teuchos::get, which knows no std::vector, from being the better match for a list that is
/// not const.
template <class T>
T get(const List& list, const std::string& name);
template <class T>
T get(List& list, const char* name) {
  return get<T>(static_cast<const List&>(list), std::string(name));
}

/// The sublist of that name or nullptr; InputError when the name is a parameter.
const List* find_list(const List& list, const std::string& name);

/// The names of the sublists, in the order of the input.
std::vector<std::string> list_names(const List& list);

/// The names of everything in the list, in its order.
std::vector<std::string> names(const List& list);

/// Where a list stands: "materials/air"; empty for the top.
std::string path_of(const List& list);

/// Throws the InputError for a parameter of a list: refuse(list, "end", "must be after 'start'").
/// An empty name refuses the list.
[[noreturn]] void refuse(const List& list, const std::string& name, const std::string& rule);

/// What an entry of a list is, as text. Rule, documentation, unit and the two flags come from a
/// schema.
struct Described {
  std::string
      type;  // as in the XML: "double", "Array(int)"; "list" for a list; empty: none of ours
  std::string value;      // reads back to the same value: 0.1, true, {1, 2}
  std::string rule;       // "a number > 0"
  std::string doc;        // without unit
  std::string unit;       // "[Pa]"
  bool required = false;  // a parameter without default
  bool optional = false;  // a list that may be absent
};
Described described(const List& list, const std::string& name);

}  // namespace brisance
