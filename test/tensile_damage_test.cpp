#include "materials/tensile_damage.hpp"

#include "point.hpp"

namespace brisance {
namespace {

TensileDamage concrete(double m = 6) { return {25e9, 0.15, 2320, 1e6, 5e26, m}; }

/// The volumetric strain at which a crack density is reached at a rate of volume.
double volume_at(const TensileDamage& law, double Cd, double rate) {
  return 3 * std::pow(Cd * rate * rate / law.growth, 1 / law.m);
}

/// The largest value of f(Cd), by golden sections, and where it is.
template <class F>
double peak(const F& f, double& Cd) {
  double a = 1e-6, b = 0.5;
  const double ratio = (std::sqrt(5) - 1) / 2;
  for (int k = 0; k < 100; ++k) {
    const double c = b - ratio * (b - a), d = a + ratio * (b - a);
    (f(c) > f(d) ? b : a) = f(c) > f(d) ? d : c;
  }
  Cd = 0.5 * (a + b);
  return f(Cd);
}

double onset(const TensileDamage& law, double r) {
  double low = 1e-9, high = 0.56;
  for (int k = 0; k < 100; ++k) {
    const double mid = 0.5 * (low + high);
    (law.localisation(law.at(mid), mid, r) > 0 ? low : high) = mid;
  }
  return high;
}

TEST(TensileDamage, GrowsFromTheFlawsThatTheStrainOpens) {
  const TensileDamage law = concrete();
  EXPECT_NEAR(law.growth, 2.155172e25, 5e18);  // as printed
  // N = k eps_v^m cracks of radius (sqrt(20) K_IC / (rho C rate))^(2/3) / 2
  const double C = std::sqrt(25e9 / 2320), rate = 100,
               radius = 0.5 * std::pow(std::sqrt(20) * 1e6 / (2320 * C * rate), 2. / 3);
  const double cubes = 5e26 * std::pow(1e-4, 6) * std::pow(radius, 3);
  EXPECT_NEAR(law.crack_density(1e-4, rate) / cubes, 1, 1e-14);
}

// Cd, D, nu, K/K0, G/G0 as printed to five digits.
TEST(TensileDamage, TakesTheModuliDownTogether) {
  const double printed[][5] = {{0.01, 0.02466, 0.14733, 0.97534, 0.98506},
                               {0.1, 0.23240, 0.12333, 0.76760, 0.84570},
                               {0.3, 0.61712, 0.07000, 0.38288, 0.50557},
                               {0.5, 0.91928, 0.01667, 0.08072, 0.12608}};
  const TensileDamage law = concrete();
  for (const auto& p : printed) {
    const TensileDamage::State s = law.at(p[0]);
    const Isotropic m = s.moduli;
    EXPECT_NEAR(s.D, p[1], 5e-6);
    EXPECT_NEAR((3 * m.K - 2 * m.G) / (6 * m.K + 2 * m.G), p[2], 5e-6);
    EXPECT_NEAR(m.K / law.intact.K, p[3], 5e-6);
    EXPECT_NEAR(m.G / law.intact.G, p[4], 5e-6);
    const double step = 1e-6;
    const Isotropic a = law.at(p[0] - step).moduli, b = law.at(p[0] + step).moduli;
    EXPECT_NEAR((b.K - a.K) / (2 * step) / s.dK, 1, 1e-9);  // round-off 1e-16 / step, and step^2
    EXPECT_NEAR((b.G - a.G) / (2 * step) / s.dG, 1, 1e-9);
  }
  EXPECT_EQ(law.at(0.).moduli.K, law.intact.K);
  EXPECT_NEAR(law.at(0.).moduli.G, law.intact.G, 1e-15 * law.intact.G);
  for (const double all : {9. / 16, 0.7, 1e9}) {
    EXPECT_EQ(law.at(all).D, 1);
    EXPECT_EQ(law.at(all).moduli.K, 0);
  }
}

TEST(TensileDamage, NeverStiffensWithinTheRangeOfPoissonsRatio) {
  for (const double nu : {0., 0.15, 0.35}) {
    const TensileDamage law(25e9, nu, 2320, 1e6, 5e26, 6);
    Isotropic before = law.intact;
    for (double Cd = 1e-4; Cd < 0.57; Cd += 1e-4) {
      const Isotropic now = law.at(Cd).moduli;
      ASSERT_LE(now.K, before.K);
      ASSERT_LE(now.G, before.G * (1 + 1e-15));
      before = now;
    }
  }
}

// Peaks over the crack density, printed to six digits; they scale with the rate to the power 2/m.
TEST(TensileDamage, HasAStrengthThatGrowsWithTheCubeRootOfTheRate) {
  const TensileDamage law = concrete();
  for (const double rate : {1e-3, 1e-2, 0.1, 1., 10., 100., 1e3}) {
    const double root = std::cbrt(rate);
    double at = 0;
    const auto hydrostatic = [&](double Cd) {
      return law.at(Cd).moduli.K * volume_at(law, Cd, rate);
    };
    EXPECT_NEAR(peak(hydrostatic, at) / root, 1.14797e6, 5);
    EXPECT_NEAR(law.at(at).D, 0.14802, 5e-6);

    const auto uniaxial_strain = [&](double Cd) {
      return law.at(Cd).moduli.constrained() * volume_at(law, Cd, rate);
    };
    EXPECT_NEAR(peak(uniaxial_strain, at) / root, 2.64243e6, 5);
    EXPECT_NEAR(law.at(at).D, 0.17947, 5e-6);

    // A bar: sigma = 3 K tr(strain), at a rate of volume of (1 - 2 nu) times the axial one.
    const auto bar = [&](double Cd) {
      return 3 * law.at(Cd).moduli.K * volume_at(law, Cd, 0.7 * rate);
    };
    EXPECT_NEAR(peak(bar, at) / root, 3.05786e6, 30);
    EXPECT_NEAR(law.at(at).D, 0.14802, 5e-6);
    double same = 0;
    const auto slow_bar = [&](double Cd) {
      return 3 * law.at(Cd).moduli.K * volume_at(law, Cd, 0.7);
    };
    EXPECT_NEAR(peak(bar, at) / (root * peak(slow_bar, same)), 1, 1e-14);
  }
}

// r = strain along n over that of volume; Cd to six digits, D to six, sigma_1 in MPa at rate 1 /s.
TEST(TensileDamage, LocalisesAtADamageThatDependsOnTheDirectionsOnly) {
  const double printed[][4] = {{1. / 3, 0.132869, 0.302403, 1.06685},
                               {0.5, 0.110874, 0.255885, 1.47824},
                               {1, 0.076039, 0.179469, 2.64243},
                               {1.4286, 0.060536, 0.144330, 3.58384},
                               {3, 0.035149, 0.085220, 6.77138}};
  const TensileDamage law = concrete();
  for (const auto& p : printed) {
    const double Cd = onset(law, p[0]), volume = volume_at(law, Cd, 1);
    const TensileDamage::State s = law.at(Cd);
    EXPECT_NEAR(Cd, p[1], 5e-7);
    EXPECT_NEAR(s.D, p[2], 5e-7);
    const double sigma = s.moduli.K * volume + 2 * s.moduli.G * volume * (p[0] - 1. / 3);
    EXPECT_NEAR(sigma, p[3] * 1e6, 5);
  }
}

double det_q(const TensileDamage::State& s, const Sym3& softening, double angle) {
  const double n[2] = {std::cos(angle), std::sin(angle)}, G = s.moduli.G, rest = s.moduli.K + G / 3;
  double Q[2][2];
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      Q[i][j] = (i == j ? G : 0) + rest * n[i] * n[j] +
                (softening[Sym3::at(i, 0)] * n[0] + softening[Sym3::at(i, 1)] * n[1]) * n[j];
  return Q[0][0] * Q[1][1] - Q[0][1] * Q[1][0];
}

// Sweeps of the acoustic tensor of the tangent in steps of 0.1 degree, with the strain turned in
// the plane: its determinant first vanishes at the crack density of the closed form and across the
// major principal strain.
TEST(TensileDamage, LocalisesAcrossTheMajorPrincipalStrain) {
  const TensileDamage law = concrete();
  const double degree = std::acos(-1.0) / 180, rate = 500;
  for (const double ratio : {-0.3, 0., 0.4, 0.9})
    for (const double axis : {0., 17.3, 90., 133.7}) {
      const double r = 1 / (1 + ratio);
      for (const double early : {1., 0.99}) {
        const double Cd = early * onset(law, r), major = r * volume_at(law, Cd, rate);
        const Sym3 strain = turned(tensor(major, ratio * major, 0, 0), axis * degree);
        const TensileDamage::State s = law.at(Cd);
        const Sym3 softening = law.softening(s, Cd, strain);
        const double scale = s.moduli.G * s.moduli.constrained();
        double least = 1e99, where = 0;
        for (int k = 0; k < 1800; ++k) {
          const double det = det_q(s, softening, 0.1 * k * degree);
          if (det < least) {
            least = det;
            where = 0.1 * k;
          }
        }
        EXPECT_NEAR(where, std::fmod(axis, 180), 0.1001);
        // Next to the minimum: half its curvature, less than 2 scale, times a tenth of a degree
        // squared.
        if (early < 1) {
          EXPECT_GT(least, 0);
        } else {
          EXPECT_NEAR(det_q(s, softening, axis * degree) / scale, 0, 1e-13);
          EXPECT_GT(least / scale, -1e-13);
          EXPECT_LT(least / scale, square(0.1 * degree));
        }
        EXPECT_NEAR(det_q(s, softening, axis * degree) / scale,
                    law.localisation(s, Cd, r) / s.moduli.constrained(), 1e-13);
        const Vec<2> n = major_direction(strain);
        EXPECT_NEAR(std::fabs(n[0] * std::cos(axis * degree) + n[1] * std::sin(axis * degree)), 1,
                    1e-14);
      }
    }
}

// Central differences over 1e-9 of strains of 1e-3: truncation (1e-6)^2 times m^3, round-off 1e-16
// over 1e-6.
TEST(TensileDamage, HasATangentThatIsNotSymmetric) {
  const TensileDamage law = concrete();
  const Sym3 strain = tensor(8e-4, 1.5e-4, 0, 1e-4);
  const double rate = 500, step = 1e-9;
  const auto stress = [&](const Sym3& e) {
    return law.at(law.crack_density(trace(e) / 3, rate)).moduli.stress(e);
  };
  const double Cd = law.crack_density(trace(strain) / 3, rate);
  const TensileDamage::State s = law.at(Cd);
  EXPECT_NEAR(s.D, 0.2037, 5e-5);
  const Sym3 softening = law.softening(s, Cd, strain);
  double asymmetry = 0;
  for (int k = 0; k < 6; ++k) {
    Sym3 unit;
    unit[k] = 1;
    const Sym3 a = stress(added(strain, -step, unit)), b = stress(added(strain, step, unit)),
               tangent = added(s.moduli.stress(unit), trace(unit), softening);
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR((b[i] - a[i]) / (2 * step) / law.intact.K, tangent[i] / law.intact.K, 1e-9);
    }
    if (k == 0) asymmetry = tangent[1];
    if (k == 1) asymmetry -= tangent[0];
  }
  EXPECT_GT(std::fabs(asymmetry), 0.1 * law.intact.K);
}

}  // namespace
}  // namespace brisance
