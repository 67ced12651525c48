#pragma once
// The scripts that draw, run with the python whose packages belong to them.
#include <string>
#include <vector>

namespace brisance {

/// Runs one of the program's scripts to its end and returns its exit status; 1 if it was killed.
int run_script(const std::string& script, const std::vector<std::string>& arguments);

}  // namespace brisance
