#pragma once
// What a scene may say, and the scene as completed by its defaults. The schema is built from what
// is given: a preset sets the defaults of the scheme, a law the parameters of a material, the
// presence of a list what is modelled.
#include <string>

#include "core/parameters.hpp"

namespace brisance {

/// The schema of a scene; `given` decides where there is a choice.
List valid_scene(const List& given);

/// The scene complete and consistent. Throws InputError.
List complete_scene(const List& given);

/// 1 for a line, 2 for plane strain.
int dimension(const List& scene);

}  // namespace brisance
