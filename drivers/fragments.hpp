#pragma once
// The pieces into which a solid has broken: which points hang together, how heavy, how fast and of
// which shape each piece is. Switched on by the scene's list "fragments".
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drivers/watch.hpp"

namespace brisance {

/// Sums over points. Energy of motion in J, per metre (plane) or square metre (line).
struct MotionSums {
  long points = 0;
  double mass = 0, kinetic = 0;
  std::array<double, 3> momentum{};
};

struct Fragment {
  long points = 0;
  double mass = 0, volume = 0;                 // [kg], [m^3]
  std::array<double, 3> centre{}, velocity{};  // of mass [m], [m/s]
  double spin = 0;                             ///< about z, of the angular momentum [rad/s]
  double translation = 0, rotation = 0;        ///< energies of the rigid motion [J]
  double rest = 0;                             ///< energy of what moves within the piece [J]
  double size = 0;                             ///< edge of the square of its volume [m]
  double length = 0, width = 0;  ///< edges of the rectangle of the same second moments [m]

  double speed() const;
  /// Length over width; 1 is chunky. Nothing of that is known on a line.
  double slenderness() const { return width > 0 ? length / width : std::nan(""); }
};

/// All pieces of one material, the heaviest first; equal ones in the order of x, then y.
struct Fragments {
  std::vector<Fragment> pieces;
  MotionSums dust, all;  ///< what belongs to no piece; everything, summed at once

  /// Pieces and dust against everything; momentum over sqrt(2 mass energy). [-]
  double mass_error() const;
  double momentum_error() const;
  double energy_error() const;
};

/// Two points hang together when they are closer than `reach` times the mean of their sizes. The
/// distance is Euclid's, since pieces turn: a lattice that hangs together must do so at any angle.
/// Points that have lost all strength (a field "decohesion", "damage" or "failed" of 1) are dust if
/// `dust` says so. Ends that are joined (periodic) are ends here.
Fragments find_fragments(const ParticleTable& table, int material, double reach, bool dust);

class FragmentWatch final : public Watch {
 public:
  FragmentWatch(const List& list, const WatchedMaterials& materials);
  static List valid_parameters(const std::vector<std::string>& materials);
  static std::vector<MeasureDoc> measure_docs();

  void observe(const ParticleTable& table, double time) override;
  /// Of the first table at or past the time asked for, else of the last one.
  std::vector<Measure> measures() const override;
  void keep(Archive& archive) override;
  /// fragments.csv: a row for each piece of each output.
  void write(const std::filesystem::path& folder, Backlog* later) const override;

 private:
  int material_;
  double reach_, least_mass_, at_;
  bool dust_;
  Fragments found_;  ///< what measures() tells of
  bool settled_ = false;
  std::string rows_;
};

}  // namespace brisance
