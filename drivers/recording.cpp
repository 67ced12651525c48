#include "drivers/recording.hpp"

namespace brisance {
namespace {

constexpr std::chrono::milliseconds between_tables(500);

}  // namespace

Recording::Recording(const List& scene, Simulation& simulation, const Ledger& ledger,
                     ExactSolution* exact, TimeKeeper& keeper)
    : simulation_(simulation),
      ledger_(ledger),
      exact_(exact),
      keeper_(keeper),
      observers_(scene, exact),
      times_(scene) {}

void Recording::open(const std::filesystem::path& folder, const List& scene) {
  results_.emplace(folder, scene, ledger_, backlog_);
}

Recording::~Recording() {
  try {
    if (owed_) write_tables();
  } catch (const std::exception&) {
    // What ends the run tells why.
  }
}

void Recording::follow() {
  write_tables_if_due();
  if (observers_.none()) return;
  keeper_.on(TimeKeeper::watches, [&] { observers_.follow(simulation_); });
}

bool Recording::shown() const {
  return observers_.look_at_particles() || (results_ && results_->takes_particles());
}

const Snapshot& Recording::output(bool look) {
  keeper_.on(TimeKeeper::output, [&] {
    if (look) shot_ = simulation_.snapshot(std::move(shot_));
    if (!results_) return;
    if (results_->takes_particles()) results_->add(shot_);
    results_->note(ledger_, simulation_.balance());
  });
  if (!observers_.none()) keeper_.on(TimeKeeper::watches, [&] { observers_.observe(shot_); });
  owed_ = results_.has_value();
  write_tables_if_due();
  return shot_;
}

void Recording::write_tables() {
  wrote_ = Clock::now();
  results_->write_tables();
  observers_.write(results_->folder(), &backlog_);
  owed_ = false;
}

void Recording::write_tables_if_due() {
  if (owed_ && Clock::now() - wrote_ >= between_tables)
    keeper_.on(TimeKeeper::tables, [&] { write_tables(); });
}

void Recording::secure() {
  if (owed_) write_tables();
  shot_ = {};
  backlog_.force();
}

void Recording::output_if_seen() {
  if (results_ || shown()) output(shown());
}

const Snapshot& Recording::last_output() { return output(shown() || exact_); }

void Recording::output_if_due() {
  const auto due = times_.due(simulation_.step_count(), simulation_.time());
  if (due == OutputTimes::Due::output) output_if_seen();
  if (due == OutputTimes::Due::line && results_) results_->note(ledger_, simulation_.balance());
}

void Recording::write_exact(const Snapshot& end) {
  if (results_ && exact_) results_->write_exact(*exact_, end);
}

void Recording::keep(Archive& archive) {
  observers_.keep(archive);
  times_.keep(archive);
  if (results_) results_->keep(archive);
}

}  // namespace brisance
