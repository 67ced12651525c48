#pragma once
// When a detonation that starts from given sources reaches a place in explosive: its lighting time.
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/eikonal.hpp"
#include "drivers/exact.hpp"

namespace brisance {

/// What the list "ignition" of a scene may hold.
List valid_ignition(const List& given, int dim);
/// Throws InputError for what does not fit together in a checked one.
void check_ignition(const List& checked);

class LightingTimes {
 public:
  /// `box` is the grid of the scene, one cell high for a line; `speed` the detonation speed at a
  /// place, 0 where there is no explosive [m/s].
  LightingTimes(const List& checked, const Eikonal::Box& box,
                std::function<double(const Place&)> speed);

  /// `never` where no detonation comes. [s]
  double at(const Place& x) const;

 private:
  /// Everything that lights at the same time: a point, the way from a to b, or a plane.
  struct Source {
    Place a{}, b{}, normal{};
    bool plane = false;
    double delay = 0;  // [s]
    bool point() const { return !plane && a == b; }
    /// The place of it that is nearest to x.
    Place nearest(const Place& x) const;
  };
  struct Disc {
    Place centre{};
    double radius = 0;
  };
  struct Arrival {
    double time = never, gx = 0, gy = 0;
  };

  Eikonal::Box refined(const Eikonal::Box& box, int refinement) const;
  std::vector<double> sampled();
  double slowness(const Place& x) const;
  Place off_discs(const Place& x) const;
  bool blocked(const Place& from, const Place& to) const;
  double along(const Place& from, const Place& to) const;
  double along_arc(const Disc& disc, double from, double angle) const;
  Arrival straight(const Source& source, const Place& x) const;
  Arrival around(const Source& source, const Disc& disc, const Place& x) const;
  bool light(const Source& source);

  std::function<double(const Place&)> speed_;
  std::vector<Source> sources_;
  std::vector<Disc> discs_;
  Eikonal::Box box_{};
  std::vector<double> matter_;     ///< slowness of the cells as if there were no discs; 0: inert
  std::unique_ptr<Eikonal> grid_;  ///< none where everything is reached along straight lines
};

}  // namespace brisance
