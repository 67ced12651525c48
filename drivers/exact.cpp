#include "drivers/exact.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <type_traits>

#include "drivers/exact_detonation.hpp"
#include "drivers/exact_layers.hpp"
#include "drivers/exact_parameters.hpp"
#include "drivers/exact_piston.hpp"
#include "drivers/exact_piston_gas.hpp"
#include "drivers/exact_solid.hpp"

namespace brisance {
namespace {

// Everything there is to know of one kind of solution before its data are known.
struct Kind {
  const char* name;
  List (*valid_parameters)(const List& given);
  std::vector<MeasureDoc> (*possible_measures)();
  std::unique_ptr<ExactSolution> (*make)(const List&);
};

template <class Solution>
constexpr Kind kind(const char* name) {
  return {name,
          [](const List& given) {
            if constexpr (std::is_invocable_v<decltype(Solution::valid_parameters), const List&>)
              return Solution::valid_parameters(given);
            else
              return Solution::valid_parameters();
          },
          &Solution::possible_measures,
          [](const List& list) -> std::unique_ptr<ExactSolution> {
            return std::make_unique<Solution>(list);
          }};
}

constexpr std::array<Kind, 12> kinds{kind<Riemann>("riemann"),
                                     kind<Sedov>("sedov"),
                                     kind<AcousticWave>("acoustic wave"),
                                     kind<Vortex>("vortex"),
                                     kind<Uniform>("uniform"),
                                     kind<StandingWave>("standing wave"),
                                     kind<PlateImpact>("plate impact"),
                                     kind<PlasticWave>("plastic wave"),
                                     kind<PistonContainer>("piston container"),
                                     kind<Detonation>("detonation"),
                                     kind<PistonGas>("piston gas"),
                                     kind<Layers>("layers")};

List choice() {
  List valid;
  declare_required<std::string>(valid, "solution", one_of(exact_solutions()),
                                "the problem whose answer is known [-]");
  return valid;
}

const Kind& kind_named(const std::string& name) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return name == k.name; });
  if (found == kinds.end()) throw InputError("exact", "solution", name, "is unknown");
  return *found;
}

const Kind& kind_of(const List& list) {
  return kind_named(peek<std::string>(list, choice(), "solution"));
}

}  // namespace

std::vector<std::string> exact_solutions() {
  std::vector<std::string> names;
  for (const Kind& k : kinds) names.push_back(k.name);
  return names;
}

std::vector<MeasureDoc> possible_measures(const std::string& solution) {
  return kind_named(solution).possible_measures();
}

List valid_exact(const List& given) { return kind_of(given).valid_parameters(given); }

std::unique_ptr<ExactSolution> make_exact(const List& checked) {
  return kind_of(checked).make(checked);
}

List list_for_solution(const std::string& solution) {
  List valid("exact");
  declare_required<std::string>(valid, "solution", one_of({solution}),
                                "the problem whose answer is known [-]");
  return valid;
}

void declare_gamma(List& valid) {
  declare_required<double>(valid, "gamma", above(1),
                           "ratio of specific heats, that of the material [-]");
}

void declare_direction(List& valid) {
  declare(valid, "direction", "x", one_of({"x", "y", "z"}), "along which everything happens [-]");
}

int direction_of(const List& list) { return get<std::string>(list, "direction")[0] - 'x'; }

void declare_centre(List& valid, const std::vector<double>& standard) {
  declare(valid, "centre", standard, anything(), "where the centre is at the start [m]");
}

std::array<double, 3> place_of(const List& list, const std::string& name) {
  const auto entries = get<std::vector<double>>(list, name);
  std::array<double, 3> place{};
  if (entries.empty() || entries.size() > place.size())
    refuse(list, name, "must have 1, 2 or 3 entries");
  std::copy(entries.begin(), entries.end(), place.begin());
  return place;
}

}  // namespace brisance
