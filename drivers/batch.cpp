#include "drivers/batch.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <thread>

#include "drivers/child.hpp"
#include "drivers/files.hpp"
#include "drivers/progress.hpp"
#include "drivers/run.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;

/// What a run has said of its failure: the last line, without the program's name.
std::string last_line(const fs::path& file) {
  std::istringstream lines(read_file(file));
  std::string line, last;
  while (std::getline(lines, line))
    if (!line.empty()) last = line;
  return last.rfind("brisance: ", 0) == 0 ? last.substr(10) : last;
}

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Batch::Batch(const BatchPlan& plan, fs::path folder, int jobs)
    : plan_(plan), folder_(std::move(folder)), records_(plan.runs.size()) {
  for (std::size_t k = 0; k < plan_.runs.size(); ++k) {
    needs_.push_back(need_of(folder_of(k), plan_.runs[k].input));
    if (needs_[k].work == Need::nothing)
      records_[k] = read_record(folder_of(k));
    else
      waiting_.push_back(k);
  }
  done_ = plan_.runs.size() - waiting_.size();
  const auto cores = static_cast<std::size_t>(usable_cores());
  jobs_ = jobs > 0 ? static_cast<std::size_t>(jobs)
                   : std::max<std::size_t>(1, std::min(cores, waiting_.size()));
}

std::size_t Batch::count(Need::Work work) const {
  return static_cast<std::size_t>(std::count_if(
      needs_.begin(), needs_.end(), [&](const Need& need) { return need.work == work; }));
}

fs::path Batch::folder_of(std::size_t run) const { return folder_ / "runs" / plan_.runs[run].name; }

void Batch::start(std::size_t k) {
  const PlannedRun& run = plan_.runs[k];
  const fs::path folder = folder_of(k), scene = folder_ / "scenes" / (run.name + ".xml");
  const bool goes_on = needs_[k].work == Need::rest;
  make_folder(folder);
  make_folder(scene.parent_path());
  write_file(scene, run.input);
  // If it is cut off, that of another run must not speak for it.
  fs::remove(folder / "summary.json");
  int threads = std::min(run.threads, std::max(1, usable_cores() / static_cast<int>(jobs_)));
  if (goes_on) threads = needs_[k].threads;
  const std::string number = std::to_string(threads);
  const std::vector<std::string> words =
      goes_on ? std::vector<std::string>{"restart", folder.string(), "--threads", number}
              : std::vector<std::string>{"run",           scene.string(), "--out",
                                         folder.string(), "--threads",    number};
  running_.push_back({k, start_program(words, folder / "output.log", goes_on), Clock::now()});
  std::fprintf(stderr, "%s %s, %s thread%s\n",
               goes_on ? "goes on: " : "starts:  ", run.name.c_str(), number.c_str(),
               threads > 1 ? "s" : "");
}

void Batch::finish(const Running& running, int status) {
  Record& record = records_[running.run];
  const fs::path folder = folder_of(running.run);
  record = Record();
  if (status == 0 || status == 75 || status == 130)
    record = read_record(folder);
  else {
    record.status = "failed";
    record.wall_seconds = since(running.start);
    record.remark = status > 128 ? "killed by signal " + std::to_string(status - 128)
                                 : last_line(folder / "output.log");
  }
  if (record.status != "interrupted") ++done_;
  ++ended_;
  spent_ += since(running.start);
  std::string line = record.status + ":";
  line.resize(std::max<std::size_t>(10, line.size() + 1), ' ');
  line += plan_.runs[running.run].name + ", " + readable_duration(record.wall_seconds);
  if (record.passed + record.failed > 0)
    line += ", " + std::to_string(record.passed) + " of " +
            std::to_string(record.passed + record.failed) + " checks passed";
  if (!record.remark.empty()) line += ": " + record.remark;
  line += "  (" + std::to_string(done_) + " of " + std::to_string(plan_.runs.size()) + " done";
  if (!stop_requested() && !(waiting_.empty() && running_.empty()))
    line += ", about " + readable_duration(seconds_left()) + " left";
  std::fprintf(stderr, "%s)\n", line.c_str());
}

double Batch::seconds_left() const {
  const double mean = spent_ / ended_;
  double work = mean * static_cast<double>(waiting_.size());
  for (const Running& running : running_) work += std::max(0.0, mean - since(running.start));
  const auto at_once = std::max<std::size_t>(1, std::min(jobs_, waiting_.size() + running_.size()));
  return work / static_cast<double>(at_once);
}

void Batch::run(const std::function<void()>& changed) {
  bool asked = false;
  while (!running_.empty() || (!waiting_.empty() && !stop_requested())) {
    while (!stop_requested() && !waiting_.empty() && running_.size() < jobs_) {
      const std::size_t next = waiting_.front();
      waiting_.erase(waiting_.begin());
      start(next);
    }
    if (stop_requested() && !asked) {
      asked = true;
      std::fprintf(stderr, "stopping: %zu runs are asked to write a checkpoint\n", running_.size());
      for (const Running& running : running_) ::kill(running.process, SIGTERM);
    }
    for (std::size_t k = 0; k < running_.size();) {
      const int status = ended(running_[k].process);
      if (status < 0) {
        ++k;
        continue;
      }
      const Running over = running_[k];
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(k));
      finish(over, status);
      changed();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace brisance
