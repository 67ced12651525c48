#pragma once
// Springs between a material and the ground: an optional part of the step. The force of a step,
// -K times the mean of the displacements before and after, is spread over the material's points by
// mass; it does the work that the spring's energy K u^2 / 2 loses, to round-off, and is stable in
// steps of any length.
#include <memory>
#include <vector>

#include "core/group.hpp"

namespace brisance {

template <class G>
class Springs {
 public:
  static constexpr int D = G::dim;

  /// Holds the points of a group along one direction. [N/m], per metre or square metre
  void add(int group, int direction, double stiffness) {
    springs_.push_back({group, direction, stiffness, 0, 0, {}});
  }
  bool empty() const { return springs_.empty(); }
  /// Stored in all of them. [J]
  double energy() const;
  /// All that outlives a step, for restart: of each, in the order they were added. [m]
  std::vector<double> displacements() const;
  void set_displacements(const std::vector<double>& displacements);

  /// Before the forces: what each material puts of its mass on the nodes, as its shapes have it.
  void weigh(const std::vector<std::unique_ptr<Group<G>>>& groups, const Grid<G>& grid,
             Accumulator& sums);
  /// Adds the forces of a step to those at the nodes and lengthens the springs. Returns the
  /// momentum that the ground receives. [N s]
  Vec<D> pull(const Grid<G>& grid, const Table<double>& force, double dt);

 private:
  struct Spring {
    int group, direction;
    double stiffness;
    double displacement;  ///< of the centre of mass of its points since the start [m]
    double mass;          ///< of its points [kg]
    Table<double>
        weight;  ///< mass at nodes, as a vector along the direction; 0 where walls hold it
  };
  std::vector<Spring> springs_;

  double free_advance(const Spring& s, const Grid<G>& grid, const Table<double>& force,
                      double dt) const;
  double compliance(const Spring& s, const Spring& t, const Grid<G>& grid, double dt) const;
};

}  // namespace brisance
