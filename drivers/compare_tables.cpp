// Tables as texts: a line of names, then lines of numbers or words with commas between them.
#include <algorithm>
#include <charconv>
#include <sstream>

#include "drivers/compare.hpp"

namespace brisance {
namespace {

using Row = std::vector<std::string>;

Row cells_of(const std::string& line) {
  Row cells;
  std::istringstream parts(line);
  for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
  return cells;
}

struct Table {
  Row head;
  std::vector<Row> rows;

  explicit Table(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    if (std::getline(lines, line)) head = cells_of(line);
    while (std::getline(lines, line)) {
      rows.push_back(cells_of(line));
      rows.back().resize(head.size());
    }
  }

  /// The place of a column, or that of none.
  std::size_t place(const std::string& name) const {
    return static_cast<std::size_t>(std::find(head.begin(), head.end(), name) - head.begin());
  }
};

bool is_number(const std::string& text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

std::vector<double> times_of(const Table& table) {
  std::vector<double> times;
  for (const Row& row : table.rows) {
    times.push_back(0);
    is_number(row[table.place("time")], times.back());
  }
  return times;
}

}  // namespace

FileDifference compare_tables(const std::string& name, const std::string& a, const std::string& b) {
  FileDifference file{name, "", {}, {}};
  const Table one(a), other(b);
  const bool timed = one.place("time") < one.head.size() && other.place("time") < other.head.size();
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const auto pair_up = [&](std::size_t i, std::size_t j) { pairs.emplace_back(i, j); };
  if (timed) {
    match_times(times_of(one), times_of(other), "row", file.apart, pair_up);
  } else {
    for (std::size_t k = 0; k < std::min(one.rows.size(), other.rows.size()); ++k) pair_up(k, k);
    if (one.rows.size() != other.rows.size())
      file.apart.push_back("A has " + std::to_string(one.rows.size()) + " rows, B " +
                           std::to_string(other.rows.size()));
  }
  file.count = std::to_string(pairs.size()) + " rows";
  const auto where = [&](std::size_t row) {
    return timed ? "t = " + one.rows[row][one.place("time")] + " s"
                 : "row " + std::to_string(row + 1);
  };
  for (std::size_t k = 0; k < one.head.size(); ++k) {
    const std::size_t m = other.place(one.head[k]);
    if (m == other.head.size()) {
      file.apart.push_back("only in A: column '" + one.head[k] + "'");
      continue;
    }
    ColumnDifference& column = file.column(one.head[k]);
    for (const auto& [i, j] : pairs) {
      const std::string &x = one.rows[i][k], &y = other.rows[j][m];
      double p = 0, q = 0;
      if (is_number(x, p) && is_number(y, q))
        column.add(p, q, [&, row = i] { return where(row); });
      else if (x != y)
        column.add_texts(where(i) + ": '" + x + "' and '" + y + "'");
    }
  }
  for (const auto& column : other.head)
    if (one.place(column) == one.head.size())
      file.apart.push_back("only in B: column '" + column + "'");
  return file;
}

}  // namespace brisance
