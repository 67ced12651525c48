#pragma once
// A steady detonation in a slab lit at a wall: Chapman-Jouguet front, Taylor's fan, products at
// rest.
#include "drivers/exact.hpp"
#include "materials/jwl.hpp"

namespace brisance {

/// The constants of a JWL explosive, under the names of the material.
void declare_products(List& valid);
Jwl products_of(const List& list);

/// The slab is lit at x = `wall` at t = 0. Behind the front, which runs at the speed D of Chapman
/// and Jouguet, the products expand along an isentrope, x / t = u + c with du = c drho / rho, down
/// to rest. Source: Taylor, Proceedings of the Royal Society A 200 (1950) 235-247.
class Detonation final : public ExactSolution {
 public:
  struct Data {
    Jwl products;
    double wall = 0;  // where the slab is lit [m]
  };
  explicit Detonation(const Data& data);
  explicit Detonation(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  const ChapmanJouguet& chapman_jouguet() const { return cj_; }
  double plateau() const { return pressure(fan_.back().volume); }  // of the products at rest [Pa]
  double tail_speed() const { return fan_.back().speed; }  // of the fan's end, their sound [m/s]

  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  struct Point {
    double speed = 0, volume = 1, u = 0;  // x / t [m/s], over the initial one [-], [m/s]
  };
  Data data_;
  ChapmanJouguet cj_;
  double isentrope_ = 0;    // C of p = A exp(-R1 V) + B exp(-R2 V) + C / V^(1 + omega) [Pa]
  std::vector<Point> fan_;  // from the front to rest

  double pressure(double volume) const;
  double energy(double volume) const;
  double sound_speed(double volume) const;
  MatterState products_at(const Point& point) const;
};

}  // namespace brisance
