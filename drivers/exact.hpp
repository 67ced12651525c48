#pragma once
// Problems with a known answer: what matter is like at any place and time, which features stand
// out, and how a table of particles is measured against them. Chosen in a scene by the parameter
// "solution" of its list "exact".
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/measure.hpp"

namespace brisance {

using Place = std::array<double, 3>;

/// Matter at one point: density [kg/m3], pressure (of solids, a third of the stress's trace, with
/// the sign of a pressure) [Pa], specific internal energy [J/kg], velocity [m/s]. In vacuum
/// everything is 0.
struct MatterState {
  double rho = 0, p = 0, e = 0;
  std::array<double, 3> v{};
};

struct Balance;

class ExactSolution {
 public:
  virtual ~ExactSolution() = default;

  /// Matter at place x and time t >= 0.
  virtual MatterState at(const Place& x, double t) const = 0;

  /// Whether it depends on the distance from a centre alone, and that centre; else on x.
  virtual bool radial() const { return false; }
  virtual Place centre() const { return {}; }

  /// How many directions the grid must resolve for it to be this problem.
  virtual int least_dim() const { return 1; }

  /// The numbers that characterise the solution at time t > 0: plateaus, wave positions, front
  /// radius.
  virtual std::vector<Measure> features(double t) const = 0;

  /// The measures that exist for these data (no "shock position" without a shock); their names are
  /// the names of the sublists allowed in "checks".
  virtual std::vector<MeasureDoc> measure_docs() const = 0;

  /// Whether it is measured along the run: then `record` is to be called at the start and after
  /// each step.
  virtual bool records() const { return false; }
  virtual void record(const Balance&) {}

  /// Their values for a table taken at time t > 0, in the order of measure_docs().
  virtual std::vector<Measure> measures(const ParticleTable& table, double t) const = 0;
};

/// The valid list of the solution that `given` names in "solution". Throws InputError if there is
/// none such.
List valid_exact(const List& given);

/// The solution described by a list checked against valid_exact().
std::unique_ptr<ExactSolution> make_exact(const List& checked);

/// All that make_exact knows, for an overview of what can be asked for.
std::vector<std::string> exact_solutions();

/// Every measure that the named solution may have, whatever its data. Throws InputError if there is
/// none such.
std::vector<MeasureDoc> possible_measures(const std::string& solution);

/// Two states of one perfect gas, set free at an interface at t = 0. Source: Toro, Riemann Solvers
/// and Numerical Methods for Fluid Dynamics (2009), chapter 4. Vacuum (density 0) may lie on one
/// side or open up between them; a cold side (pressure 0) is allowed.
class Riemann final : public ExactSolution {
 public:
  struct Side {
    double rho, u, p;
  };
  struct Data {
    Side left, right;
    double gamma = 1.4;
    double interface = 0;  // where it is at t = 0 [m]
    int direction = 0;     // along which everything happens
    /// The stretch of the direction where errors are measured, for bodies that end inside the grid
    /// [m].
    double measured_from = std::numeric_limits<double>::lowest();
    double measured_to = std::numeric_limits<double>::max();
  };
  /// What runs into one side. A shock has head = tail; speeds are those in the frame of the tube
  /// [m/s].
  struct Wave {
    enum class Kind { nothing, shock, fan } kind = Kind::nothing;
    double head = 0, tail = 0;
    double rho = 0;  // behind the wave, up to the contact [kg/m3]
    double u = 0;    // behind the wave [m/s]
  };

