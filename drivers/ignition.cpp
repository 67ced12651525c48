#include "drivers/ignition.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "core/geometry.hpp"
#include "drivers/bodies.hpp"

namespace brisance {
namespace {

using Doubles = std::vector<double>;

bool has(const List& list, const std::string& name) {
  const auto present = names(list);
  return std::find(present.begin(), present.end(), name) != present.end();
}

/// The detonation speed of a material; 0 if it is nothing to be lit, or products already. [m/s]
double detonation_speed(const List& material) {
  if (!has(material, "detonation speed")) return 0;
  if (has(material, "burn") && get<std::string>(material, "burn") == "at once") return 0;
  return get<double>(material, "detonation speed");
}

template <class G>
int lighting_column(const Group<G>& group) {
  const auto fields = group.history_fields();
  for (std::size_t k = 0; k < fields.size(); ++k)
    if (fields[k].name == "lighting time") return static_cast<int>(k);
  return -1;
}

Eikonal::Box box_of(const List& grid) {
  const auto origin = get<Doubles>(grid, "origin");
  const auto cells = get<std::vector<int>>(grid, "cells");
  const bool plane = cells.size() > 1;
  return {{origin[0], plane ? origin[1] : 0},
          get<double>(grid, "cell size"),
          {cells[0], plane ? cells[1] : 1}};
}

LightingTimes lighting_times(const List& ignition, const List& scene) {
  const Bodies bodies(scene);
  std::vector<double> speeds;
  for (const Body& body : bodies.all())
    speeds.push_back(detonation_speed(scene.sublist("materials").sublist(body.material)));
  return {ignition, box_of(scene.sublist("grid")), [bodies, speeds](const Place& x) {
            const int owner = bodies.owner(x);
            return owner < 0 ? 0 : speeds[owner];
          }};
}

}  // namespace

template <class G>
void set_lighting_times(State<G>& state, const List& scene) {
  std::unique_ptr<LightingTimes> times;
  for (auto& group : state.groups) {
    const int column = lighting_column(*group);
    const List& material = scene.sublist("materials").sublist(group->label);
    if (column < 0 || !(detonation_speed(material) > 0)) continue;
    const List* ignition = find_list(scene, "ignition");
    if (!ignition) refuse(material, "detonation speed", "needs a list 'ignition' in the scene");
    if (!times) times = std::make_unique<LightingTimes>(lighting_times(*ignition, scene));
    const Particles<G>& p = group->particles;
    const auto position = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), p.position);
    const auto history = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), p.history);
    bool lit = p.count == 0;
    for (int k = 0; k < p.count; ++k) {
      Place x{};
      for (int d = 0; d < G::dim; ++d) x[d] = position(k, d);
      history(k, column) = times->at(x);
      lit = lit || history(k, column) < never;
    }
    if (!lit)
      refuse(*ignition, "",
             "leaves '" + group->label + "' unlit: no way leads there from a source");
    Kokkos::deep_copy(p.history, history);
  }
}

template void set_lighting_times<Line>(State<Line>&, const List&);
template void set_lighting_times<PlaneStrain>(State<PlaneStrain>&, const List&);

}  // namespace brisance
