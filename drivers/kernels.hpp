#pragma once
// Which kernels a piece of work launches, seen through the callbacks of Kokkos Tools.
#include <functional>
#include <map>
#include <string>

namespace brisance {

/// Name and number of launches of all parallel_for, _reduce and _scan within `work`. Not to be
/// nested.
std::map<std::string, int> kernels_of(const std::function<void()>& work);

}  // namespace brisance
