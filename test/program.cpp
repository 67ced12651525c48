#include "test/program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "drivers/files.hpp"
#include "drivers/locations.hpp"

namespace brisance::test {

namespace fs = std::filesystem;

namespace {
const char* const environment =
    "OMP_NUM_THREADS=2 OMP_PROC_BIND=false OMP_WAIT_POLICY=passive ASAN_OPTIONS=detect_leaks=0 ";
}

Folder::Folder(const std::string& name)
    : path(fs::temp_directory_path() / ("brisance_" + name + "_" + std::to_string(::getpid()))) {
  fs::remove_all(path);
  fs::create_directories(path);
}
Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

namespace {

/// Of a command, whose words the shell takes as they stand.
Ran run_command(const std::string& command) {
  const Folder capture("capture");
  const std::string out = (capture.path / "out").string(), err = (capture.path / "err").string();
  const int code =
      std::system((command + " >'" + out + "' 2>'" + err + "' </dev/null").c_str());
  return {WIFEXITED(code) ? WEXITSTATUS(code) : -1, read_file(out), read_file(err)};
}

Ran run_script_within(const std::string& shell, const std::string& script) {
  const Folder folder("script");
  write_file(folder.path / "script",
             std::string("brisance='env ") + environment + BRISANCE_PROGRAM + "'\n" + script);
  return run_command(shell + " " + in_quotes(folder.path / "script"));
}

}  // namespace

Ran run_program(const std::string& arguments, const fs::path& from) {
  const std::string there = from.empty() ? "" : "cd '" + from.string() + "' && ";
  return run_command(there + environment + BRISANCE_PROGRAM + " " + arguments);
}

Ran run_script(const std::string& script) { return run_script_within("sh", script); }
Ran run_script_alone(const std::string& script) {
  return run_script_within("unshare -rm sh", script);
}

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

std::string tube(const fs::path& out) {
  return "run " + in_quotes(data_folder() / "inputs/sod.xml") +
         " --threads 1 --set 'grid/cells={400}' --set 'grid/cell size=0.0025' --set "
         "'output/history interval=0.001' --set checkpoint/steps=5 --out " +
         in_quotes(out);
}

Ran meddle_with_program(const std::string& arguments, const fs::path& file,
                        const std::function<void(pid_t)>& meddle) {
  const Folder capture("capture");
  const std::string out = (capture.path / "out").string(), err = (capture.path / "err").string(),
                    command = std::string("exec env ") + environment + BRISANCE_PROGRAM + " " +
                              arguments + " >'" + out + "' 2>'" + err + "' </dev/null";
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  int code = 0;
  for (int k = 0; k < 30000 && !fs::exists(file); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  meddle(child);
  ::waitpid(child, &code, 0);
  return {WIFEXITED(code) ? WEXITSTATUS(code) : -1, read_file(out), read_file(err)};
}

Ran interrupt_program(const std::vector<std::string>& arguments, const fs::path& file, int signal) {
  std::string words;
  for (const auto& word : arguments) words += in_quotes(word) + " ";
  return meddle_with_program(words, file, [&](pid_t child) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::kill(child, signal);
  });
}

std::vector<std::string> columns_of_last_line(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, last, column;
  while (std::getline(lines, line)) last = line;
  std::vector<std::string> columns;
  std::istringstream parts(last);
  while (std::getline(parts, column, ',')) columns.push_back(column);
  return columns;
}

}  // namespace brisance::test
