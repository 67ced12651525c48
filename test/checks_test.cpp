#include "drivers/checks.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <limits>

namespace brisance {
namespace {

constexpr double none = std::numeric_limits<double>::max();

List range(const std::string& name, double least, double most) {
  List ranges;
  ranges.sublist(name).set("least", least).set("most", most);
  return ranges;
}

TEST(Checks, AValueOnTheLimitIsReachedAndBeyondItMissed) {
  const List ranges = range("L1 density", -none, 0.01);
  EXPECT_TRUE(judge(&ranges, {{"L1 density", 0.01, "-", ""}})[0].reached());
  EXPECT_FALSE(judge(&ranges, {{"L1 density", std::nextafter(0.01, 1), "-", ""}})[0].reached());
}

TEST(Checks, WhatIsNotANumberIsMissed) {
  const List ranges = range("L1 density", -none, none);
  EXPECT_FALSE(judge(&ranges, {{"L1 density", std::nan(""), "-", ""}})[0].reached());
}

TEST(Checks, LimitsAreToldAsPeopleWriteThem) {
  EXPECT_EQ((Verdict{"a", "-", 0, -none, 0.011}).limit(), "<= 0.011");
  EXPECT_EQ((Verdict{"a", "-", 0, 0.8, none}).limit(), ">= 0.8");
  EXPECT_EQ((Verdict{"a", "-", 0, 4.2e6, 5e6}).limit(), "4.2e+06 .. 5e+06");
}

TEST(Checks, AQuantityThatWasNotMeasuredIsRefused) {
  const List ranges = range("fan noise", -none, 1);
  EXPECT_THROW(judge(&ranges, {{"L1 density", 0, "-", ""}}), InputError);
}

}  // namespace
}  // namespace brisance
