#include "drivers/compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drivers/commands.hpp"

namespace brisance {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// "only in A: 3 outputs, t = 0.1 to 0.3 s"
void tell_apart(const char* run, const std::string& what, const std::vector<double>& times,
                std::vector<std::string>& apart) {
  if (times.empty()) return;
  std::string text = std::string("only in ") + run + ": " + std::to_string(times.size()) + " " +
                     what + (times.size() > 1 ? "s" : "") + ", t = " + number(times.front());
  if (times.size() > 1) text += " to " + number(times.back());
  apart.push_back(text + " s");
}

void print(const FileDifference& file) {
  std::printf("%s: %s, %zu columns\n", file.name.c_str(), file.count.c_str(), file.columns.size());
  std::size_t same = 0, width = 0;
  for (const auto& column : file.columns) width = std::max(width, column.name().size());
  for (const auto& column : file.columns) {
    if (column.largest() == 0) {
      ++same;
      continue;
    }
    std::printf("  %-*s  differs by %.3g, %.3g of its range, at %s\n", static_cast<int>(width),
                column.name().c_str(), column.largest(), column.share(), column.where().c_str());
  }
  if (same > 0) std::printf("  %s%zu the same\n", same == file.columns.size() ? "all " : "", same);
  for (const auto& line : file.apart) std::printf("  %s\n", line.c_str());
}

void require_run(const std::string& folder) {
  const std::filesystem::path path = folder;
  if (!std::filesystem::is_directory(path)) throw InputError("", "", "", "is not a folder", folder);
  if (!std::filesystem::exists(path / "input.xml"))
    throw InputError("", "", "", "holds no run: it has no input.xml", folder);
}

}  // namespace

void ColumnDifference::add(double a, double b, const std::function<std::string()>& where) {
  if (std::isfinite(a)) {
    low_ = std::min(low_, a);
    high_ = std::max(high_, a);
    greatest_magnitude_ = std::max(greatest_magnitude_, std::fabs(a));
  }
  if (std::isfinite(b)) greatest_magnitude_ = std::max(greatest_magnitude_, std::fabs(b));
  if (a == b || (std::isnan(a) && std::isnan(b))) return;
  double difference = std::fabs(a - b);
  if (std::isnan(difference)) difference = std::numeric_limits<double>::infinity();
  if (!(difference > largest_)) return;
  largest_ = difference;
  where_ = where();
}

void ColumnDifference::add_texts(const std::string& where) {
  if (largest_ == std::numeric_limits<double>::infinity()) return;
  largest_ = std::numeric_limits<double>::infinity();
  where_ = where;
}

double ColumnDifference::share() const {
  if (largest_ == 0) return 0;
  return largest_ / (high_ > low_ ? high_ - low_ : greatest_magnitude_);
}

ColumnDifference& FileDifference::column(const std::string& column_name) {
  for (auto& column : columns)
    if (column.name() == column_name) return column;
  return columns.emplace_back(column_name);
}

bool FileDifference::within(double tolerance) const {
  return apart.empty() && std::all_of(columns.begin(), columns.end(), [&](const auto& column) {
           return column.share() <= tolerance;
         });
}

void match_times(const std::vector<double>& a, const std::vector<double>& b,
                 const std::string& what, std::vector<std::string>& apart,
                 const std::function<void(std::size_t, std::size_t)>& f) {
  constexpr double same = 1e-9;
  std::vector<double> only_a, only_b;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const bool both = i < a.size() && j < b.size();
    if (both && std::fabs(a[i] - b[j]) <= same * std::max(std::fabs(a[i]), std::fabs(b[j])))
      f(i++, j++);
    else if (j == b.size() || (both && a[i] < b[j]))
      only_a.push_back(a[i++]);
    else
      only_b.push_back(b[j++]);
  }
  tell_apart("A", what, only_a, apart);
  tell_apart("B", what, only_b, apart);
}

int compare_command(const std::string& first, const std::string& second, double tolerance) {
  require_run(first);
  require_run(second);
  std::printf("A: %s\nB: %s\n", first.c_str(), second.c_str());
  bool within = true;
  double largest = 0;
  for (const auto& file : compare_runs(first, second)) {
    print(file);
    within = within && file.within(tolerance);
    for (const auto& column : file.columns) largest = std::max(largest, column.share());
  }
  std::printf("%s: largest difference %.3g of a column's range, tolerance %g\n",
              within ? "the same" : "different", largest, tolerance);
  return within ? 0 : 1;
}

}  // namespace brisance
