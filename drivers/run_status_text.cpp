// How the status of a run is told on a screen.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "drivers/progress.hpp"
#include "drivers/run_status.hpp"

namespace brisance {
namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

std::string bar(double percent) {
  constexpr int width = 30;
  const int full = std::clamp(static_cast<int>(std::lround(percent * width / 100)), 0, width);
  return "[" + std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(width - full), '.') + "]";
}

std::string ago(double seconds) { return readable_duration(seconds) + " ago"; }

}  // namespace

std::string line_of(const RunStatus& s) {
  switch (s.phase) {
    case RunStatus::Phase::starting:
      return "starting";
    case RunStatus::Phase::running:
      return format("%5.1f %%  ", s.percent) + s.left + format(" left  dt %.2e s  ", s.dt) +
             s.rate +
             format(" particle-steps/s  step %lld  t %.6g s", static_cast<long long>(s.step),
                    s.time);
    case RunStatus::Phase::cut_off:
      return format("cut off at %.1f %%: t %.6g s, step %lld; no process runs it any more",
                    s.percent, s.time, static_cast<long long>(s.step));
    case RunStatus::Phase::ended:
      break;
  }
  std::string line = s.ending;
  if (s.reached + s.missed > 0)
    line += format("; limits: %d reached, %d missed", s.reached, s.missed);
  return line;
}

std::string block_of(const RunStatus& s, const std::filesystem::path& folder, std::size_t width) {
  std::ostringstream text;
  const bool running = s.phase == RunStatus::Phase::running;
  text << folder.string() << "\n";
  if (running)
    text << format("%5.1f %%  ", s.percent) << bar(s.percent) << "  " << s.left << " left\n";
  else
    text << line_of(s) << "\n";
  if (s.phase != RunStatus::Phase::starting) {
    text << format("time        %.6g s, step %lld, dt %.2e s\n", s.time,
                   static_cast<long long>(s.step), s.dt);
    text << "speed       " << s.rate << " particle-steps/s\n";
  }
  if (s.energy)
    text << format("energy      error %.2g at t = %.6g s\n", s.energy->error, s.energy->time);
  text << "outputs     " << s.outputs << "\n";
  text << "checkpoint  "
       << (s.checkpoint ? s.checkpoint->file + ", " + ago(s.checkpoint->age) : "none") << "\n";
  if (running) text << "log         " << ago(s.age) << "\n";
  for (const auto& note : s.notes) text << "  " << note << "\n";
  const bool unfinished = s.phase == RunStatus::Phase::cut_off || s.status == "interrupted";
  if (unfinished && s.checkpoint)
    text << "to go on: brisance restart '" << folder.string() << "'\n";

  std::istringstream lines(text.str());
  std::string block;
  for (std::string line; std::getline(lines, line);) block += line.substr(0, width) + "\n";
  return block;
}

}  // namespace brisance
