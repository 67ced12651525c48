#include "drivers/batch_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace brisance {
namespace {

std::string number(double value, const char* pattern) {
  if (!std::isfinite(value)) return "";
  char text[40];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string in_csv(const std::string& text) {
  if (text.find_first_of(",\"") == text.npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::vector<Quantity> varied_in(const BatchPlan& plan) {
  std::vector<Quantity> all;
  for (const auto& run : plan.runs)
    for (const auto& [quantity, value] : run.varied)
      if (std::none_of(all.begin(), all.end(),
                       [&, &q = quantity](const auto& a) { return a.label() == q.label(); }))
        all.push_back(quantity);
  return all;
}

std::string value_in(const PlannedRun& run, const Quantity& wanted) {
  for (const auto& [quantity, value] : run.varied)
    if (quantity.label() == wanted.label()) return value;
  return "";
}

}  // namespace

BatchTable::BatchTable(const BatchPlan& plan, const std::vector<Record>& records)
    : head_{"run", "status", "checks passed", "checks failed", "wall time [s]"} {
  const auto varied = varied_in(plan);
  for (const auto& quantity : varied) head_.push_back(quantity.label());
  for (const auto& quantity : plan.results) head_.push_back(quantity.label());
  const auto row = [&](std::size_t k, const char* pattern) {
    const PlannedRun& run = plan.runs[k];
    const Record& record = records[k];
    Row cells = {run.name, record.status, std::to_string(record.passed),
                 std::to_string(record.failed), number(record.wall_seconds, "%.3f")};
    for (const auto& quantity : varied) cells.push_back(value_in(run, quantity));
    for (const auto& quantity : plan.results) {
      const auto found = record.measures.find(quantity.name);
      cells.push_back(found == record.measures.end() ? "" : number(found->second, pattern));
    }
    return cells;
  };
  for (std::size_t k = 0; k < plan.runs.size(); ++k) {
    full_.push_back(row(k, "%.17g"));
    short_.push_back(row(k, "%.4g"));
  }
}

std::string BatchTable::csv() const {
  std::string text;
  const auto add = [&](const Row& row) {
    for (std::size_t k = 0; k < row.size(); ++k) text += (k ? "," : "") + in_csv(row[k]);
    text += "\n";
  };
  add(head_);
  for (const Row& row : full_) add(row);
  return text;
}

std::string BatchTable::text() const {
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < head_.size(); ++k) {
    widths.push_back(head_[k].size());
    for (const Row& row : short_) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text;
  const auto add = [&](const Row& row) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string fill(widths[k] - row[k].size(), ' ');
      line += (k ? "  " : "") + (k < 2 ? row[k] + fill : fill + row[k]);  // numbers to the right
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  add(head_);
  for (const Row& row : short_) add(row);
  return text;
}

}  // namespace brisance
