#pragma once
// What of the state a run writes into its particle and grid files: the scene's list "output".
#include <string>
#include <vector>

#include "core/parameters.hpp"

namespace brisance {

/// How much the outputs of a run take on the disk.
struct OutputSize {
  double times = 0;                         ///< outputs
  double particle_file = 0, grid_file = 0;  ///< each [B]
  double all() const { return times * (particle_file + grid_file); }
  /// "about 11 times 45 kB (particles) and 3 kB (grid): 530 kB in all", for people.
  std::string text() const;
};

class OutputChoice {
 public:
  /// The schema, for a scene of these materials (as given). The columns that there are follow from
  /// their laws.
  static List valid_parameters(const List& materials, int dim);
  /// Refuses what does not go together in the list of a checked scene.
  static void check(const List& output);

  /// Of a complete scene.
  explicit OutputChoice(const List& scene);

  bool particles() const { return particles_; }
  bool grid() const { return grid_; }
  /// Numbers of 4 bytes in place of 8.
  bool single() const { return single_; }
  /// Whether a column was chosen.
  bool has(const std::string& column) const;

  /// Of a run of so many particles, cells and steps; the time runs from `start` to the end of the
  /// scene. Numbers in the files are counted, their heads are not.
  OutputSize size(double particles, double cells, double steps, double start) const;

  /// Throws InputError if that is more than the scene allows.
  static void expect_within_limit(const List& scene, const OutputSize& size);

 private:
  std::vector<std::string> columns_;  ///< empty: all
  std::vector<std::string> fields_;   ///< that materials add
  bool particles_ = true, grid_ = true, single_ = false;
  double interval_ = 0, end_, steps_ = 0;
};

/// 123456789 -> "123 MB".
std::string readable_bytes(double bytes);

}  // namespace brisance
