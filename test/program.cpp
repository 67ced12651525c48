#include "test/program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "drivers/files.hpp"

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

Ran run_program(const std::string& arguments, const fs::path& from) {
  const Folder capture("capture");
  const std::string out = (capture.path / "out").string(), err = (capture.path / "err").string();
  const std::string there = from.empty() ? "" : "cd '" + from.string() + "' && ";
  const int code = std::system((there + environment + BRISANCE_PROGRAM + " " + arguments + " >'" +
                                out + "' 2>'" + err + "' </dev/null")
                                   .c_str());
  return {WIFEXITED(code) ? WEXITSTATUS(code) : -1, read_file(out), read_file(err)};
}

Ran interrupt_program(const std::vector<std::string>& arguments, const fs::path& file, int signal) {
  const Folder capture("capture");
  const std::string out = (capture.path / "out").string(), err = (capture.path / "err").string();
  std::vector<char*> words = {const_cast<char*>(BRISANCE_PROGRAM)};
  for (const auto& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
  words.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("OMP_NUM_THREADS", "2", 1);
    ::setenv("OMP_PROC_BIND", "false", 1);
    ::setenv("OMP_WAIT_POLICY", "passive", 1);
    if (!std::freopen(out.c_str(), "w", stdout) || !std::freopen(err.c_str(), "w", stderr))
      ::_exit(126);
    ::execv(BRISANCE_PROGRAM, words.data());
    ::_exit(127);
  }
  int code = 0;
  for (int k = 0; k < 3000 && !fs::exists(file); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  ::kill(child, signal);
  ::waitpid(child, &code, 0);
  return {WIFEXITED(code) ? WEXITSTATUS(code) : -1, read_file(out), read_file(err)};
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
