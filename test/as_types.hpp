#pragma once
#include <gtest/gtest.h>

#include "materials/registry.hpp"

namespace brisance {

/// A list of the registry as GoogleTest takes types.
template <class T>
struct AsTypes;
template <class... T>
struct AsTypes<TypeList<T...>> {
  using type = testing::Types<T...>;
};

}  // namespace brisance
