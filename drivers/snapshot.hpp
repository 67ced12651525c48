#pragma once
// All particles at one time, copied to the host: what is written, and what watches look at.
#include <cstdint>
#include <vector>

#include "core/step.hpp"
#include "drivers/measure.hpp"

namespace brisance {

struct Snapshot {
  double time = 0;  // [s]
  ParticleTable table;
  std::vector<std::int64_t> id;  ///< unique; children of a split get new ones
};

/// Those that sleep included. An earlier one of the same state gives its memory: to get that from
/// the system takes longer than to fill it.
template <class G>
Snapshot snapshot_of(const State<G>& state, Snapshot earlier);

}  // namespace brisance
