#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <limits>
#include <thread>

#include "drivers/commands.hpp"
#include "drivers/run_status.hpp"

namespace brisance {
namespace {

constexpr auto refresh = std::chrono::seconds(1);

std::size_t width_of_terminal() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

bool goes_on(const RunStatus& s) {
  return s.phase == RunStatus::Phase::starting || s.phase == RunStatus::Phase::running;
}

}  // namespace

int watch_command(const std::string& folder, bool once) {
  // Nothing here is worth more than an end at once.
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  const bool terminal = ::isatty(STDOUT_FILENO) == 1;
  if (once) {
    const auto width = terminal ? width_of_terminal() : std::numeric_limits<std::size_t>::max();
    std::cout << block_of(read_run_status(folder), folder, width);
    return 0;
  }
  std::string before;
  for (;; std::this_thread::sleep_for(refresh)) {
    const RunStatus status = read_run_status(folder);
    if (terminal) {
      // Back over the block that stands there, to write it anew.
      const auto lines = std::count(before.begin(), before.end(), '\n');
      if (lines > 0) std::cout << "\x1b[" << lines << "A\x1b[J";
      before = block_of(status, folder, width_of_terminal());
      std::cout << before << std::flush;
    } else if (const std::string line = line_of(status); line != before) {
      std::cout << line << std::endl;
      before = line;
    }
    if (!goes_on(status)) return 0;
  }
}

}  // namespace brisance
