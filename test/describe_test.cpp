#include "drivers/describe.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <sstream>

namespace brisance {
namespace {

List schema() {
  List valid("scene");
  declare(valid, "title", "", anything(), "what the scene shows [-]");
  List& time = declare_list(valid, "time", "how far and how fast");
  declare_required<double>(time, "end", positive(), "when the run stops [s]");
  declare(time, "CFL", 0.5, above(0) && at_most(1), "cells that a wave may cross in a step [-]");
  List& viscosity = declare_optional_list(time, "artificial viscosity", "spreads shocks");
  declare(viscosity, "form", "linear", one_of({"linear", "quadratic"}), "its dependence [-]");
  return valid;
}

TEST(Describe, PrintsEveryParameterWithin100Columns) {
  std::ostringstream out;
  List valid = schema();
  declare(valid, "note", "", anything(),
          std::string(40, 'x') + " " + std::string(50, 'y') + " [-]");
  describe(valid, out);
  std::istringstream lines(out.str());
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  for (const char* part : {"time: how far and how fast", "artificial viscosity (optional): spreads",
                           "end     required  [s]  a number > 0", "when the run stops\n"}) {
    EXPECT_NE(out.str().find(part), std::string::npos) << part << "\n" << out.str();
  }
}

}  // namespace
}  // namespace brisance
