#include "drivers/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace brisance {
namespace {

/// How long the speeds that are shown remember [s].
constexpr double memory = 15;

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

Progress::Screen standard_screen() {
  const char* kind = std::getenv("TERM");
  Progress::Screen screen{std::cerr};
  screen.rewritable =
      ::isatty(STDERR_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) screen.width = size.ws_col;
  return screen;
}

}  // namespace

std::string readable_duration(double seconds) {
  if (!(seconds < 3.6e8)) return "ages";
  if (seconds < 9.95) return format("%.1f s", std::max(seconds, 0.0));
  const long s = std::lround(seconds), minutes = s / 60, hours = minutes / 60;
  if (s < 60) return format("%ld s", s);
  if (minutes < 60) return format("%ld min %02ld s", minutes, s % 60);
  if (hours < 24) return format("%ld h %02ld min", hours, minutes % 60);
  return format("%ld d %02ld h", hours / 24, hours % 24);
}

std::string readable_number(double value) {
  constexpr const char* prefixes[] = {"", " k", " M", " G", " T", " P"};
  std::size_t prefix = 0;
  // 999.5 would be rounded up to four digits.
  while (std::fabs(value) >= 999.5 && prefix + 1 < std::size(prefixes)) {
    value /= 1000;
    ++prefix;
  }
  return format("%.3g%s", value, prefixes[prefix]);
}

void Progress::Speed::learn(double new_total, double window, double elapsed) {
  // A plain mean at first, a fading one as soon as there is more to remember.
  const double share = std::max(1 - std::exp(-window / memory), window / elapsed);
  value += share * ((new_total - total) / window - value);
  total = new_total;
}

Progress::Progress(Options options) : Progress(std::move(options), standard_screen()) {}

Progress::Progress(Options options, Screen screen)
    : options_(std::move(options)), screen_(screen), start_(screen.now()) {
  advance_.total = fraction({options_.resumed_at, 0, 0, 0});
  if (options_.log.empty()) return;
  log_.open(options_.log, options_.resumed_at > 0 ? std::ios::app : std::ios::trunc);
  if (!log_) {
    throw std::runtime_error("cannot write '" + options_.log.string() +
                             "': " + std::generic_category().message(errno));
  }
}

Progress::~Progress() {
  if (open_) screen_.stream << std::endl;
}

void Progress::update(const Standing& standing) {
  particle_steps_ += static_cast<double>(standing.particles);
  const double now = seconds(), since_line = now - lined_;
  const bool line =
      since_line >= options_.line_interval || (since_line >= options_.least_interval &&
                                               static_cast<int>(10 * fraction(standing)) > tenths_);
  if (line) {
    show(standing, now, true);
  } else if (screen_.rewritable && now - rewritten_ >= options_.screen_interval) {
    show(standing, now, false);
  }
}

void Progress::finish(const Standing& standing) {
  const double share = fraction(standing);
  const auto how = share < 1 ? format("stopped at %.1f %%", 100 * share) : std::string("done");
  plain(
      how +
          format(": t %.6g s, step %lld, ", standing.time, static_cast<long long>(standing.step)) +
          readable_duration(seconds()) + ", " + readable_number(rate()) + " particle-steps/s",
      !options_.quiet);
}

double Progress::rate() const {
  const double elapsed = seconds();
  return elapsed > 0 ? particle_steps_ / elapsed : 0;
}

double Progress::seconds() const {
  return std::chrono::duration<double>(screen_.now() - start_).count();
}

double Progress::fraction(const Standing& standing) const {
  return options_.end > 0 ? std::clamp(standing.time / options_.end, 0.0, 1.0) : 1;
}

void Progress::show(const Standing& standing, double now, bool as_plain_line) {
  const double done = fraction(standing);
  if (now > measured_) {
    advance_.learn(done, now - measured_, now);
    work_.learn(particle_steps_, now - measured_, now);
    measured_ = now;
  }
  // Nothing gained yet: no end in sight.
  const double left = advance_.value > 0 ? (1 - done) / advance_.value : HUGE_VAL;
  const auto line = format("%5.1f %%  ", 100 * done) + readable_duration(left) +
                    format(" left  dt %.2e s  ", standing.dt) + readable_number(work_.value) +
                    format(" particle-steps/s  step %lld", static_cast<long long>(standing.step));
  if (as_plain_line) {
    plain(line + format("  t %.6g s", standing.time), !options_.quiet && !screen_.rewritable);
    lined_ = now;
    tenths_ = static_cast<int>(10 * done);
  }
  if (screen_.rewritable && !options_.quiet) rewrite(line);
  rewritten_ = now;
}

void Progress::rewrite(std::string line) {
  // A line as wide as the terminal would wrap, and "\r" not reach its start any more.
  line.resize(std::min(line.size(), static_cast<std::size_t>(std::max(screen_.width - 1, 0))));
  screen_.stream << '\r' << line << "\x1b[K" << std::flush;
  open_ = true;
}

void Progress::plain(const std::string& line, bool on_screen) {
  if (log_.is_open()) log_ << line << std::endl;
  if (!on_screen) return;
  if (open_) screen_.stream << "\r\x1b[K";
  open_ = false;
  screen_.stream << line << std::endl;
}

}  // namespace brisance
