#pragma once
// Bodies: where matter is at the start, and its particles.
#include <memory>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "core/step.hpp"
#include "drivers/exact.hpp"
#include "drivers/shapes.hpp"

namespace brisance {

/// A body as numbers.
struct Body {
  std::string material;
  int per_cell = 1;        ///< particles along each direction of a cell
  bool by_points = false;  ///< owns single points, else whole cells by their centres
  bool exact = false, from_energy = false;
  double density = 0, state = 0;  ///< state: pressure [Pa] or specific energy [J/kg]
  std::vector<double> velocity;
  Shape shape;

  Body(const List& list, double same);
};

/// All bodies of a checked scene. The first that holds a place owns it.
class Bodies {
 public:
  explicit Bodies(const List& scene);

  const std::vector<Body>& all() const { return bodies_; }
  /// The number of the owner of a place, or of that place in a cell whose centre is known; -1: it
  /// is nobody's.
  int owner(const Place& x) const;
  int owner(const Place& x, const Place& centre) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (bodies_[b].shape.holds(bodies_[b].by_points ? x : centre)) return static_cast<int>(b);
    return -1;
  }

 private:
  std::vector<Body> bodies_;
  std::vector<double> origin_;
  double h_;
};

/// Fills the groups, one for each material of the scene in its order, with the particles of the
/// scene's bodies.
template <class G>
void seed(State<G>& state, const List& scene, const ExactSolution* exact);

}  // namespace brisance
