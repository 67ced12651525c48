#pragma once
// Problems of solids with a known answer, all along x in a plate that does not strain across
// (modulus M = K + 4 G / 3), or in a bar where Poisson's ratio is zero. At small strains: by v / c
// where v is the velocity of the matter and c that of its waves.
#include "drivers/exact.hpp"

namespace brisance {

/// The matter of a plate, as its material has it.
struct PlateMatter {
  double density = 1, young = 1, poisson = 0;  // [kg/m3], [Pa], [-]

  double bulk() const { return young / (3 * (1 - 2 * poisson)); }
  double shear() const { return young / (2 * (1 + poisson)); }
  double constrained() const { return bulk() + 4 * shear() / 3; }
  double wave_speed() const;     // of elastic waves [m/s]
  double plastic_speed() const;  // of plastic waves, sqrt(K / rho) [m/s]
  /// The state where the elastic stress along x [Pa] and the velocity [m/s] are these.
  MatterState elastic_state(double stress, double velocity) const;
};
void declare_plate(List& valid);
PlateMatter plate_of(const List& list);

/// The first mode of a plate between a wall at `origin` and its free end: velocity
/// v sin(k x) cos(w t), stress rho c v cos(k x) sin(w t), k = pi / (2 length), w = c k.
class StandingWave final : public ExactSolution {
 public:
  struct Data {
    PlateMatter matter;
    double origin = 0, length = 1, velocity = 1;
  };
  explicit StandingWave(const Data& data) : data_(data) {}
  explicit StandingWave(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  double period() const;
  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
  double wave_number() const;
};

/// A plate, free at both ends, part of which moves at first: D'Alembert's waves, mirrored at the
/// ends.
class PlateImpact final : public ExactSolution {
 public:
  struct Data {
    PlateMatter matter;
    double low = 0, high = 1;                  // ends of the plate [m]
    double moving_from = 0, moving_to = 0.25;  // what moves at first [m]
    double velocity = 1;                       // its velocity [m/s]
  };
  explicit PlateImpact(const Data& data) : data_(data) {}
  explicit PlateImpact(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  MatterState at(const Place& x, double t) const override;
  /// Along x. [Pa]
  double stress(double x, double t) const;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
  double initial_velocity(double x) const;
  double plateau() const;  // rho c v / 2 [Pa]
};

/// A plate that runs against a wall at `origin` and yields: an elastic precursor at the yield
/// stress, then a plastic wave. Perfectly plastic (von Mises). Source: Davison, Fundamentals of
/// Shock Wave Propagation in Solids (2008), chapter 8.
class PlasticWave final : public ExactSolution {
 public:
  struct Data {
    PlateMatter matter;
    double yield = 1;     // yield stress [Pa]
    double velocity = 1;  // towards the wall [m/s]
    double origin = 0;
  };
  explicit PlasticWave(const Data& data);
  explicit PlasticWave(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  /// Hugoniot elastic limit, Y (1 - nu) / (1 - 2 nu). [Pa]
  double elastic_limit() const;
  MatterState at(const Place& x, double t) const override;
  double stress(double x, double t) const;  // along x [Pa]
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
  double elastic_jump() const;  // of velocity in the precursor [m/s]
  double final_stress() const;  // behind both waves [Pa]
  double precursor(double t) const;
  double plastic_front(double t) const;
};

}  // namespace brisance
