#include "drivers/springs.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/geometry.hpp"
#include "drivers/exact_parameters.hpp"

namespace brisance {

List valid_spring(const std::vector<std::string>& materials, int dim) {
  List valid;
  declare_required<std::string>(valid, "material", one_of(materials),
                                "name of the material whose points it holds [-]");
  declare(valid, "direction", "x", dim == 1 ? one_of({"x"}) : one_of({"x", "y"}),
          "along which it pulls them to where their centre of mass was at the start [-]");
  declare_required<double>(valid, "stiffness", positive(),
                           "force over displacement, for each metre (plane strain) or square metre "
                           "(line) of the model [N/m]");
  return valid;
}

void check_springs(const List& scene) {
  const List& scheme = scene.sublist("scheme");
  if (find_list(scene, "springs") && get<std::string>(scheme, "integration") != "midpoint")
    refuse(scheme, "integration", "must be 'midpoint' where there are springs");
}

template <class G>
void add_springs(State<G>& state, const List& scene) {
  const List* springs = find_list(scene, "springs");
  if (!springs) return;
  for (const auto& name : list_names(*springs)) {
    const List& spring = springs->sublist(name);
    const std::string material = get<std::string>(spring, "material");
    for (std::size_t g = 0; g < state.groups.size(); ++g)
      if (state.groups[g]->label == material)
        state.springs.add(static_cast<int>(g), direction_of(spring),
                          get<double>(spring, "stiffness"));
  }
}

template void add_springs<Line>(State<Line>&, const List&);
template void add_springs<PlaneStrain>(State<PlaneStrain>&, const List&);

}  // namespace brisance
