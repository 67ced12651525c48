#include "drivers/checks.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>

namespace brisance {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

std::string Verdict::limit() const {
  const bool low = least > std::numeric_limits<double>::lowest(),
             high = most < std::numeric_limits<double>::max();
  if (low && high) return number(least) + " .. " + number(most);
  if (low) return ">= " + number(least);
  return high ? "<= " + number(most) : "any";
}

Verdict judge_one(const List& range, const std::string& quantity, double measured,
                  const std::string& unit) {
  return {quantity, unit, measured, get<double>(range, "least"), get<double>(range, "most")};
}

std::vector<Verdict> judge(const List* ranges, const std::vector<Measure>& measured) {
  std::vector<Verdict> verdicts;
  if (!ranges) return verdicts;
  for (const auto& name : list_names(*ranges)) {
    const auto m = std::find_if(measured.begin(), measured.end(),
                                [&](const Measure& k) { return k.name == name; });
    if (m == measured.end()) refuse(ranges->sublist(name), "", "cannot be measured in this scene");
    verdicts.push_back(judge_one(ranges->sublist(name), name, m->value, m->unit));
  }
  return verdicts;
}

bool all_reached(const std::vector<Verdict>& verdicts) {
  return std::all_of(verdicts.begin(), verdicts.end(),
                     [](const Verdict& v) { return v.reached(); });
}

}  // namespace brisance
