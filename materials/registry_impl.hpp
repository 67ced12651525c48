#pragma once
// From the names of a checked list to the type of a group; included by the files that instantiate
// one geometry.
#include <Teuchos_ParameterList.hpp>
#include <stdexcept>

#include "materials/fluid.hpp"
#include "materials/fluid_group.hpp"
#include "materials/registry.hpp"
#include "materials/solid_group.hpp"

namespace brisance {

template <class G, class Eos>
std::unique_ptr<Group<G>> make_fluid(const List& list, const List& shock) {
  const Eos eos(list);
  const List* own = find_list(list, "artificial viscosity");
  const List& q = own ? *own : shock;
  const List* viscosity = find_list(list, "viscosity");
  const bool shocks = get<std::string>(q, "form") != "none";
  const auto with_shock = [&](const auto& shear) -> std::unique_ptr<Group<G>> {
    using Shear = std::decay_t<decltype(shear)>;
    if (!shocks) {
      using M = Fluid<Eos, Shear, NoShockViscosity>;
      return std::make_unique<FluidGroup<G, M>>(M{eos, shear, {}});
    }
    using M = Fluid<Eos, Shear, ShockViscosity>;
    return std::make_unique<FluidGroup<G, M>>(M{eos, shear, ShockViscosity(q)});
  };
  return viscosity ? with_shock(Newtonian(*viscosity)) : with_shock(Inviscid{});
}

template <class G, class... Eos, class... Law>
std::unique_ptr<Group<G>> make_from(TypeList<Eos...>, TypeList<Law...>, const List& list,
                                    const List& shock) {
  const std::string law = get<std::string>(list, "law");
  std::unique_ptr<Group<G>> group;
  ((law == Eos::name ? void(group = make_fluid<G, Eos>(list, shock)) : void()), ...);
  ((law == Law::name ? void(group = std::make_unique<SolidGroup<G, Law>>(Law(list))) : void()),
   ...);
  if (!group) throw std::logic_error("law '" + law + "' is in the schema but not in the registry");
  return group;
}

template <class G>
std::unique_ptr<Group<G>> make_group(const List& checked, const List& shock) {
  return make_from<G>(Fluids{}, Solids{}, checked, shock);
}

}  // namespace brisance
