#include "test/state.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "drivers/input.hpp"
#include "drivers/presets.hpp"
#include "drivers/scene.hpp"
#include "materials/registry.hpp"

namespace brisance::test {
namespace {

template <class G>
std::unique_ptr<Group<G>> group_of(const RandomGas& of, int k) {
  const bool solid = of.solids && k % 2 == 1;
  List form, given;
  form.set("form", of.shock);
  const List valid = valid_shock_viscosity(preset("balanced", G::dim, false));
  if (solid)
    given = elastic_material();
  else
    given.set("law", "perfect gas").set("gamma", 1.4);
  if (of.newtonian && !solid) given.sublist("viscosity").set("shear", 0.05);
  auto group = make_group<G>(check(given, valid_material(given, valid)), check(form, valid));
  group->transfer = make_transfer<G>(solid ? of.solid_transfer : of.transfer);
  group->scheme.midpoint = of.midpoint;
  group->scheme.damping = of.damping;
  return group;
}

template <class G>
class Filler {
 public:
  explicit Filler(const RandomGas& of) : of_(of), random_(of.seed) {}

  void fill(State<G>& state, Group<G>& group, int k) {
    constexpr int D = G::dim;
    const Lattice<D>& lattice = state.grid.lattice;
    const int per_cell = of_.per_cell, all = power(of_.cells, D) * power(per_cell, D);
    ColumnNeeds needs;
    needs.relaxation = needs.compression = true;
    needs.passing_lasts = of_.passing_lasts;
    group.allocate(all / of_.groups + 1, needs);
    Particles<G>& p = group.particles;
    for (int n = k; n < all; n += of_.groups) {
      const int q = p.count++;
      const int cell = n / power(per_cell, D), part = n % power(per_cell, D);
      for (int d = 0; d < D; ++d) {
        const double place =
            of_.regular ? (part / power(per_cell, d) % per_cell + 0.5) / per_cell : within(0, 1);
        p.position(q, d) =
            lattice.origin[d] + (cell / power(of_.cells, d) % of_.cells + place) * lattice.h;
        p.velocity(q, d) = within(-of_.velocity_range, of_.velocity_range);
      }
      const double spread = of_.regular ? 0 : 0.3;
      p.vol(q) = lattice.cell_volume() / power(per_cell, D) * within(1 - spread, 1 + spread);
      p.m(q) = p.vol(q) * within(1 - spread, 1 + spread);
      p.stress(q, 0) = within(1 - of_.pressure_range, 1 + of_.pressure_range);
      for (std::size_t c = 0; c < p.affine.extent(1); ++c) p.affine(q, c) = within(-1, 1);
      for (std::size_t c = 0; c < p.extent.extent(1); ++c)
        p.extent(q, c) = lattice.h / per_cell * within(1 - spread, 1 + spread);
      p.id(q) = state.next_id++;
    }
    group.initialise(0, false);
  }

 private:
  const RandomGas& of_;
  std::mt19937 random_;

  double within(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
};

const char* const base = R"xml(
<ParameterList name="scene">
  <Parameter name="geometry" type="string" value="GEOMETRY"/>
  <ParameterList name="grid">
    <Parameter name="cells" type="Array(int)" value="{20Y1}"/>
    <Parameter name="cell size" type="double" value="0.1"/>
  </ParameterList>
  <ParameterList name="time"><Parameter name="end" type="double" value="0.1"/></ParameterList>
  <ParameterList name="materials"><ParameterList name="gas">
    <Parameter name="law" type="string" value="perfect gas"/>
    <Parameter name="gamma" type="double" value="1.4"/>
  </ParameterList></ParameterList>
  <ParameterList name="bodies">
    <ParameterList name="first">
      <Parameter name="material" type="string" value="gas"/>
      <Parameter name="density" type="double" value="1"/>
      <Parameter name="pressure" type="double" value="1"/>
      <ParameterList name="box">
        <Parameter name="low" type="Array(double)" value="{-1e9Y-1e9}"/>
        <Parameter name="high" type="Array(double)" value="{1Y1e9}"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="rest">
      <Parameter name="material" type="string" value="gas"/>
      <Parameter name="density" type="double" value="1"/>
      <Parameter name="pressure" type="double" value="1"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
)xml";

/// `Y` and what follows up to the end of the braces stays or goes with the second direction.
std::string base_text(int dim) {
  std::string text = base;
  text.replace(text.find("GEOMETRY"), 8, dim == 1 ? "line" : "plane strain");
  for (std::size_t at; (at = text.find('Y')) != text.npos;)
    dim == 1 ? text.erase(at, text.find('}', at) - at) : text.replace(at, 1, ", ");
  return text;
}

std::vector<std::size_t> order_of(const ParticleTable& t) {
  std::vector<std::size_t> order(t.size());
  std::iota(order.begin(), order.end(), 0);
  // Rows along y are told apart by a tenth of a cell, far more than round-off moves a particle.
  const auto row = [&](std::size_t k) {
    return t.y.empty() ? 0. : std::round(10 * t.y[k] / t.cell_size);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return row(a) != row(b) ? row(a) < row(b) : t.x[a] < t.x[b];
  });
  return order;
}

}  // namespace

