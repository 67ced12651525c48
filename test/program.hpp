#pragma once
// The built program, run as people run it.
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace brisance::test {

/// A folder of its own for one test; gone at the end.
struct Folder {
  std::filesystem::path path;
  explicit Folder(const std::string& name);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

struct Ran {
  int status = -1;  ///< exit status; -1: killed
  std::string out, err;
};

/// Runs the program on two threads with arguments as a shell reads them.
Ran run_program(const std::string& arguments, const std::filesystem::path& from = {});

/// A script of the shell, in which $brisance is the program on two threads.
Ran run_script(const std::string& script);

/// The same as the root of a name space of its own, where a script may mount what nobody else sees.
Ran run_script_alone(const std::string& script);

std::string in_quotes(const std::filesystem::path& path);

/// Arguments of a run into a folder: a tube of some hundred steps on one thread that writes a
/// checkpoint in every fifth.
std::string tube(const std::filesystem::path& out);

/// Starts the program, waits until `file` exists, meddles with the process, and waits for its end.
Ran meddle_with_program(const std::string& arguments, const std::filesystem::path& file,
                        const std::function<void(pid_t)>& meddle);

/// Starts it, waits until `file` exists, sends the signal, and waits for its end.
Ran interrupt_program(const std::vector<std::string>& arguments, const std::filesystem::path& file,
                      int signal);

std::vector<std::string> columns_of_last_line(const std::string& csv);

}  // namespace brisance::test
