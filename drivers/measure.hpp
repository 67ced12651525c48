#pragma once
// What a run is judged by: plain tables of particles, averages of them per cell and per shell, and
// named numbers. Host code on the standard library alone, so that a measure can be tested on a
// table made by hand.
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace brisance {

/// What a measure is called in the scene's list "checks", its unit, and what it means.
struct MeasureDoc {
  std::string name, unit, doc;
};

/// One number measured. Errors are fractions [-], not per cent, unless the unit says otherwise.
struct Measure {
  std::string name;
  double value = 0;
  std::string unit, doc;
};

/// The documented measures with their values; every one of them must have a value.
std::vector<Measure> with_values(const std::vector<MeasureDoc>& docs,
                                 const std::map<std::string, double>& values);

/// The particles at one time, one entry per particle in each column [SI], and the grid they live
/// on. The columns of directions beyond `dim` may stay empty.
struct ParticleTable {
  int dim = 1;
  double cell_size = 0;                 // [m]
  std::array<double, 3> origin{};       // low corner of the grid [m]
  std::array<int, 3> cells{{1, 1, 1}};  // per direction; 1 beyond dim
  std::vector<double> x, y, z, vx, vy, vz, mass, volume, density, pressure, energy;
  std::vector<int> material;  ///< number of the material, in the order of the scene

  /// Stresses and state variables that materials add; 0 where a material does not have one.
  struct Field {
    std::string name, unit;
    std::vector<double> values;
  };
  std::vector<Field> fields;
  /// The values of a field; null if no material has it.
  const std::vector<double>* field(const std::string& name) const;

  std::size_t size() const { return mass.size(); }
  /// Column of the position / velocity along a direction; std::runtime_error from `dim` on.
  const std::vector<double>& position(int direction) const;
  const std::vector<double>& velocity(int direction) const;
  /// Place and velocity of one particle; zero beyond dim.
  std::array<double, 3> place(std::size_t particle) const;
  std::array<double, 3> motion(std::size_t particle) const;
  /// Where the middle of a layer of cells across a direction lies [m].
  double layer_centre(int direction, int layer) const {
    return origin[direction] + (layer + 0.5) * cell_size;
  }
};

/// Sums over the particles of one cell, strip or shell, and the means they give: density as mass in
/// volume, pressure by volume, velocity and energy by mass. Means of an empty one must not be asked
/// for.
struct Sums {
  double mass = 0, volume = 0, pressure = 0, energy = 0;
  std::array<double, 3> momentum{};

  void add(const ParticleTable& table, std::size_t particle);
  bool empty() const { return !(mass > 0 && volume > 0); }
  double mean_density() const { return mass / volume; }
  double mean_pressure() const { return pressure / volume; }
  double mean_energy() const { return energy / mass; }
  std::array<double, 3> mean_velocity() const;
};

/// Sums per cell, x fastest; a particle off the grid counts for the nearest cell.
std::vector<Sums> sums_per_cell(const ParticleTable& table);

/// Sums per layer of cells across one direction.
std::vector<Sums> sums_per_layer(const ParticleTable& table, int direction);

/// A sampled profile: where, and how much. Empty bins have left no entry.
struct Profile {
  std::vector<double> where, value;
};

/// The last place, walking from the front of the profile to its back, where the value falls to
/// `level` or below; linear between entries. Returns `otherwise` where it never does.
double last_fall(const Profile& profile, double level, double otherwise);

/// error / scale; an error against nothing is 0 if there is none, and infinite otherwise.
double relative(double error, double scale);

/// Order of convergence: the least-squares slope of log(error) over log(h). Throws
/// std::runtime_error unless there are two or more pairs, all positive, with different h.
double order(const std::vector<double>& h, const std::vector<double>& error);

}  // namespace brisance
