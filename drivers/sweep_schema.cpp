// What a sweep may say, and the values that a parameter takes.
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drivers/sweep.hpp"

namespace brisance {
namespace {

constexpr int most_values = 10000;

bool has(const List& list, const std::string& name) { return list.isParameter(name); }

/// Twelve digits, so that 0.1 + 2 * 0.05 is called 0.2.
std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

std::vector<std::string> range_values(const List& axis) {
  const double from = get<double>(axis, "from"), to = get<double>(axis, "to");
  const bool geometric = get<std::string>(axis, "spacing") == "geometric";
  if (geometric && !(from * to > 0))
    refuse(axis, "spacing", "needs 'from' and 'to' of the same sign, none of them 0");
  const int count = get<int>(axis, "count");
  std::vector<std::string> values;
  for (int k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / (count - 1);
    values.push_back(
        short_text(geometric ? from * std::pow(to / from, share) : from + (to - from) * share));
  }
  return values;
}

template <class T>
std::vector<std::string> texts(const std::vector<T>& values) {
  std::vector<std::string> all;
  for (const T& value : values) all.push_back(text_of(value));
  return all;
}

}  // namespace

bool is_sweep(const List& given) {
  return has(given, "base") || (has(given, "vary") && given.isSublist("vary"));
}

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::size_t first = part.find_first_not_of(' ');
    if (first != part.npos)
      parts.push_back(part.substr(first, part.find_last_not_of(' ') - first + 1));
    begin = end + 1;
  }
  return parts;
}

List valid_axis(const List& given) {
  List valid;
  declare_required<std::string>(valid, "parameter", anything(),
                                "what is varied: list/parameter of the scene [-]");
  if (has(given, "from") || has(given, "to") || has(given, "count")) {
    const char* in_its_unit = "in the unit of the parameter [-]";
    if (has(given, "values"))
      refuse(given, "values", "is given beside a range: give one of the two");
    declare_required<double>(valid, "from", anything(), std::string("first value, ") + in_its_unit);
    declare_required<double>(valid, "to", anything(), std::string("last value, ") + in_its_unit);
    declare_required<int>(valid, "count", between(2, most_values),
                          "how many values, both ends among them [-]");
    declare(valid, "spacing", "linear", one_of({"linear", "geometric"}),
            "equal differences or equal ratios [-]");
    return valid;
  }
  const std::string type = has(given, "values") ? described(given, "values").type : "string";
  const std::string doc =
      "the values, as Array(double), Array(int), or text with ';' between them; or, in place of "
      "it, "
      "'from', 'to', 'count' (doubles, int) and 'spacing' (linear, geometric) [-]";
  if (type == type_name<std::vector<double>>())
    declare_required<std::vector<double>>(valid, "values", anything(), doc);
  else if (type == type_name<std::vector<int>>())
    declare_required<std::vector<int>>(valid, "values", anything(), doc);
  else
    declare_required<std::string>(valid, "values", anything(), doc);
  return valid;
}

std::vector<std::string> axis_values(const List& axis) {
  if (has(axis, "from")) return range_values(axis);
  const std::string type = described(axis, "values").type;
  const auto values =
      type == type_name<std::vector<double>>() ? texts(get<std::vector<double>>(axis, "values"))
      : type == type_name<std::vector<int>>()  ? texts(get<std::vector<int>>(axis, "values"))
                                               : parts_of(get<std::string>(axis, "values"));
  if (values.empty()) refuse(axis, "values", "must hold a value");
  return values;
}

List valid_sweep(const List& given) {
  List valid;
  declare(valid, "title", "", anything(), "what the sweep shows, in a line [-]");
  declare_required<std::string>(valid, "base", anything(),
                                "file of the scene, as seen from the folder of the sweep [-]");
  declare(valid, "changes", "", anything(),
          "list/parameter=value for all runs, ';' between several [-]");
  declare(valid, "combine", "grid", one_of({"grid", "zip"}),
          "every value with every other, or first with first, second with second [-]");
  declare(valid, "results", "", anything(),
          "measures for the table at the end, ';' between them [-]");
  List& vary = declare_list(valid, "vary", "one list for each parameter, under a name of its own");
  if (const List* axes = find_list(given, "vary"))
    for (const auto& name : list_names(*axes))
      declare_list(vary, name, "a parameter that is varied") = valid_axis(axes->sublist(name));
  List& plot = declare_optional_list(valid, "plot", "a picture of results, at the end");
  declare_required<std::string>(plot, "x", anything(), "name of a list of 'vary' with numbers [-]");
  declare_required<std::string>(plot, "y", anything(),
                                "measures, ';' between them, a panel for each [-]");
  return valid;
}

}  // namespace brisance
