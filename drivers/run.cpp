#include "drivers/run.hpp"

#include <Teuchos_ParameterList.hpp>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <optional>

#include "drivers/checkpoint.hpp"
#include "drivers/files.hpp"
#include "drivers/input.hpp"
#include "drivers/progress.hpp"
#include "drivers/recording.hpp"
#include "drivers/runtime.hpp"
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

std::unique_ptr<ExactSolution> exact_of(const List& scene) {
  const List* list = find_list(scene, "exact");
  return list ? make_exact(*list) : nullptr;
}

/// One run: all that it consists of, and the order of things.
class Run {
 public:
  Run(const List& scene, const RunOptions& options)
      : scene_(scene),
        options_(options),
        exact_(exact_of(scene)),
        simulation_(
            keeper_.on(TimeKeeper::set_up, [&] { return make_simulation(scene, exact_.get()); })),
        end_(get<double>(scene.sublist("time"), "end")),
        ledger_(simulation_->balance()),
        recording_(scene, *simulation_, ledger_, exact_.get(), keeper_) {}

  RunResult go() {
    begin();
    if (!options_.resume) {
      recording_.follow();
      recording_.output_if_seen();
    } else if (simulation_->time() < end_) {
      recording_.output_if_due();  // owed by a run that goes on beyond its former end
    }
    while (simulation_->time() < end_ && !stopped()) {
      step();
      if (simulation_->time() >= end_) break;
      recording_.output_if_due();
      if (checkpoints_ && checkpoints_->due(simulation_->step_count(), simulation_->time())) save();
    }
    return finish();
  }

 private:
  TimeKeeper keeper_;  // first: it counts from here
  const List& scene_;
  const RunOptions& options_;
  const std::unique_ptr<ExactSolution> exact_;
  const std::unique_ptr<Simulation> simulation_;
  const double end_;  // [s]
  Ledger ledger_;
  Recording recording_;
  std::optional<Checkpoints> checkpoints_;
  std::optional<Progress> progress_;
  RunResult result_;
  Outcome& outcome_ = result_.outcome;
  double slept_ = 0;  // particle-steps

  std::chrono::steady_clock::time_point started_;
  double wall_before_ = 0, cpu_before_ = 0;  // spent before this process or its first step [s]

