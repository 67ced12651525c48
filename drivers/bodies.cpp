#include "drivers/bodies.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry.hpp"
#include "drivers/body_checks.hpp"
#include "drivers/budget.hpp"

namespace brisance {

Body::Body(const List& list, double same)
    : material(get<std::string>(list, "material")),
      per_cell(get<int>(list, "particles per cell")),
      by_points(get<std::string>(list, "edge") == "points"),
      exact(get<std::string>(list, "initial state") == "exact"),
      shape(list, same) {
  if (exact) return;
  const auto present = names(list);
  from_energy = std::find(present.begin(), present.end(), "specific energy") != present.end();
  density = get<double>(list, "density");
  state = get<double>(list, from_energy ? "specific energy" : "pressure");
  velocity = get<std::vector<double>>(list, "velocity");
}

Bodies::Bodies(const List& scene)
    : origin_(get<std::vector<double>>(scene.sublist("grid"), "origin")),
      h_(get<double>(scene.sublist("grid"), "cell size")) {
  const auto cells = get<std::vector<int>>(scene.sublist("grid"), "cells");
  double largest = 0;
  for (std::size_t d = 0; d < cells.size(); ++d)
    largest = std::max({largest, std::fabs(origin_[d]), std::fabs(origin_[d] + cells[d] * h_)});
  // Some thousand times the round-off of a coordinate.
  const double same = 1e-12 * largest;
  const List& lists = scene.sublist("bodies");
  for (const auto& name : list_names(lists)) bodies_.emplace_back(lists.sublist(name), same);
}

int Bodies::owner(const Place& x) const {
  Place centre{};
  for (std::size_t d = 0; d < origin_.size(); ++d)
    centre[d] = origin_[d] + (std::floor((x[d] - origin_[d]) / h_) + 0.5) * h_;
  return owner(x, centre);
}

namespace {

/// The particles that a cell may hold, n along each direction, over all cells: x fastest, then
/// along the directions within the cell.
template <int D>
class Sites {
 public:
  Sites(const Lattice<D>& lattice, int n) : lattice_(lattice), in_cell_(power(n, D)) {
    for (int d = 0; d < D; ++d) cells_ *= lattice.cells[d];
    for (int k = 0; k < in_cell_; ++k) {
      Place within{};
      for (int d = 0; d < D; ++d) within[d] = (k / power(n, d) % n + 0.5) / n;
      within_.push_back(within);
    }
  }

  long cells() const { return cells_; }
  int in_cell() const { return in_cell_; }

  /// Calls f(place in a cell, centre of the cell) for each site of a cell.
  template <class F>
  void each(long cell, const F& f) const {
    int i[D];
    Place centre{};
    for (int d = 0; d < D; ++d) {
      i[d] = static_cast<int>(cell % lattice_.cells[d]);
      cell /= lattice_.cells[d];
      centre[d] = lattice_.origin[d] + (i[d] + 0.5) * lattice_.h;
    }
    for (const Place& within : within_) {
      Place x{};
      for (int d = 0; d < D; ++d) x[d] = lattice_.origin[d] + (i[d] + within[d]) * lattice_.h;
      f(x, centre);
    }
  }

 private:
  Lattice<D> lattice_;
  int in_cell_;
  long cells_ = 1;
  std::vector<Place> within_;
};

template <class G>
class Seeder {
 public:
  static constexpr int D = G::dim;

  Seeder(State<G>& state_, const List& scene, const ExactSolution* exact_)
      : state(state_), bodies(scene), exact(exact_) {
    counts.assign(bodies.all().size(), 0);
    Overlaps overlaps(scene, bodies);
    for (const Body& body : bodies.all())
      if (owners.count(body.per_cell) == 0) ask(body.per_cell, overlaps);
    overlaps.check();
    const auto names = list_names(scene.sublist("bodies"));
    double all = 0;
    for (std::size_t b = 0; b < counts.size(); ++b) {
      const List& list = scene.sublist("bodies").sublist(names[b]);
      // What has no shape is the rest, of which there may be none.
      if (counts[b] == 0 && !list_names(list).empty()) refuse(list, "", why_empty(bodies.all()[b]));
      all += static_cast<double>(counts[b]);
    }
    if (all > 2e9) refuse(scene.sublist("bodies"), "", "must have fewer than 2e9 particles in all");
    check_particle_memory(scene, all, available_memory());
  }

