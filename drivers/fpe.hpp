#pragma once
// Debug builds stop at the first invalid floating point operation instead of carrying a NaN along.
#ifdef BRISANCE_FPE_TRAPS
#include <cfenv>
#endif

namespace brisance {

inline void trap_floating_point_errors() {
#ifdef BRISANCE_FPE_TRAPS
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
}

}  // namespace brisance