  long awake() const {
    const auto sleeping = simulation_->sleeping();
    return simulation_->particle_count() - (sleeping ? sleeping->particles : 0);
  }
  Standing standing() const {
    return {simulation_->time(), simulation_->dt(), simulation_->step_count(), awake()};
  }
  double wall_seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  }
  void spend() {
    outcome_.wall_seconds = wall_before_ + wall_seconds();
    outcome_.cpu_seconds = cpu_before_ + cpu_seconds();
  }
  bool stopped() const {
    return stop_requested() || (options_.wall_limit > 0 && wall_seconds() >= options_.wall_limit);
  }

  /// All that outlives a step, in either direction.
  void keep(Archive& archive) {
    simulation_->keep(archive);
    ledger_.keep(archive);
    recording_.keep(archive);
    if (checkpoints_) checkpoints_->keep(archive);
    const Archive::Part part(archive, "spent");
    archive.keep("wall seconds", outcome_.wall_seconds);
    archive.keep("cpu seconds", outcome_.cpu_seconds);
    archive.keep("particle steps", outcome_.particle_steps);
    archive.keep("slept", slept_);
  }

  /// Refuses what the disk has no room for, opens the folder, and takes up a checkpoint.
  void begin() {
    const bool writes = !options_.folder.empty();
    bool others = false;
    if (writes) {
      if (!options_.resume) expect_room_for_output();  // before anything is touched
      others = !options_.resume && set_aside_checkpoints(options_.folder);
      recording_.open(options_.folder, scene_);
      checkpoints_.emplace(scene_, options_.folder);
    }
    Progress::Options shown;
    shown.end = end_;
    shown.quiet = options_.quiet;
    if (writes) shown.log = options_.folder / "log.txt";
    if (options_.resume) {
      keep(*options_.resume);
      if (writes) expect_room_for_output();
      shown.resumed_at = simulation_->time();
      outcome_.resumed = true;
    }
    progress_.emplace(shown);
    if (others) progress_->note("checkpoints of an earlier run are now in 'checkpoints.before'");
    for (const auto& line : options_.notes) progress_->note(line);
    started_ = std::chrono::steady_clock::now();
    wall_before_ = outcome_.wall_seconds;
    cpu_before_ = outcome_.cpu_seconds - cpu_seconds();
  }

  void expect_room_for_output() const {
    const OutputSize size = output_size(scene_, *simulation_);
    OutputChoice::expect_within_limit(scene_, size);
    make_folder(options_.folder);
    expect_room(options_.folder, "the output into '" + options_.folder.string() + "'", size.all());
  }

  void step() {
    keeper_.step([&] { simulation_->advance(end_); });
    recording_.follow();
    const double awake_now = static_cast<double>(awake());
    outcome_.particle_steps += awake_now;
    slept_ += static_cast<double>(simulation_->particle_count()) - awake_now;
    progress_->update(standing());
  }

  /// A disk that is full must not end a run that can go on.
  bool save() {
    return keeper_.on(TimeKeeper::checkpoints, [&] {
      try {
        spend();
        recording_.secure();
        Archive archive;
        keep(archive);
        checkpoints_->write(head_of(scene_, *simulation_), std::move(archive));
        return true;
      } catch (const std::exception& error) {
        progress_->note(std::string("no checkpoint: ") + error.what());
        return false;
      }
    });
  }

  RunResult finish() {
    outcome_.status = simulation_->time() < end_ ? "interrupted" : "finished";
    // Before the last output, which a run that goes on from here must not find twice.
    if (checkpoints_ && outcome_.status == "interrupted")
      result_.resumable = save();
    else if (checkpoints_ && checkpoints_->due_at_end())
      save();
    spend();
    progress_->finish(standing());
    if (const auto sleeping = simulation_->sleeping()) {
      outcome_.asleep = {slept_, sleeping->impulse};
      char text[60];
      std::snprintf(text, sizeof text, "asleep: %.3g %% of particle-steps saved",
                    100 * outcome_.share_asleep());
      progress_->note(text);
    }
    const Balance& end = result_.end = simulation_->balance();
    result_.cell_size = get<double>(scene_.sublist("grid"), "cell size");
    const Snapshot& shot = recording_.last_output();
    measure(shot);
    recording_.write_exact(shot);
    const bool writes = !options_.folder.empty();
    if (writes) keeper_.on(TimeKeeper::disk, [&] { recording_.secure(); });
    outcome_.spent = keeper_.so_far();
    if (writes)
      write_file(options_.folder / "summary.json", summary_text(scene_, outcome_, ledger_, end));
    result_.report = report(scene_, outcome_, ledger_, end, options_.folder);
    for (const auto& line : result_.report) progress_->log(line);
    return std::move(result_);
  }

  void measure(const Snapshot& shot) {
    outcome_.measures = ledger_.measures(result_.end);
    for (const Measure& m : recording_.measures(shot)) outcome_.measures.push_back(m);
    if (outcome_.status == "finished")
      outcome_.verdicts = judge(find_list(scene_, "checks"), outcome_.measures);
  }
};

}  // namespace

void request_stop() { stop_flag = 1; }
bool stop_requested() { return stop_flag; }

OutputSize output_size(const List& scene, const Simulation& simulation) {
  const Footprint f = simulation.footprint();
  const double left = get<double>(scene.sublist("time"), "end") - simulation.time();
  return OutputChoice(scene).size(f.particles, f.cells, std::ceil(left / simulation.dt()),
                                  simulation.time());
}

RunResult run(const List& scene, const RunOptions& options) { return Run(scene, options).go(); }

}  // namespace brisance
