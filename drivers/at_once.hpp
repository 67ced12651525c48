#pragma once
// Two works for two threads of the pool, which has nothing else to do between steps. Where threads
// are bound to cores, one of our own would have to share that of the thread that starts it.
#include <exception>

#include "core/types.hpp"

namespace brisance {

/// Both are done when it returns, or have thrown; then it throws what the first of them has. On one
/// thread one is done after the other.
template <class First, class Second>
void at_once(const First& first, const Second& second) {
  using Pool = Kokkos::DefaultHostExecutionSpace;
  std::exception_ptr errors[2];
  Kokkos::parallel_for("two at once", Kokkos::RangePolicy<Pool>(0, 2).set_chunk_size(1),
                       [&](int k) {
                         try {
                           k == 0 ? first() : second();
                         } catch (...) {
                           errors[k] = std::current_exception();
                         }
                       });
  for (const auto& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace brisance
