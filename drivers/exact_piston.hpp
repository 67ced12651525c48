#pragma once
// A piston on a spring at the end of a column of liquid, section 4.3.1 of Hu & Chen (2006).
#include "drivers/archive.hpp"
#include "drivers/exact.hpp"
#include "drivers/oscillation.hpp"

namespace brisance {

/// Liquid between a closed end at x = 0 and a rigid piston at `length`, which a spring holds to the
/// ground: the first mode, by eq. (20), w^2 m = K + rho w c cot(w L / c), everything for each
/// square metre. A spring with a mass of its own, fixed at its other end, has sqrt(K m_s) w cot(w
/// sqrt(m_s / K)) in place of K; of its modes, too, the one nearest to that of a spring without
/// mass counts.
class PistonContainer final : public ExactSolution, public Remembers {
 public:
  struct Data {
    double stiffness = 1;                         // of the spring [N/m^3]
    double piston_mass = 1, spring_mass = 0;      // [kg/m^2]
    double length = 1, density = 1, modulus = 1;  // of the liquid [m], [kg/m^3], [Pa]
    double velocity = 1;                          // of the piston at first [m/s]
    std::string piston;                           // name of its material
  };
  explicit PistonContainer(const Data& data);
  explicit PistonContainer(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  double frequency() const { return frequency_; }  // angular [rad/s]
  double period() const;

  /// Of the liquid; beyond it, the motion of the piston.
  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  bool records() const override { return true; }
  void record(const Balance& now) override;
  void keep(Archive& archive) override;
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
  double frequency_ = 0;
  Oscillation motion_;

  double sound_speed() const;
  double excess(double w, bool massless) const;
  double root_between(double low, double high, bool massless) const;
  double first_mode() const;
};

}  // namespace brisance
