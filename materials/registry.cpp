#include "materials/registry.hpp"

#include <Teuchos_ParameterList.hpp>

#include "materials/viscosity.hpp"

namespace brisance {
namespace {

template <class... Eos>
std::vector<std::string> names_of(TypeList<Eos...>) {
  return {Eos::name...};
}

template <class... Eos>
void add_parameters(TypeList<Eos...>, const std::string& law, List& valid) {
  ((law == Eos::name ? void(valid.setParameters(Eos::valid_parameters())) : void()), ...);
}

}  // namespace

std::vector<std::string> law_names() { return names_of(Fluids{}); }

List valid_material(const List& given, const List& shock) {
  List valid;
  declare_required<std::string>(valid, "law", one_of(law_names()), "constitutive law [-]");
  add_parameters(Fluids{}, peek<std::string>(given, valid, "law"), valid);
  declare_optional_list(valid, "viscosity", "Newtonian viscosity; absent: inviscid") =
      Newtonian::valid_parameters();
  declare_optional_list(valid, "artificial viscosity",
                        "in place of the scheme's, for this material") = shock;
  return valid;
}

}  // namespace brisance
