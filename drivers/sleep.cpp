#include "drivers/sleep.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/geometry.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

bool sprung(const List& scene, const std::string& material) {
  const List* springs = find_list(scene, "springs");
  if (!springs) return false;
  for (const auto& name : list_names(*springs))
    if (get<std::string>(springs->sublist(name), "material") == material) return true;
  return false;
}

}  // namespace

void check_sleep(const List& scheme) {
  if (get<bool>(scheme, "sleep") && (get<std::string>(scheme, "integration") != "midpoint" ||
                                     get<std::string>(scheme, "quadrature") != "cell"))
    refuse(scheme, "sleep", "needs 'integration' midpoint and 'quadrature' cell");
}

template <class G>
void put_to_sleep(State<G>& state, const List& scene) {
  if (!get<bool>(scene.sublist("scheme"), "sleep")) return;
  std::vector<bool> may;
  for (const auto& g : state.groups) {
    const std::string law = get<std::string>(scene.sublist("materials").sublist(g->label), "law");
    may.push_back(law == PerfectGas::name && g->stress() == Stress::pressure &&
                  !sprung(scene, g->label));
  }
  state.sleep.lull(state.groups, may, state.grid, state.scheme.split_length, state.sorter);
}

template void put_to_sleep<Line>(State<Line>&, const List&);
template void put_to_sleep<PlaneStrain>(State<PlaneStrain>&, const List&);

}  // namespace brisance
