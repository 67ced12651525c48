#pragma once
// How two runs differ: particles and grid at all times that both have, tables, measures.
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace brisance {

/// The largest difference of one column, and its place.
class ColumnDifference {
 public:
  explicit ColumnDifference(std::string name) : name_(std::move(name)) {}

  /// A value of either run; `where` is asked only where the difference is the largest so far. Not a
  /// number in both is no difference, in one an infinite one.
  void add(double a, double b, const std::function<std::string()>& where);
  /// Two texts that differ.
  void add_texts(const std::string& where);

  const std::string& name() const { return name_; }
  double largest() const { return largest_; }
  const std::string& where() const { return where_; }

  /// Of the column's range: greatest less least value in A; where that is 0, the greatest magnitude
  /// in A and B.
  double share() const;

 private:
  std::string name_, where_;
  double largest_ = 0, greatest_magnitude_ = 0;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

/// One table or one series of files.
struct FileDifference {
  std::string name;   ///< "history.csv", "particles"
  std::string count;  ///< what was compared: "12 rows"
  std::vector<ColumnDifference> columns;
  std::vector<std::string> apart;  ///< what only one has: "only in A: column 'mass_air'"

  /// The column of that name, a new one at its end if there is none yet.
  ColumnDifference& column(const std::string& column_name);
  bool within(double tolerance) const;
};

/// Tables with a line of names at their head. Rows are matched by their time, if they have one.
FileDifference compare_tables(const std::string& name, const std::string& a, const std::string& b);

/// Two folders of runs. Throws std::runtime_error with one line for a file that cannot be read.
std::vector<FileDifference> compare_runs(const std::filesystem::path& a,
                                         const std::filesystem::path& b);

/// Walks through two ascending lists of times: f(i, j) for those that are the same, to 1e-9 of the
/// time; those that only one has are told in `apart`, by what they are ("row").
void match_times(const std::vector<double>& a, const std::vector<double>& b,
                 const std::string& what, std::vector<std::string>& apart,
                 const std::function<void(std::size_t, std::size_t)>& f);

}  // namespace brisance
