// Runs the tests with the parallel runtime started once.
#include <gtest/gtest.h>

#include "core/types.hpp"
#include "drivers/fpe.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  brisance::initialize_kokkos(-1);
  brisance::trap_floating_point_errors();
  const int failures = RUN_ALL_TESTS();
  Kokkos::finalize();
  return failures;
}
