#include "drivers/scripts.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "drivers/locations.hpp"

namespace brisance {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

int run_script(const std::string& script, const std::vector<std::string>& arguments) {
  // The distribution's interpreter first: its packages are the ones that were installed. With exec
  // there is no shell in between that a Ctrl-C could end before the script has told its status.
  std::string command = "exec ";
  command += std::filesystem::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3";
  command += " " + quoted(script_file(script).string());
  for (const auto& argument : arguments) command += " " + quoted(argument);
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace brisance
