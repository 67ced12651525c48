#pragma once
// A typed value from its text, without a guess: the whole text must be the value.
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace brisance {

/// The types a parameter can have, as the XML names them.
const std::vector<std::string>& value_types();

/// Puts `text`, read as one of value_types(), into the list. Returns what is wrong with the text
/// ("must be an integer") and leaves the list alone then; empty when all is well.
std::string put_text(List& list, const std::string& name, const std::string& type,
                     const std::string& text);

}  // namespace brisance
