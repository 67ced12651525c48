#pragma once
// The shapes that bodies have. Every place is inside or outside, and shapes that share an edge
// share no place of it: a box owns its low faces and not its high ones, and so do edges in any
// direction; a circle is outside of the disc it bounds.
#include <array>
#include <variant>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/exact.hpp"

namespace brisance {

class Shape {
 public:
  /// Of a checked body; all there is where it names none. Places closer than `same` are taken for
  /// one, so that round-off decides nothing: what is symmetric is seeded symmetrically [m].
  Shape(const List& body, double same);

  bool holds(const Place& x) const;

 private:
  struct Everything {};
  struct Box {
    Place low, high;
  };
  struct HalfPlane {
    Place normal;
    double offset;  ///< of the edge along the normal [m]
  };
  /// Between two circles; a disc has an inner one of radius 0.
  struct Ring {
    Place centre;
    double inner2, outer2;  ///< squares of the radii [m^2]
  };
  struct Polygon {
    /// From its lower end to its upper one, whatever the polygon: two that share an edge compute
    /// the same.
    struct Edge {
      double x, y, dx, dy;
    };
    std::vector<Edge> edges;
    Place low, high;
  };

  static bool has(const Everything&, const Place&) { return true; }
  static bool has(const Box& box, const Place& x);
  static bool has(const HalfPlane& half, const Place& x);
  static bool has(const Ring& ring, const Place& x);
  static bool has(const Polygon& polygon, const Place& x);
  static Polygon polygon_of(const List& list);

  double same_;
  std::variant<Everything, Box, HalfPlane, Ring, Polygon> form_;
};

/// The lists that give a body its shape; on a line not all of them make sense.
void declare_shapes(List& valid, const List& given, int dim);

/// Throws InputError unless a checked body has one shape at most, and that one encloses something.
void check_shape(const List& body);

}  // namespace brisance
