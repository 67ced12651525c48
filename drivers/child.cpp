#include "drivers/child.hpp"

#include <fcntl.h>
#include <omp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <system_error>

extern char** environ;

namespace brisance {
namespace {

/// OpenMP binds the first thread to one core as soon as the program starts, if it binds at all; its
/// places still tell all of them.
bool cores_of_places(cpu_set_t& cores) {
  CPU_ZERO(&cores);
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> ids(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, ids.data());
    for (const int id : ids) CPU_SET(static_cast<std::size_t>(id), &cores);
  }
  return CPU_COUNT(&cores) > 0;
}

/// Several programs whose threads are each bound from the first core on would share that core.
std::vector<std::string> environment() {
  std::vector<std::string> all;
  for (char** entry = environ; *entry; ++entry)
    if (std::strncmp(*entry, "OMP_PROC_BIND=", 14) != 0 &&
        std::strncmp(*entry, "OMP_PLACES=", 11) != 0)
      all.emplace_back(*entry);
  all.emplace_back("OMP_PROC_BIND=false");
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (auto& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

}  // namespace

int usable_cores() {
  cpu_set_t cores;
  return cores_of_places(cores) ? CPU_COUNT(&cores) : omp_get_num_procs();
}

pid_t start_program(const std::vector<std::string>& arguments, const std::filesystem::path& said,
                    bool append) {
  const int out =
      ::open(said.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | (append ? O_APPEND : O_TRUNC), 0666);
  if (out < 0)
    throw std::runtime_error("cannot write '" + said.string() +
                             "': " + std::generic_category().message(errno));
  // Between fork and exec nothing may be allocated.
  std::vector<std::string> words = {"brisance"}, variables = environment();
  words.insert(words.end(), arguments.begin(), arguments.end());
  const auto argv = pointers(words), env = pointers(variables);
  cpu_set_t cores;
  const bool bound = cores_of_places(cores);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(127);
    if (bound) ::sched_setaffinity(0, sizeof cores, &cores);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(out, STDERR_FILENO);
    // This very program, also when another has been built in its place since.
    ::execve("/proc/self/exe", argv.data(), env.data());
    ::_exit(127);
  }
  const int error = errno;
  ::close(out);
  if (child < 0)
    throw std::runtime_error("cannot start a run: " + std::generic_category().message(error));
  return child;
}

int ended(pid_t child) {
  int code = 0;
  if (::waitpid(child, &code, WNOHANG) != child) return -1;
  return WIFEXITED(code) ? WEXITSTATUS(code) : 128 + WTERMSIG(code);
}

}  // namespace brisance
