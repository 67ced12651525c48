#include "drivers/commands.hpp"
#include "drivers/scripts.hpp"

namespace brisance {

int plot_command(const std::vector<std::string>& words) { return run_script("plot.py", words); }

}  // namespace brisance