template <class G>
State<G> random_gas(const RandomGas& of) {
  constexpr int D = G::dim;
  double origin[D];
  int cells[D];
  Boundaries<D> ends;
  for (int d = 0; d < D; ++d) {
    origin[d] = -1.25;
    cells[d] = of.cells;
    ends.side[d][0] = ends.side[d][1] = of.side;
  }
  ends.mirrors =
      of.transfer.shape != "linear" || (of.solids && of.solid_transfer.shape != "linear");
  GridNeeds needs;
  needs.classes = of.classes;
  needs.quadrature = of.transfer.quadrature == "cell";
  needs.limiter = of.shock != "none";
  StepScheme scheme;
  scheme.midpoint = of.midpoint;
  State<G> state(Grid<G>(Lattice<D>(origin, cells, 0.5), ends, needs), scheme);
  Filler<G> filler(of);
  for (int k = 0; k < of.groups; ++k) {
    state.groups.push_back(group_of<G>(of, k));
    state.groups.back()->velocity_class = k % of.classes;
    filler.fill(state, *state.groups.back(), k);
  }
  prepare(state);
  return state;
}

template <class G>
double step(State<G>& state) {
  Exchange<G> alone;
  const double dt = state.grid.lattice.h / begin_step(state, alone) / 3;
  finish_step(state, alone, dt);
  return dt;
}

template <class G>
Totals totals(const State<G>& state) {
  Totals sum;
  for (const auto& g : state.groups)
    sum += g->totals(0, g->particles.count, g->transfer->affine_inertia(state.grid.lattice.h));
  for (int d = 0; d < G::dim; ++d) sum.momentum[d] += state.wall_impulse[d];
  return sum;
}

template <class G>
double volume(const State<G>& state) {
  double sum = 0;
  for (const auto& g : state.groups)
    for (int p = 0; p < g->particles.count; ++p) sum += g->particles.vol(p);
  return sum;
}

#define BRISANCE_TEST_STATE(G)                       \
  template State<G> random_gas<G>(const RandomGas&); \
  template double step<G>(State<G>&);                \
  template Totals totals<G>(const State<G>&);        \
  template double volume<G>(const State<G>&);
BRISANCE_TEST_STATE(Line)
BRISANCE_TEST_STATE(PlaneStrain)
#undef BRISANCE_TEST_STATE

std::vector<TransferChoice> every_transfer() {
  return {{"linear", "FLIP", "cell"},    {"linear", "FLIP", "particle"},
          {"GIMP", "FLIP", "particle"},  {"quadratic", "FLIP", "particle"},
          {"cubic", "FLIP", "particle"}, {"quadratic", "APIC", "particle"},
          {"cubic", "APIC", "particle"}, {"quadratic", "MLS", "particle"},
          {"cubic", "MLS", "particle"}};
}

std::string name_of(const TransferChoice& c) {
  return c.shape + " " + c.scheme + " by " + c.quadrature;
}

List scene(int dim, const std::vector<std::string>& assignments) {
  Document document = parse_input(base_text(dim), "base.xml");
  for (const auto& a : assignments) apply_override(document, a, valid_scene(*document.list));
  return complete_scene(*document.list);
}

List elastic_material() {
  List list;
  list.set("law", "elastic").set("Young's modulus", 3.).set("Poisson's ratio", 0.3);
  return list.set("density", 1.);
}

std::unique_ptr<Simulation> simulated(const List& scene, const ExactSolution* exact) {
  auto simulation = make_simulation(scene, exact);
  const double end = get<double>(scene.sublist("time"), "end");
  while (simulation->time() < end) simulation->advance(end);
  return simulation;
}

double distance(const ParticleTable& a, const ParticleTable& b) {
  if (a.size() != b.size()) return 1e300;
  const auto of_a = order_of(a), of_b = order_of(b);
  double largest = 0;
  for (const auto column : {&ParticleTable::x, &ParticleTable::y, &ParticleTable::vx,
                            &ParticleTable::vy, &ParticleTable::mass, &ParticleTable::volume,
                            &ParticleTable::pressure, &ParticleTable::energy}) {
    const bool velocity = column == &ParticleTable::vx || column == &ParticleTable::vy;
    double scale = velocity ? 1 : 1e-300, apart = 0;
    for (std::size_t k = 0; k < (a.*column).size(); ++k) {  // none beyond the dimension
      const double value = (a.*column)[of_a[k]];
      scale = std::max(scale, std::fabs(value));
      apart = std::max(apart, std::fabs(value - (b.*column)[of_b[k]]));
    }
    largest = std::max(largest, apart / scale);
  }
  return largest;
}

ParticleTable mirrored(ParticleTable t, int direction, double middle) {
  for (double& x : direction == 0 ? t.x : t.y) x = 2 * middle - x;
  for (double& v : direction == 0 ? t.vx : t.vy) v = -v;
  return t;
}

ParticleTable transposed(ParticleTable t) {
  std::swap(t.x, t.y);
  std::swap(t.vx, t.vy);
  return t;
}

}  // namespace brisance::test
