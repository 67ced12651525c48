#pragma once
// What the program can be asked to do. Each returns the exit status: 0 all well, 1 a limit missed
// or nothing done, 2 bad input (thrown as InputError), 130 stopped by the user, 75 the same (or by
// the clock) with a checkpoint from which `restart` goes on. `threads`: -1 for
// as many as pay.
#include <filesystem>
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace brisance {

struct RunResult;

/// A scene file with what the command line changes in it.
struct SceneRequest {
  std::string file;
  std::string preset;                    ///< empty: as the scene says
  std::vector<std::string> assignments;  ///< "list/parameter=value"
};

/// The complete scene; its name is that of the file. Throws InputError with file and line.
List load_scene(const SceneRequest& request);

/// The same error with its place in the scene, for what shows when a loaded scene is set up.
InputError locate(const SceneRequest& request, const InputError& error);

/// Prints how a run went. Returns the exit status.
int tell(const RunResult& result, const std::filesystem::path& folder);

/// `wall_limit`: see RunOptions.
int run_command(const SceneRequest& request, const std::string& folder, int threads,
                double wall_limit);
/// What a restart changes: the end, if it is above 0 [s], and output or checkpoints by assignments.
struct RestartRequest {
  std::string from;  ///< folder of a run, or one of its checkpoints
  double until = 0;
  std::vector<std::string> assignments;
};
int restart_command(const RestartRequest& request, int threads, double wall_limit);
int verify_command(const std::vector<std::string>& files, const std::string& folder, int threads);
int check_command(const SceneRequest& request, int threads);
int describe_command(const std::string& name);
int export_command(const std::string& folder, const std::string& csv, double time);
/// `words`: folders and options as plot.py takes them, which tells them by --help.
int plot_command(const std::vector<std::string>& words);
/// Shows how a run stands until it ends, or once.
int watch_command(const std::string& folder, bool once);

/// The problems of Hu & Chen (2006) on one page.
struct ReproduceRequest {
  std::string folder;             ///< empty: ./reproduce
  std::vector<std::string> only;  ///< names of problems; empty: all
  bool quick = false;             ///< take up finished runs
  bool list = false;              ///< only tell what there is
};
int reproduce_command(const ReproduceRequest& request);

/// Many runs, see batch.hpp. The status is 0 only if all have finished and all checks hold.
struct BatchRequest {
  std::vector<std::string> what;     ///< scenes, sweeps, and folders of them
  std::string folder;                ///< empty: out/NAME
  int jobs = 0;                      ///< runs at once; 0: as many as there are cores
  std::vector<std::string> results;  ///< measures for the table, beside those that sweeps name
  bool list = false;                 ///< only tell what there is to do
};
int batch_command(const BatchRequest& request);

/// Error against cost of scenes at many settings, see tradeoff_scene.hpp; or the setting to take.
struct TradeoffRequest {
  std::vector<std::string> scenes;
  bool all = false;          ///< in their place: all of inputs/ that have a list "tradeoff"
  std::string folder;        ///< empty: out/tradeoff
  bool quick = false;        ///< the presets alone
  int jobs = 1;              ///< runs at once, of a thread each
  std::string target_error;  ///< "2%"; empty: none
  std::string budget;        ///< "60s"; empty: none
};
int tradeoff_command(const TradeoffRequest& request);

/// Tells how two runs differ, see compare.hpp; 1 if they do, by more than the tolerance.
int compare_command(const std::string& first, const std::string& second, double tolerance);

}  // namespace brisance