  /// Room for all particles of the group, and the particles body by body.
  void fill(Group<G>& group, const ColumnNeeds& needs) {
    double sum = 0;
    for (std::size_t b = 0; b < counts.size(); ++b)
      if (bodies.all()[b].material == group.label) sum += static_cast<double>(counts[b]);
    group.allocate(static_cast<int>(sum), needs);
    for (std::size_t b = 0; b < counts.size(); ++b)
      if (bodies.all()[b].material == group.label && counts[b] > 0)
        seed(group, static_cast<int>(b));
  }

 private:
  State<G>& state;
  const Bodies bodies;
  const ExactSolution* exact;
  /// By particles along each direction of a cell: the body that owns each site and seeds with as
  /// many; -1: none. Asked once, because that is most of the work.
  std::map<int, std::vector<int>> owners;
  std::vector<long> counts;  ///< particles of each body

  std::string why_empty(const Body& body) const {
    const Sites<D> sites(state.grid.lattice, body.per_cell);
    bool held = false;
    for (long c = 0; c < sites.cells() && !held; ++c)
      sites.each(c, [&](const Place& x, const Place& centre) {
        held = held || body.shape.holds(body.by_points ? x : centre);
      });
    if (held) return "holds no particles: earlier bodies own all of its places";
    return std::string("holds no particles: no ") +
           (body.by_points ? "place for one" : "cell's centre") + " lies in it";
  }

  void ask(int per_cell, Overlaps& overlaps) {
    const Sites<D> sites(state.grid.lattice, per_cell);
    std::vector<int>& owner = owners[per_cell];
    owner.reserve(static_cast<std::size_t>(sites.cells()) * sites.in_cell());
    for (long c = 0; c < sites.cells(); ++c)
      sites.each(c, [&](const Place& x, const Place& centre) {
        int b = bodies.owner(x, centre);
        if (b >= 0 && bodies.all()[b].per_cell != per_cell) b = -1;
        if (b >= 0) {
          ++counts[b];
          overlaps.add(b, x);
        }
        owner.push_back(b);
      });
  }

  static auto host(const Table<double>& column) {
    return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), column);
  }

  /// All particles of one body, appended to its group.
  void seed(Group<G>& group, int number) {
    const Body& body = bodies.all()[number];
    Particles<G>& p = group.particles;
    const auto position = host(p.position), velocity = host(p.velocity), mass = host(p.mass),
               volume = host(p.volume), stress = host(p.stress);
    const auto extent = host(p.extent);
    const auto id = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), p.id);
    const int begin = p.count, per_cell = body.per_cell;
    const double v = state.grid.lattice.cell_volume() / power(per_cell, D),
                 h = state.grid.lattice.h;
    const Sites<D> sites(state.grid.lattice, per_cell);
    auto owner = owners.at(per_cell).begin();
    for (long c = 0; c < sites.cells(); ++c) {
      const auto after = owner + sites.in_cell();
      if (std::find(owner, after, number) == after) {
        owner = after;
        continue;
      }
      sites.each(c, [&](const Place& x, const Place&) {
        if (*owner++ != number) return;
        const int at = p.count++;
        for (int d = 0; d < D; ++d) position(at, d) = x[d];
        const MatterState s = body.exact ? exact->at(x, 0) : MatterState{};
        for (int d = 0; d < D; ++d) velocity(at, d) = body.exact ? s.v[d] : body.velocity[d];
        mass(at, 0) = v * (body.exact ? s.rho : body.density);
        volume(at, 0) = v;
        for (std::size_t d = 0; d < extent.extent(1); ++d) extent(at, d) = h / per_cell;
        stress(at, 0) = body.exact ? s.p : body.state;
        id(at) = state.next_id++;
      });
    }
    Kokkos::deep_copy(p.position, position);
    Kokkos::deep_copy(p.velocity, velocity);
    Kokkos::deep_copy(p.mass, mass);
    Kokkos::deep_copy(p.volume, volume);
    Kokkos::deep_copy(p.stress, stress);
    Kokkos::deep_copy(p.extent, extent);
    Kokkos::deep_copy(p.id, id);
    group.initialise(begin, body.from_energy);
  }
};

}  // namespace

template <class G>
void seed(State<G>& state, const List& scene, const ExactSolution* exact) {
  Seeder<G> seeder(state, scene, exact);
  const RelaxationRates& rates = state.scheme.rates;
  ColumnNeeds needs;
  needs.relaxation = rates.pressure > 0 || rates.volume > 0 || rates.heat > 0;
  needs.extent = state.scheme.split_length > 0;
  needs.compression = rates.heat > 0;
  for (auto& group : state.groups) seeder.fill(*group, needs);
}

template void seed<Line>(State<Line>&, const List&, const ExactSolution*);
template void seed<PlaneStrain>(State<PlaneStrain>&, const List&, const ExactSolution*);

}  // namespace brisance
