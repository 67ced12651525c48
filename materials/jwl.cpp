#include "materials/jwl.hpp"

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "core/parameters.hpp"

namespace brisance {

Jwl::Jwl(const List& list)
    : A(get<double>(list, "A")),
      B(get<double>(list, "B")),
      R1(get<double>(list, "R1")),
      R2(get<double>(list, "R2")),
      omega(get<double>(list, "omega")),
      rho0(get<double>(list, "density")),
      energy0(get<double>(list, "energy density") / rho0) {
  const ChapmanJouguet cj = chapman_jouguet(*this);
  slope_of_shocks = 0.25 * (cj.gamma + 1);
  burn.at_once = get<std::string>(list, "burn") == "at once";
  burn.speed = get<double>(list, "detonation speed");
  burn.width = get<double>(list, "burn width");
  if (get<bool>(list, "volume burn")) burn.cj_volume = cj.V;
}

List Jwl::valid_parameters() {
  List valid;
  declare_required<double>(valid, "density", positive(), "of the solid explosive [kg/m^3]");
  declare_required<double>(valid, "A", between(0, 1e15), "coefficient [Pa]");
  declare_required<double>(valid, "B", between(0, 1e15), "coefficient [Pa]");
  declare_required<double>(valid, "R1", above(0) && at_most(100), "exponent [-]");
  declare_required<double>(valid, "R2", above(0) && at_most(100), "exponent [-]");
  declare_required<double>(valid, "omega", above(0) && at_most(10),
                           "Grueneisen coefficient [-]");
  declare_required<double>(valid, "energy density", above(0) && at_most(1e15),
                           "internal energy of the solid explosive per volume [J/m^3]");
  declare_required<double>(valid, "detonation speed", above(0) && at_most(1e6),
                           "at which the explosive is lit from its ignition [m/s]");
  declare(valid, "burn", "program", one_of({"program", "at once"}),
          "program: each point from its lighting time on; at once: products from the start [-]");
  declare(valid, "burn width", 2.5, between(0.1, 100),
          "over which the explosive burns [spacings of its particles]");
  declare(valid, "volume burn", false, anything(),
          "whether compression burns, too, all of it at the Chapman-Jouguet volume [-]");
  return valid;
}

ChapmanJouguet chapman_jouguet(const Jwl& products) {
  // On the Hugoniot of the solid, e = e0 + p (1 - V) / (2 rho0); its slowest wave is the steady
  // one.
  const double rho0 = products.rho0;
  const auto pressure = [&](double V) {
    const double rho = rho0 / V, share = products.slope(rho);
    return (products.offset(rho) + share * products.energy0) / (1 - share * (1 - V) / (2 * rho0));
  };
  const auto speed2 = [&](double V) { return pressure(V) / (rho0 * (1 - V)); };
  double low = 0.4, high = 0.98;
  for (int k = 0; k < 200; ++k) {
    const double third = (high - low) / 3;
    if (speed2(low + third) < speed2(high - third))
      high -= third;
    else
      low += third;
  }
  ChapmanJouguet cj;
  cj.V = 0.5 * (low + high);
  cj.p = pressure(cj.V);
  cj.D = sqrt(speed2(cj.V));
  cj.u = cj.D * (1 - cj.V);
  cj.rho = rho0 / cj.V;
  cj.e = products.energy0 + 0.5 * cj.p * (1 - cj.V) / rho0;
  cj.gamma = cj.rho * products.sound_speed2(cj.rho, cj.e) / cj.p;
  return cj;
}

}  // namespace brisance
