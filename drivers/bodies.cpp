#include "drivers/bodies.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>

#include "core/geometry.hpp"

namespace brisance {
namespace {

/// A body as numbers.
struct Body {
  enum class Shape { everything, box, disc } shape = Shape::everything;
  std::vector<double> low, high, centre;
  double radius = 0;

  std::string material;
  int per_cell = 1;        ///< particles along each direction of a cell
  bool by_points = false;  ///< owns single points, else whole cells by their centres
  bool exact = false, from_energy = false;
  double density = 0, state = 0;  ///< state: pressure [Pa] or specific energy [J/kg]
  std::vector<double> velocity;

  explicit Body(const List& list)
      : material(get<std::string>(list, "material")),
        per_cell(get<int>(list, "particles per cell")),
        by_points(get<std::string>(list, "edge") == "points"),
        exact(get<std::string>(list, "initial state") == "exact") {
    if (const List* box = find_list(list, "box")) {
      shape = Shape::box;
      low = get<std::vector<double>>(*box, "low");
      high = get<std::vector<double>>(*box, "high");
    } else if (const List* disc = find_list(list, "disc")) {
      shape = Shape::disc;
      centre = get<std::vector<double>>(*disc, "centre");
      radius = get<double>(*disc, "radius");
    }
    if (exact) return;
    const auto present = names(list);
    from_energy = std::find(present.begin(), present.end(), "specific energy") != present.end();
    density = get<double>(list, "density");
    state = get<double>(list, from_energy ? "specific energy" : "pressure");
    velocity = get<std::vector<double>>(list, "velocity");
  }

  template <int D>
  bool holds(const Vec<D>& x) const {
    double r2 = 0;
    for (int d = 0; d < D; ++d) {
      if (shape == Shape::box && (x[d] < low[d] || x[d] >= high[d])) return false;
      if (shape == Shape::disc) r2 += square(x[d] - centre[d]);
    }
    return shape != Shape::disc || r2 < square(radius);
  }
};

template <int D>
Vec<D> centre_of(const Lattice<D>& lattice, const int (&cell)[D]) {
  Vec<D> x;
  for (int d = 0; d < D; ++d) x[d] = lattice.origin[d] + (cell[d] + 0.5) * lattice.h;
  return x;
}

/// Calls f(integer coordinates) for each cell, x fastest.
template <int D, class F>
void for_cells(const Lattice<D>& lattice, const F& f) {
  long count = 1;
  for (int d = 0; d < D; ++d) count *= lattice.cells[d];
  for (long c = 0; c < count; ++c) {
    int cell[D];
    long rest = c;
    for (int d = 0; d < D; ++d) {
      cell[d] = static_cast<int>(rest % lattice.cells[d]);
      rest /= lattice.cells[d];
    }
    f(cell);
  }
}

template <class G>
class Seeder {
 public:
  static constexpr int D = G::dim;

  Seeder(State<G>& state_, const std::vector<Body>& bodies_, const ExactSolution* exact_)
      : state(state_), bodies(bodies_), exact(exact_) {}

  /// All particles of one body, appended to its group.
  void seed(Group<G>& group, const Body& body) {
    Particles<G>& p = group.particles;
    const auto position = host(p.position), velocity = host(p.velocity), mass = host(p.mass),
               volume = host(p.volume), stress = host(p.stress);
    const auto extent = host(p.extent);
    const auto id = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), p.id);
    const int begin = p.count, per_cell = body.per_cell;
    const double v = state.grid.lattice.cell_volume() / power(per_cell, D),
                 h = state.grid.lattice.h;
    for_places(body, [&](const Vec<D>& place) {
      const int at = p.count++;
      Place x{};
      for (int d = 0; d < D; ++d) x[d] = position(at, d) = place[d];
      const MatterState s = body.exact ? exact->at(x, 0) : MatterState{};
      for (int d = 0; d < D; ++d) velocity(at, d) = body.exact ? s.v[d] : body.velocity[d];
      mass(at, 0) = v * (body.exact ? s.rho : body.density);
      volume(at, 0) = v;
      for (std::size_t d = 0; d < extent.extent(1); ++d) extent(at, d) = h / per_cell;
      stress(at, 0) = body.exact ? s.p : body.state;
      id(at) = state.next_id++;
    });
    Kokkos::deep_copy(p.position, position);
    Kokkos::deep_copy(p.velocity, velocity);
    Kokkos::deep_copy(p.mass, mass);
    Kokkos::deep_copy(p.volume, volume);
    Kokkos::deep_copy(p.stress, stress);
    Kokkos::deep_copy(p.extent, extent);
    Kokkos::deep_copy(p.id, id);
    group.initialise(begin, body.from_energy);
  }

  /// Particles of the material with that name.
  int count(const std::string& material) const {
    double sum = 0;
    for (const Body& body : bodies)
      if (body.material == material) for_places(body, [&](const Vec<D>&) { ++sum; });
    if (sum > 2e9)
      throw std::runtime_error("the scene has more than 2e9 particles of '" + material + "'");
    return static_cast<int>(sum);
  }

 private:
  State<G>& state;
  const std::vector<Body>& bodies;
  const ExactSolution* exact;

  static auto host(const Table<double>& column) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), column);
  }

  /// Calls f(place) for each particle of a body.
  template <class F>
  void for_places(const Body& body, const F& f) const {
    const Lattice<D>& lattice = state.grid.lattice;
    const int n = body.per_cell;
    for_cells(lattice, [&](const int(&cell)[D]) {
      const Vec<D> centre = centre_of(lattice, cell);
      for (int k = 0; k < power(n, D); ++k) {
        Vec<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = lattice.origin[d] + (cell[d] + (k / power(n, d) % n + 0.5) / n) * lattice.h;
        if (owner(centre, x) == &body) f(x);
      }
    });
  }

  /// The first body that holds a point x in the cell with that centre.
  const Body* owner(const Vec<D>& centre, const Vec<D>& x) const {
    for (const Body& body : bodies)
      if (body.holds(body.by_points ? x : centre)) return &body;
    return nullptr;
  }
};

}  // namespace

template <class G>
void seed(State<G>& state, const List& scene, const ExactSolution* exact) {
  const List& lists = scene.sublist("bodies");
  std::vector<Body> bodies;
  for (const auto& name : list_names(lists)) bodies.emplace_back(lists.sublist(name));
  Seeder<G> seeder(state, bodies, exact);
  const RelaxationRates& rates = state.scheme.rates;
  ColumnNeeds needs;
  needs.relaxation = rates.pressure > 0 || rates.volume > 0 || rates.heat > 0;
  needs.extent = state.scheme.split_length > 0;
  for (auto& group : state.groups) {
    group->allocate(seeder.count(group->label), needs);
    for (const Body& body : bodies)
      if (body.material == group->label) seeder.seed(*group, body);
  }
  if (state.particles() == 0)
    refuse(lists, "", "hold no particles: no cell's centre lies in a body");
}

template void seed<Line>(State<Line>&, const List&, const ExactSolution*);
template void seed<PlaneStrain>(State<PlaneStrain>&, const List&, const ExactSolution*);

}  // namespace brisance
