#include "drivers/checks_schema.hpp"

#include <Teuchos_ParameterList.hpp>
#include <limits>

#include "drivers/exact.hpp"
#include "drivers/ledger.hpp"
#include "drivers/tradeoff_scene.hpp"
#include "drivers/watch.hpp"

namespace brisance {
namespace {

void add_range(List& list, const MeasureDoc& measure) {
  List& range = declare_optional_list(list, measure.name, measure.doc);
  const std::string unit = " [" + (measure.unit.empty() ? std::string("-") : measure.unit) + "]";
  declare(range, "least", std::numeric_limits<double>::lowest(), anything(),
          "least value that is right" + unit);
  declare(range, "most", std::numeric_limits<double>::max(), anything(),
          "greatest value that is right" + unit);
}

/// What of a scene is measured beyond its balances.
std::vector<MeasureDoc> special_measures(const List& given, const List* exact, int dim) {
  std::vector<MeasureDoc> docs = watch_docs(given);
  if (!exact) return docs;
  const auto solution = make_exact(check(*exact, valid_exact(*exact)));
  if (solution->least_dim() > dim) refuse(*exact, "solution", "needs a grid of more directions");
  for (const auto& measure : solution->measure_docs()) docs.push_back(measure);
  return docs;
}

}  // namespace

void declare_checks(List& valid, const List& given, const std::vector<std::string>& materials,
                    bool solids, int dim) {
  List& checks =
      declare_optional_list(valid, "checks", "what the run must reach; told by 'verify'");
  for (const auto& measure : balance_measures(materials, solids)) add_range(checks, measure);
  const auto measures = special_measures(given, find_list(given, "exact"), dim);
  if (measures.empty()) return;
  for (const auto& measure : measures) add_range(checks, measure);
  declare_optional_list(valid, "tradeoff", "what the command 'tradeoff' runs and measures") =
      valid_tradeoff(list_names(checks));

  List& convergence =
      declare_optional_list(valid, "convergence", "runs on several grids, by 'verify'");
  declare_required<std::vector<int>>(convergence, "cells", at_least(2),
                                     "cells along x, one run each [-]");
  List& orders = declare_optional_list(convergence, "order", "order of convergence of measures");
  List& every = declare_optional_list(convergence, "every", "what each of the runs must reach");
  for (const auto& measure : measures) {
    add_range(orders, measure);
    add_range(every, measure);
  }
}

}  // namespace brisance
