#pragma once
// Means of the state of matter around a place, smooth in space and time: particles that come into
// reach or leave it have no weight there, so that they do not make a record jagged.
#include <array>
#include <memory>
#include <vector>

#include "core/sort.hpp"
#include "core/step.hpp"
#include "drivers/window.hpp"

namespace brisance {

/// What matter around the windows is like. Each window is summed by one thread in the order of the
/// particles: the same bits for any number of threads.
template <class G>
std::vector<Seen> probe(const State<G>& state, const std::vector<Window>& windows);

/// Windows that ride on matter: points without mass, moved as the particles of a group are.
template <class G>
class Riders {
 public:
  /// Moves those windows that ride by the step that the state has just done, of dt [s]. What has
  /// left through a free end stays where it did.
  void carry(const State<G>& state, double dt, std::vector<Window>& windows);

 private:
  static constexpr int D = G::dim;
  Particles<G> points_;
  Sorter<G> sorter_;

  void carry_with(const Group<G>& group, const State<G>& state, double dt,
                  std::vector<Window>& windows, const std::vector<int>& riders);
};

}  // namespace brisance
