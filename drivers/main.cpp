// The program: reads the command line and calls the command.
#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>

#include "drivers/commands.hpp"
#include "drivers/run.hpp"
#include "version.hpp"

namespace {

std::string version_text() {
  namespace v = brisance::version;
  return std::string("brisance ") + v::number + " (" + v::commit + ", " + v::compiler + ", " +
         v::build_type + ")\nKokkos " + v::kokkos + " (" + v::kokkos_devices + "), HDF5 " +
         v::hdf5 + ", " + v::mpi;
}

void add_scene(CLI::App& command, brisance::SceneRequest& scene) {
  command.add_option("SCENE", scene.file, "scene file (.xml)")->required();
  command.add_option("--preset", scene.preset, "scheme: paper, fast, balanced, accurate");
  command.add_option("--set", scene.assignments, "'list/parameter=value', any number of times")
      ->allow_extra_args(false);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace brisance;
  CLI::App app{"Blast and fragments on structures, by the material point method."};
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());

  SceneRequest scene;
  std::string folder, name, csv;
  std::vector<std::string> files;
  double time = -1;
  int threads = -1;
  const auto add_threads = [&](CLI::App* command) {
    command->add_option("--threads", threads, "threads (default: as many as pay)")
        ->check(CLI::Range(1, 4096));
  };

  double wall_limit = 0;
  const auto add_wall_limit = [&](CLI::App* command) {
    command
        ->add_option("--wall-limit", wall_limit,
                     "stop after so long by the clock, with a checkpoint and exit status 75 [s]")
        ->check(CLI::PositiveNumber);
  };

  CLI::App* run_ = app.add_subcommand("run", "run a scene");
  add_scene(*run_, scene);
  run_->add_option("--out", folder, "folder for the results (default: out/<scene>)");
  add_threads(run_);
  add_wall_limit(run_);

  RestartRequest again;
  CLI::App* restart = app.add_subcommand(
      "restart", "go on with a run from its newest good checkpoint, in the same folder");
  restart->add_option("FROM", again.from, "folder of a run, or one of its checkpoints")->required();
  restart->add_option("--until", again.until, "another simulated time to end at [s]")
      ->check(CLI::PositiveNumber);
  restart->add_option("--set", again.assignments,
                      "'list/parameter=value' of the lists output and checkpoint")
      ->allow_extra_args(false);
  add_threads(restart);
  add_wall_limit(restart);

  CLI::App* verify = app.add_subcommand("verify", "run scenes and hold them against their limits");
  verify->add_option("SCENE", files, "scene files (default: all in inputs/)");
  verify->add_option("--out", folder, "folder for the results (default: none are kept)");
  add_threads(verify);

  CLI::App* check_ = app.add_subcommand("check", "validate a scene and print what it takes");
  add_scene(*check_, scene);
  add_threads(check_);

  CLI::App* describe_ =
      app.add_subcommand("describe", "print lists and parameters with default, rule, unit and doc");
  describe_->add_option("NAME", name,
                        "a list, a law, an exact solution or a scene file; default: everything");

  CLI::App* export_ = app.add_subcommand("export", "write the particles of a run as a table");
  export_->add_option("DIR", folder, "folder of a run")->required();
  export_->add_option("--csv", csv, "file to write")->required();
  export_->add_option("--time", time,
                      "time of the output, the nearest is taken (default: the last) [s]");

  // The script has the options of its own, --help among them.
  CLI::App* plot = app.add_subcommand("plot", "make pictures of runs");
  plot->set_help_flag();
  plot->prefix_command();

  bool once = false;
  CLI::App* watch = app.add_subcommand("watch", "show how a run stands, until it ends");
  watch->add_option("DIR", folder, "folder of a run")->required();
  watch->add_flag("--once", once, "show it once and end");

  ReproduceRequest paper;
  CLI::App* reproduce_ = app.add_subcommand(
      "reproduce", "run every problem of Hu & Chen (2006) and write a page of it; takes minutes");
  reproduce_->add_option("--out", paper.folder, "folder for page and runs (default: reproduce)");
  reproduce_->add_option("--only", paper.only, "names of problems (default: all, see --list)");
  reproduce_->add_flag("--quick", paper.quick, "take up runs in the folder that are finished");
  reproduce_->add_flag("--list", paper.list, "tell problems, tables and figures, and run nothing");

  BatchRequest many;
  CLI::App* batch = app.add_subcommand(
      "batch", "run many scenes, or a sweep of one; called again, do only what is left");
  batch->add_option("WHAT", many.what, "scenes, sweeps (see describe sweep), folders of them")
      ->required();
  batch->add_option("--jobs", many.jobs, "runs at once (default: as many as there are cores)")
      ->check(CLI::Range(1, 4096));
  batch->add_option("--out", many.folder, "folder for runs and table (default: out/<name>)");
  batch->add_option("--result", many.results, "a measure for the table, any number of times")
      ->allow_extra_args(false);
  batch->add_flag("--list", many.list, "tell which runs there are to do, and run nothing");

  TradeoffRequest trade;
  CLI::App* tradeoff = app.add_subcommand(
      "tradeoff", "measure error against cost of scenes, or tell the setting to take");
  CLI::Option* trade_scenes = tradeoff->add_option("SCENE", trade.scenes, "scene files");
  tradeoff->add_flag("--all", trade.all, "all scenes of inputs/ that have a list 'tradeoff'")
      ->excludes(trade_scenes);
  tradeoff->add_option("--out", trade.folder,
                       "folder for runs, table and picture (default: out/tradeoff)");
  tradeoff->add_flag("--quick", trade.quick, "only the presets, on the two coarsest grids");
  tradeoff->add_option("--jobs", trade.jobs, "runs at once, of a thread each (default: 1)")
      ->check(CLI::Range(1, 4096));
  CLI::Option* trade_error = tradeoff->add_option(
      "--target-error", trade.target_error, "tell the cheapest setting of this error: 2%");
  tradeoff
      ->add_option("--budget", trade.budget,
                   "tell the best setting for so much time of one core: 60s, 5min, 2h")
      ->excludes(trade_error);

  std::string first, second;
  double tolerance = 0;
  CLI::App* compare = app.add_subcommand(
      "compare", "tell the largest differences of two runs; exit status 0: none beyond tolerance");
  compare->add_option("A", first, "folder of a run")->required();
  compare->add_option("B", second, "folder of another")->required();
  compare->add_option("--tolerance", tolerance, "share of a column's range (default: 0)")
      ->check(CLI::NonNegativeNumber);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  std::signal(SIGINT, [](int) { request_stop(); });
  std::signal(SIGTERM, [](int) { request_stop(); });
  int status = 0;
  try {
    if (*run_) status = run_command(scene, folder, threads, wall_limit);
    if (*restart) status = restart_command(again, threads, wall_limit);
    if (*verify) status = verify_command(files, folder, threads);
    if (*check_) status = check_command(scene, threads);
    if (*describe_) status = describe_command(name);
    if (*export_) status = export_command(folder, csv, time);
    if (*plot) status = plot_command(plot->remaining());
    if (*watch) status = watch_command(folder, once);
    if (*reproduce_) status = reproduce_command(paper);
    if (*batch) status = batch_command(many);
    if (*tradeoff) status = tradeoff_command(trade);
    if (*compare) status = compare_command(first, second, tolerance);
  } catch (const InputError& error) {
    std::fprintf(stderr, "brisance: %s\n", error.what());
    status = 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "brisance: %s\n", error.what());
    status = 1;
  }
  return status;
}
