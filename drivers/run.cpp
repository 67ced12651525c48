#include "drivers/run.hpp"

#include <Teuchos_ParameterList.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <optional>

#include "drivers/cadence.hpp"
#include "drivers/cracks.hpp"
#include "drivers/files.hpp"
#include "drivers/gauges.hpp"
#include "drivers/progress.hpp"
#include "drivers/simulation.hpp"
#include "drivers/watch.hpp"

namespace brisance {
namespace {

volatile std::sig_atomic_t stop_requested = 0;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

void request_stop() { stop_requested = 1; }

RunResult run(const List& scene, const RunOptions& options) {
  const List* exact_list = find_list(scene, "exact");
  const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
  const auto simulation = make_simulation(scene, exact.get());
  const double end = get<double>(scene.sublist("time"), "end");
  const Ledger ledger(simulation->balance());

  std::optional<Results> results;
  if (!options.folder.empty()) results.emplace(options.folder, scene, ledger);
  const List* crack_list = find_list(scene, "cracks");
  std::optional<CrackPattern> cracks;
  if (crack_list) cracks.emplace(*crack_list);
  const auto watches = make_watches(scene);
  std::optional<Gauges> gauges;
  if (find_list(scene, "gauges")) gauges.emplace(scene);
  const auto write = [&](const Snapshot& shot) {
    if (cracks) cracks->observe(shot.table, shot.time);
    for (const auto& watch : watches) watch->observe(shot.table, shot.time);
    if (!results) return;
    for (const auto& watch : watches) watch->write(results->folder());
    results->add(shot);
    results->add(ledger, simulation->balance());
    if (gauges) write_file(options.folder / "gauges.csv", gauges->table());
  };
  const auto output = [&] {
    if (results || cracks || !watches.empty()) write(simulation->snapshot());
  };

  Progress::Options shown;
  shown.end = end;
  shown.quiet = options.quiet;
  if (results) shown.log = options.folder / "log.txt";
  Progress progress(shown);
  const auto awake = [&] {
    const auto sleeping = simulation->sleeping();
    return simulation->particle_count() - (sleeping ? sleeping->particles : 0);
  };
  const auto standing = [&] {
    return Standing{simulation->time(), simulation->dt(), simulation->step_count(), awake()};
  };

  if (gauges) gauges->observe(*simulation);
  const bool recorded = exact && exact->records();
  if (recorded) exact->record(simulation->balance());
  output();
  const double interval = get<double>(scene.sublist("output"), "interval");
  Cadence cadence(interval > 0 ? interval : end / 10);
  const double between = get<double>(scene.sublist("output"), "history interval");
  Cadence history(results && between > 0 ? between : 2 * end);
  RunResult result;
  double slept = 0;  // particle-steps
  const auto started = std::chrono::steady_clock::now();
  const double cpu = cpu_seconds();
  while (simulation->time() < end && !stop_requested) {
    simulation->advance(end);
    if (gauges) gauges->observe(*simulation);
    if (recorded) exact->record(simulation->balance());
    result.outcome.particle_steps += static_cast<double>(awake());
    slept += static_cast<double>(simulation->particle_count() - awake());
    progress.update(standing());
    if (simulation->time() >= end) break;
    const bool noted = history.due(simulation->time());
    if (cadence.due(simulation->time()))
      output();
    else if (noted)
      results->note(ledger, simulation->balance());
  }
  result.outcome.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  result.outcome.cpu_seconds = cpu_seconds() - cpu;
  result.outcome.status = simulation->time() < end ? "interrupted" : "finished";
  progress.finish(standing());
  if (const auto sleeping = simulation->sleeping()) {
    result.outcome.asleep = {slept, sleeping->impulse};
    char text[60];
    std::snprintf(text, sizeof text, "asleep: %.3g %% of particle-steps saved",
                  100 * result.outcome.share_asleep());
    progress.note(text);
  }

  result.end = simulation->balance();
  if (result.end.left > 0) progress.note(ledger.departures(result.end));
  result.cell_size = get<double>(scene.sublist("grid"), "cell size");
  const Snapshot shot = simulation->snapshot();
  write(shot);
  result.outcome.measures = ledger.measures(result.end);
  if (exact)
    for (const Measure& m : exact->measures(shot.table, shot.time))
      result.outcome.measures.push_back(m);
  if (cracks)
    for (const Measure& m : cracks->measures(shot.table)) result.outcome.measures.push_back(m);
  for (const auto& watch : watches)
    for (const Measure& m : watch->measures()) result.outcome.measures.push_back(m);
  if (gauges)
    for (const Measure& m : gauges->measures()) result.outcome.measures.push_back(m);
  if (result.outcome.status == "finished")
    result.outcome.verdicts = judge(find_list(scene, "checks"), result.outcome.measures);
  if (results) {
    if (exact) results->write_exact(*exact, shot);
    results->write_summary(result.outcome, ledger, result.end);
  }
  return result;
}

}  // namespace brisance
