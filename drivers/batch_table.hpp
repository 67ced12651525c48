#pragma once
// The runs of a batch as a table: status, checks, wall time, what is varied, results.
#include <string>
#include <vector>

#include "drivers/batch_record.hpp"
#include "drivers/sweep.hpp"

namespace brisance {

class BatchTable {
 public:
  /// `records`: one for each run of the plan.
  BatchTable(const BatchPlan& plan, const std::vector<Record>& records);

  /// With a line of names and units at its head; numbers in full, nothing where there is none.
  std::string csv() const;

  /// For people: numbers of four digits, columns below each other.
  std::string text() const;

 private:
  using Row = std::vector<std::string>;
  Row head_;
  std::vector<Row> full_, short_;
};

}  // namespace brisance
