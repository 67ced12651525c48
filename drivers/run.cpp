#include "drivers/run.hpp"

#include <Teuchos_ParameterList.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <optional>

#include "drivers/cadence.hpp"
#include "drivers/checkpoint.hpp"
#include "drivers/cracks.hpp"
#include "drivers/files.hpp"
#include "drivers/gauges.hpp"
#include "drivers/input.hpp"
#include "drivers/progress.hpp"
#include "drivers/runtime.hpp"
#include "drivers/simulation.hpp"
#include "drivers/watch.hpp"
#include "version.hpp"

namespace brisance {
namespace {

volatile std::sig_atomic_t stop_flag = 0;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

CheckpointHead head_of(const List& scene, const Simulation& simulation) {
  CheckpointHead head;
  head.program = version::number;
  head.commit = version::commit;
  head.scene = scene.name();
  head.title = get<std::string>(scene, "title");
  head.step = simulation.step_count();
  head.time = simulation.time();
  head.threads = running_threads();
  head.input = input_text(scene, "The complete input of the run, defaults included.");
  return head;
}

}  // namespace

void request_stop() { stop_flag = 1; }
bool stop_requested() { return stop_flag; }

RunResult run(const List& scene, const RunOptions& options) {
  const List* exact_list = find_list(scene, "exact");
  const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
  const auto simulation = make_simulation(scene, exact.get());
  const double end = get<double>(scene.sublist("time"), "end");
  Ledger ledger(simulation->balance());

  std::optional<Results> results;
  std::optional<Checkpoints> checkpoints;
  const bool others =
      !options.folder.empty() && !options.resume && set_aside_checkpoints(options.folder);
  if (!options.folder.empty()) {
    results.emplace(options.folder, scene, ledger);
    checkpoints.emplace(scene, options.folder);
  }
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
  const auto awake = [&] {
    const auto sleeping = simulation->sleeping();
    return simulation->particle_count() - (sleeping ? sleeping->particles : 0);
  };
  const auto standing = [&] {
    return Standing{simulation->time(), simulation->dt(), simulation->step_count(), awake()};
  };

  const double interval = get<double>(scene.sublist("output"), "interval");
  Cadence cadence(interval > 0 ? interval : end / 10);
  const double between = get<double>(scene.sublist("output"), "history interval");
  Cadence history(results && between > 0 ? between : 2 * end);
  RunResult result;
  Outcome& outcome = result.outcome;
  double slept = 0;  // particle-steps
  const bool recorded = exact && exact->records();

  // All that outlives a step, in either direction.
  const auto keep = [&](Archive& archive) {
    simulation->keep(archive);
    ledger.keep(archive);
    if (recorded) dynamic_cast<Remembers&>(*exact).keep(archive);
    if (cracks) cracks->keep(archive);
    for (const auto& watch : watches) watch->keep(archive);
    if (gauges) gauges->keep(archive);
    cadence.keep(archive, "output");
    history.keep(archive, "history");
    if (checkpoints) checkpoints->keep(archive);
    if (results) results->keep(archive);
    const Archive::Part part(archive, "spent");
    archive.keep("wall seconds", outcome.wall_seconds);
    archive.keep("cpu seconds", outcome.cpu_seconds);
    archive.keep("particle steps", outcome.particle_steps);
    archive.keep("slept", slept);
  };
  if (options.resume) {
    keep(*options.resume);
    shown.resumed_at = simulation->time();
  }
  Progress progress(shown);
  if (others) progress.note("checkpoints of an earlier run are now in 'checkpoints.before'");
  for (const auto& line : options.notes) progress.note(line);

  const auto started = std::chrono::steady_clock::now();
  const double wall_before = outcome.wall_seconds, cpu_before = outcome.cpu_seconds - cpu_seconds();
  const auto wall_seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  };
  const auto spend = [&] {
    outcome.wall_seconds = wall_before + wall_seconds();
    outcome.cpu_seconds = cpu_before + cpu_seconds();
  };
  // A disk that is full must not end a run that can go on.
  const auto save = [&] {
    try {
      spend();
      Archive archive;
      keep(archive);
      checkpoints->write(head_of(scene, *simulation), std::move(archive));
      return true;
    } catch (const std::exception& error) {
      progress.note(std::string("no checkpoint: ") + error.what());
      return false;
    }
  };
  const auto output_if_due = [&] {
    const bool noted = history.due(simulation->time());
    if (cadence.due(simulation->time()))
      output();
    else if (noted)
      results->note(ledger, simulation->balance());
  };
  if (!options.resume) {
    if (gauges) gauges->observe(*simulation);
    if (recorded) exact->record(simulation->balance());
    output();
  } else if (simulation->time() < end) {
    output_if_due();  // a run that goes on beyond its former end owes the output there
  }
  const auto stopped = [&] {
    return stop_requested() || (options.wall_limit > 0 && wall_seconds() >= options.wall_limit);
  };
  while (simulation->time() < end && !stopped()) {
    simulation->advance(end);
    if (gauges) gauges->observe(*simulation);
    if (recorded) exact->record(simulation->balance());
    outcome.particle_steps += static_cast<double>(awake());
    slept += static_cast<double>(simulation->particle_count() - awake());
    progress.update(standing());
    if (simulation->time() >= end) break;
    output_if_due();
    if (checkpoints && checkpoints->due(simulation->step_count(), simulation->time())) save();
  }
  outcome.status = simulation->time() < end ? "interrupted" : "finished";
  // Before the last output, which a run that goes on from here must not find twice.
  if (checkpoints && outcome.status == "interrupted")
    result.resumable = save();
  else if (checkpoints && checkpoints->due_at_end())
    save();
  spend();
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
