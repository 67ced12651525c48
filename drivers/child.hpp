#pragma once
// This program as processes of its own.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace brisance {

/// Cores that this process may use, also where its own threads are bound to some of them.
int usable_cores();

/// Starts the program with arguments; all that it says goes into a file, behind what is there if
/// `append`. It may use all cores of usable_cores(), its threads are not bound to any, and it is
/// asked to stop (SIGTERM) if this process ends first. Throws std::runtime_error with one line.
pid_t start_program(const std::vector<std::string>& arguments, const std::filesystem::path& said,
                    bool append);

/// The exit status of a child that has ended, 128 + signal if it was killed, -1 while it runs.
int ended(pid_t child);

}  // namespace brisance
