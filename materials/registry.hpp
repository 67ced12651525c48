#pragma once
// Which materials there are. To add a fluid, write its equation of state (see perfect_gas) and add
// it to Fluids; to add a solid, write its law (see elastic) and add it to Solids.
#include <memory>
#include <string>
#include <vector>

#include "core/group.hpp"
#include "core/parameters.hpp"
#include "materials/concrete.hpp"
#include "materials/drucker_prager.hpp"
#include "materials/elastic.hpp"
#include "materials/jwl.hpp"
#include "materials/linear_fluid.hpp"
#include "materials/perfect_gas.hpp"
#include "materials/von_mises.hpp"

namespace brisance {

template <class... T>
struct TypeList {};

using Fluids = TypeList<PerfectGas, Jwl, LinearFluid>;
using Solids = TypeList<Elastic, VonMises, DruckerPrager, Concrete>;

/// The names of the laws, for "law".
std::vector<std::string> law_names();
/// Whether a law is that of a fluid; false for names that are none.
bool is_fluid(const std::string& law);

/// The schema of one material, from what was given: its law, and for fluids the optional lists
/// "viscosity" and "artificial viscosity". `shock` is the schema of the latter, with the defaults
/// of the scheme.
List valid_material(const List& given, const List& shock);

/// "stress xx" and on: the names of so many components.
std::vector<std::string> stress_names(int components);

/// What a material of that list, as given, adds to the columns that all particles have: the names
/// of its stresses on a grid of `dim` directions, and of its state variables.
std::vector<std::string> field_names(const List& given, int dim);

/// An empty group of the material of a checked list; `shock` is what the scheme sets for materials
/// without a list of their own.
template <class G>
std::unique_ptr<Group<G>> make_group(const List& checked, const List& shock);

}  // namespace brisance
