#include "perf/boxes.hpp"

#include <Teuchos_ParameterList.hpp>
#include <cmath>
#include <vector>

#include "drivers/scene.hpp"

namespace brisance::perf {
namespace {

constexpr double drift_x = 0.3, drift_y = 0.2;  ///< over the speed of sound
constexpr double solid_cell = 0.02;             ///< [m]
constexpr double pi = 3.14159265358979323846;

/// All but material and start; h: cell size [m].
List empty_box(const std::string& preset, int cells, double h, const std::string& material) {
  List scene("box");
  scene.set("geometry", "plane strain").set("preset", preset);
  scene.sublist("grid").set("cells", Teuchos::Array<int>(std::vector<int>{cells, cells}));
  scene.sublist("grid").set("cell size", h);
  for (const char* end : {"x low", "x high", "y low", "y high"})
    scene.sublist("boundaries").set(end, "periodic");
  scene.sublist("time").set("end", 1.0);
  scene.sublist("bodies").sublist("all").set("material", material);
  scene.sublist("bodies").sublist("all").set("particles per cell", 2).set("initial state", "exact");
  return scene;
}

/// Waves of velocity in an unstrained solid, along x and y alike.
class Waves final : public ExactSolution {
 public:
  enum class Kind { shear, pressure };

  /// density [kg/m^3], pressure [Pa], speed of sound [m/s], amplitude over it, wavelength [m].
  Waves(Kind kind, double density, double pressure, double sound, double amplitude, double length)
      : kind_(kind), length_(length), sound_(sound), amplitude_(amplitude) {
    everywhere_.rho = density;
    everywhere_.p = pressure;
  }

  MatterState at(const Place& x, double) const override {
    MatterState s = everywhere_;
    const double k = 2 * pi / length_, a = k * x[0], b = k * x[1];
    const bool shear = kind_ == Kind::shear;
    const double u = shear ? std::sin(a) * std::cos(b) : std::sin(a);
    const double v = shear ? -std::cos(a) * std::sin(b) : std::sin(b);
    s.v[0] = sound_ * (drift_x + amplitude_ * u);
    s.v[1] = sound_ * (drift_y + amplitude_ * v);
    return s;
  }

  std::vector<Measure> features(double) const override { return {}; }
  std::vector<MeasureDoc> measure_docs() const override { return {}; }
  std::vector<Measure> measures(const ParticleTable&, double) const override { return {}; }

 private:
  Kind kind_;
  double length_, sound_, amplitude_;
  MatterState everywhere_;
};

/// Of longitudinal waves. [m/s]
double sound_of(double E, double nu, double rho) {
  return std::sqrt(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / rho);
}

List complete_solid(List scene, bool quadratic) {
  List& solids = scene.sublist("scheme").sublist("solids");
  solids.set("shape", quadratic ? "quadratic" : "linear");
  solids.set("transfer", quadratic ? "MLS" : "FLIP");
  scene.sublist("exact").set("solution", "uniform").set("gamma", 1.4);  // the start says more
  return complete_scene(scene);
}

}  // namespace

Box gas_box(const std::string& preset, bool quadratic, int cells) {
  List scene = empty_box(preset, cells, 1.0 / cells, "gas");
  if (quadratic) scene.sublist("scheme").set("shape", "quadratic");
  scene.sublist("materials").sublist("gas").set("law", "perfect gas").set("gamma", 1.4);
  List& vortex = scene.sublist("exact");
  vortex.set("solution", "vortex").set("gamma", 1.4).set("box length", 1.0).set("radius", 0.1);
  vortex.set("centre", Teuchos::Array<double>(std::vector<double>{0.5, 0.5}));
  const double sound = std::sqrt(1.4);  // of density and pressure 1
  vortex.set("velocity",
             Teuchos::Array<double>(std::vector<double>{drift_x * sound, drift_y * sound}));
  const List whole = complete_scene(scene);
  return {whole, make_exact(whole.sublist("exact")), gas_work(preset, quadratic)};
}

Box steel_box(bool quadratic, int cells) {
  constexpr double E = 200e9, nu = 0.29, rho = 7850;
  List scene = empty_box("balanced", cells, solid_cell, "steel");
  List& steel = scene.sublist("materials").sublist("steel");
  steel.set("law", "von mises").set("Young's modulus", E).set("Poisson's ratio", nu);
  steel.set("density", rho).set("yield stress", 250e6);
  // Plastic work takes a thousand steps to stop them.
  return {complete_solid(scene, quadratic),
          std::make_unique<Waves>(Waves::Kind::shear, rho, 0, sound_of(E, nu, rho), 0.2,
                                  50 * solid_cell),
          steel_work(quadratic)};
}

Box concrete_box(bool quadratic, int cells) {
  constexpr double E = 25e9, nu = 0.15, rho = 2320;
  List scene = empty_box("balanced", cells, solid_cell, "concrete");
  scene.sublist("materials").sublist("concrete").set("law", "concrete");
  return {complete_solid(scene, quadratic),
          std::make_unique<Waves>(Waves::Kind::pressure, rho, 36e6, sound_of(E, nu, rho), 2.7e-3,
                                  50 * solid_cell)};
}

}  // namespace brisance::perf
