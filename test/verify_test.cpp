// The whole proof; minutes.
#include <gtest/gtest.h>

#include "test/program.hpp"

namespace brisance {
namespace {

TEST(VerifySlow, AllScenesReachTheirLimits) {
  const test::Ran ran = test::run_program("verify");
  EXPECT_EQ(ran.status, 0) << ran.err << ran.out;
  EXPECT_NE(ran.out.find(", 0 missed"), ran.out.npos);
}

}  // namespace
}  // namespace brisance
