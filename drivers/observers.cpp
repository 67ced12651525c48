#include "drivers/observers.hpp"

#include <algorithm>

namespace brisance {

Observers::Observers(const List& scene, ExactSolution* exact)
    : exact_(exact),
      recorded_(exact && exact->records() ? exact : nullptr),
      watches_(make_watches(scene)) {}

bool Observers::look_at_particles() const {
  return std::any_of(watches_.begin(), watches_.end(),
                     [](const auto& watch) { return watch->looks_at_particles(); });
}

void Observers::follow(Simulation& simulation) {
  for (const auto& watch : watches_) watch->follow(simulation);
  if (recorded_) recorded_->record(simulation.balance());
}

void Observers::observe(const Snapshot& shot) {
  for (const auto& watch : watches_) watch->observe(shot.table, shot.time);
}

void Observers::write(const std::filesystem::path& folder, Backlog* later) const {
  for (const auto& watch : watches_) watch->write(folder, later);
}

std::vector<Measure> Observers::measures(const Snapshot& end) const {
  std::vector<Measure> all;
  const auto append = [&](const std::vector<Measure>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  if (exact_) append(exact_->measures(end.table, end.time));
  for (const auto& watch : watches_) append(watch->measures());
  return all;
}

void Observers::keep(Archive& archive) {
  if (recorded_) dynamic_cast<Remembers&>(*recorded_).keep(archive);
  for (const auto& watch : watches_) watch->keep(archive);
}

}  // namespace brisance