  /// Throws InputError for data that are no gas: nothing on either side, pressure without density.
  explicit Riemann(const Data& data);
  explicit Riemann(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  int least_dim() const override { return data_.direction + 1; }
  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override;
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

  /// (rho, u, p) at the similarity speed x / t measured from the interface.
  Side sample(double speed) const;

  /// Vacuum beside the contact, present from the start or opening up: there is no star state then.
  bool vacuum() const { return vacuum_; }
  double star_pressure() const { return p_star_; }
  double star_velocity() const { return u_star_; }
  const Wave& wave(int k) const { return wave_[k]; }  // 0 left, 1 right
  double position(double speed, double t) const { return data_.interface + speed * t; }

 private:
  const Side& side(int k) const { return k == 0 ? data_.left : data_.right; }
  void find_star();
  void find_wave(int k);
  Side sample_side(int k, double speed) const;

  bool is_measured(double place) const {
    return place >= data_.measured_from && place <= data_.measured_to;
  }
  double shock_position(const ParticleTable& table, double t) const;
  double fan_noise(const ParticleTable& table, double t) const;
  struct Excess {
    double pressure = 0, energy = 0;
  };
  Excess overshoot(const ParticleTable& table, double t) const;

  Data data_;
  std::array<double, 2> sound_{};
  std::array<Wave, 2> wave_;
  double p_star_ = 0, u_star_ = 0;
  bool vacuum_ = false;
};

/// A strong explosion from a plane, a line or a point into a uniform gas. Source: Sedov (1959),
/// chapter IV; the similarity equations are integrated numerically, which needs no case
/// distinctions (the closed forms: Kamm & Timmes, On Efficient Generation of Numerically Robust
/// Sedov Solutions, 2007).
class Sedov final : public ExactSolution {
 public:
  struct Data {
    int symmetry = 2;  // 1 planar, 2 cylindrical, 3 spherical
    double energy =
        1;  // released: per area of the plane (both sides) [J/m2], per length [J/m], in all [J]
    double density = 1;   // ambient [kg/m3]
    double pressure = 0;  // ambient [Pa]; the blast is taken as infinitely stronger
    double gamma = 1.4;
    Place centre{};
  };

  explicit Sedov(const Data& data);
  explicit Sedov(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  bool radial() const override { return true; }
  int least_dim() const override { return data_.symmetry; }
  Place centre() const override { return data_.centre; }

  /// The energy diverges at the centre, where the density vanishes; it is cut where rho < 1e-30 of
  /// ambient.
  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override;
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

  /// In energy = alpha density radius^(symmetry + 2) / time^2.
  double alpha() const { return alpha_; }
  double kinetic_share() const { return kinetic_share_; }
  double radius(double t) const;
  double front_speed(double t) const;
  double peak_pressure(double t) const;  // just behind the front
  double central_pressure(double t) const;

  /// Density, radial velocity and pressure at r / radius, as fractions of those just behind the
  /// front.
  struct Fractions {
    double rho, u, p;
  };
  Fractions profile(double fraction_of_radius) const;

 private:
  void integrate();
  double distance(const Place& x) const;

  Data data_;
  double alpha_ = 0, kinetic_share_ = 0;
  double step_ = 0;                            // in ln(r / radius), negative
  std::vector<double> log_g_, slope_, log_p_;  // density, velocity / r, pressure along it
};

/// A small plane wave running up the direction through a uniform stream: density rho0 (1 + a s),
/// pressure isentropic, velocity u0 + a c s, with s = sin(2 pi (x - (u0 + c) t) / wavelength).
/// First order in a: in truth the wave steepens, by a relative error of about a (gamma + 1) pi t c
/// / wavelength.
class AcousticWave final : public ExactSolution {
 public:
  struct Data {
    double amplitude = 1e-4, wavelength = 1, density = 1, pressure = 1, velocity = 0, gamma = 1.4;
    int direction = 0;
  };

  explicit AcousticWave(const Data& data) : data_(data) {}
  explicit AcousticWave(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  double sound_speed() const;
  int least_dim() const override { return data_.direction + 1; }
  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
};

/// An isentropic vortex carried along by a uniform stream through a periodic square box. Source:
/// Shu, in Advanced Numerical Approximation of Nonlinear Hyperbolic Equations (1998), chapter 4.
class Vortex final : public ExactSolution {
 public:
  struct Data {
    double strength = 5, radius = 1, box_length = 10, density = 1, pressure = 1, gamma = 1.4;
    Place centre{{5, 5, 0}}, velocity{};
  };

  explicit Vortex(const Data& data);
  explicit Vortex(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  int least_dim() const override { return 2; }
  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
};

/// A gas that is the same everywhere and must stay so.
class Uniform final : public ExactSolution {
 public:
  struct Data {
    double density = 1, pressure = 1, gamma = 1.4;
    Place velocity{};
  };

  explicit Uniform(const Data& data) : data_(data) {}
  explicit Uniform(const List& list);
  static List valid_parameters();
  static std::vector<MeasureDoc> possible_measures();

  MatterState at(const Place& x, double t) const override;
  std::vector<Measure> features(double t) const override;
  std::vector<MeasureDoc> measure_docs() const override { return possible_measures(); }
  std::vector<Measure> measures(const ParticleTable& table, double t) const override;

 private:
  Data data_;
};

}  // namespace brisance
