#pragma once
// Shows how far a long run has come: one line rewritten in place on a terminal, a plain line now
// and then where stderr is a file, and always plain lines in a log file.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iosfwd>
#include <string>

namespace brisance {

/// Where a run stands after a step.
struct Standing {
  double time = 0;  // [s]
  double dt = 0;    // [s]
  std::int64_t step = 0;
  std::int64_t particles = 0;
};

/// Tell it about every step: a step that is not shown costs a look at the clock, some 30 ns.
/// Failures to write are ignored once the run is under way.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  struct Options {
    double end = 1;                // time at which all is done [s]
    double resumed_at = 0;         // where a restarted run takes up [s]
    std::filesystem::path log;     // empty: no log file
    bool quiet = false;            // shows nothing, the log goes on
    double screen_interval = 0.2;  // least wall time between two rewritings of the line [s]
    double line_interval = 10;     // most wall time between two plain lines [s]
    double least_interval = 1;     // least wall time between two plain lines [s]
  };

  /// Shows on stderr. A restarted run goes on with the log that is there. Throws std::runtime_error
  /// with one line if the log cannot be opened.
  explicit Progress(Options options);

  /// Where to show instead of stderr.
  struct Screen {
    std::ostream& stream;
    bool rewritable = false;                  // a terminal: "\r" goes back to the start of the line
    int width = 80;                           // columns of a terminal
    Clock::time_point (*now)() = Clock::now;  // the clock to go by
  };
  Progress(Options options, Screen screen);

  /// Leaves the rewritten line behind.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(const Standing& standing);

  /// The last line: where the run ended and its speed on the whole. Call it once, after the last
  /// step.
  void finish(const Standing& standing);

  /// A line about the run, on the screen and in the log.
  void note(const std::string& line) { plain(line, !options_.quiet); }
  /// In the log alone.
  void log(const std::string& line) { plain(line, false); }

  /// Particle-steps per second of wall time since the start.
  double rate() const;

 private:
  /// A speed that forgets what is long past: the first steps are often much shorter than later
  /// ones.
  struct Speed {
    double total = 0, value = 0;
    void learn(double new_total, double window, double elapsed);
  };

  double seconds() const;
  double fraction(const Standing& standing) const;
  void show(const Standing& standing, double now, bool as_plain_line);
  void rewrite(std::string line);
  void plain(const std::string& line, bool on_screen);

  Options options_;
  Screen screen_;
  std::ofstream log_;
  Clock::time_point start_;
  double particle_steps_ = 0;
  double rewritten_ = 0, lined_ = 0, measured_ = 0;  // when last, since the start [s]
  Speed advance_, work_;
  int tenths_ = -1;    // of the run, at the last plain line
  bool open_ = false;  // a rewritten line stands on the screen
};

/// 3.21 -> "3.2 s", 65.2 -> "1 min 05 s", 7300 -> "2 h 01 min": the two largest units.
std::string readable_duration(double seconds);

/// 12345678 -> "12.3 M"; three digits and a decimal prefix.
std::string readable_number(double value);

}  // namespace brisance
