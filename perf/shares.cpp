#include "perf/shares.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace brisance::perf {
namespace {

/// Null if there is no such field.
const std::vector<double>* field(const Snapshot& shot, const std::string& name) {
  for (const auto& f : shot.table.fields)
    if (f.name == name) return &f.values;
  return nullptr;
}

}  // namespace

std::map<std::string, double> shares_of(Simulation& simulation) {
  const Snapshot before = simulation.snapshot();
  simulation.advance(std::numeric_limits<double>::max());
  const Snapshot after = simulation.snapshot();
  const auto all = static_cast<double>(after.id.size());
  std::map<std::string, double> shares;
  const auto* strain = field(after, "plastic strain");
  if (strain) {
    const auto* strain_before = field(before, "plastic strain");
    std::unordered_map<std::int64_t, double> of;
    for (std::size_t k = 0; k < before.id.size(); ++k) of[before.id[k]] = (*strain_before)[k];
    double yielding = 0;
    for (std::size_t k = 0; k < after.id.size(); ++k) yielding += (*strain)[k] > of[after.id[k]];
    shares["yielding"] = yielding / all;
  }
  for (const auto& [share, name] : {std::pair{"damaged", "damage"}, {"failed", "decohesion"}})
    if (const auto* values = field(after, name))
      shares[share] = static_cast<double>(std::count_if(values->begin(), values->end(),
                                                        [](double v) { return v > 0; })) /
                      all;
  return shares;
}

}  // namespace brisance::perf
