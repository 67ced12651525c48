#include "materials/registry.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>

#include "core/geometry.hpp"
#include "materials/fluid.hpp"
#include "materials/viscosity.hpp"

namespace brisance {
namespace {

template <class... Eos>
std::vector<std::string> names_of(TypeList<Eos...>) {
  return {Eos::name...};
}

template <class... Eos>
void add_fluid(TypeList<Eos...>, const std::string& law, List& valid) {
  ((law == Eos::name ? void(valid.setParameters(Eos::valid_parameters())) : void()), ...);
}

template <class... Law>
void add_solid(TypeList<Law...>, const List& given, const std::string& law, List& valid) {
  ((law == Law::name ? void(valid.setParameters(Law::valid_parameters(given))) : void()), ...);
}

template <class M>
void add_fields(std::vector<std::string>& names) {
  for (const auto& field : M::fields)
    if (std::string(field.name) != "energy") names.push_back(field.name);
}

template <class... Eos, class... Law>
void add_fields(TypeList<Eos...>, TypeList<Law...>, const std::string& law,
                std::vector<std::string>& names) {
  ((law == Eos::name ? add_fields<Fluid<Eos>>(names) : void()), ...);
  ((law == Law::name ? add_fields<Law>(names) : void()), ...);
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::vector<std::string> law_names() {
  std::vector<std::string> names = names_of(Fluids{});
  for (const auto& solid : names_of(Solids{})) names.push_back(solid);
  return names;
}

bool is_fluid(const std::string& law) { return contains(names_of(Fluids{}), law); }

List valid_material(const List& given, const List& shock) {
  List valid;
  declare_required<std::string>(valid, "law", one_of(law_names()), "constitutive law [-]");
  const std::string law = peek<std::string>(given, valid, "law");
  add_solid(Solids{}, given, law, valid);
  if (!is_fluid(law)) return valid;
  add_fluid(Fluids{}, law, valid);
  declare_optional_list(valid, "viscosity", "Newtonian viscosity; absent: inviscid") =
      Newtonian::valid_parameters();
  declare_optional_list(valid, "artificial viscosity",
                        "in place of the scheme's, for this material") = shock;
  return valid;
}

std::vector<std::string> stress_names(int components) {
  std::vector<std::string> names;
  for (const char* component : {"xx", "yy", "zz", "xy", "yz", "zx"})
    if (static_cast<int>(names.size()) < components)
      names.push_back(std::string("stress ") + component);
  return names;
}

std::vector<std::string> field_names(const List& given, int dim) {
  const std::string law = get<std::string>(given, "law");
  std::vector<std::string> names;
  if (!is_fluid(law) || find_list(given, "viscosity"))
    names = stress_names(dim == 1 ? Line::stress_components : PlaneStrain::stress_components);
  add_fields(Fluids{}, Solids{}, law, names);
  return names;
}

}  // namespace brisance
