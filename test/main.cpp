// Runs the tests with the parallel runtime started once.
#include <gtest/gtest.h>

#include "core/types.hpp"
#include "drivers/fpe.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  // Threads inherit what stops them. The first one may go on: host code is tested with numbers that
  // are none, and the others see as much of every kernel.
  brisance::trap_floating_point_errors();
  brisance::initialize_kokkos(-1);
#ifdef BRISANCE_FPE_TRAPS
  fedisableexcept(FE_ALL_EXCEPT);
#endif
  const int failures = RUN_ALL_TESTS();
  Kokkos::finalize();
  return failures;
}
