#pragma once
// The built program, run as people run it.
#include <filesystem>
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

/// Starts it, waits until `file` exists, sends the signal, and waits for its end.
Ran interrupt_program(const std::vector<std::string>& arguments, const std::filesystem::path& file,
                      int signal);

std::vector<std::string> columns_of_last_line(const std::string& csv);

}  // namespace brisance::test
