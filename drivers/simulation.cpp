#include "drivers/simulation.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry.hpp"
#include "core/step.hpp"
#include "drivers/archive_state.hpp"
#include "drivers/bodies.hpp"
#include "drivers/budget.hpp"
#include "drivers/ignition.hpp"
#include "drivers/probe.hpp"
#include "drivers/sleep.hpp"
#include "drivers/springs.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

Side side_of(const std::string& name) {
  static const std::map<std::string, Side> sides = {{"wall", Side::wall},
                                                    {"fixed", Side::fixed},
                                                    {"free", Side::free},
                                                    {"periodic", Side::periodic}};
  return sides.at(name);
}

template <class G>
class SimulationIn final : public Simulation {
 public:
  static constexpr int D = G::dim;

  SimulationIn(const List& scene, const ExactSolution* exact)
      : state_(make_grid(scene), make_scheme(scene)) {
    const List& scheme = scene.sublist("scheme");
    const List& time = scene.sublist("time");
    cfl_ = get<double>(time, "CFL");
    growth_ = get<double>(time, "largest growth");

    const List& materials = scene.sublist("materials");
    for (const auto& name : list_names(materials)) {
      auto group = make_group<G>(materials.sublist(name), scheme.sublist("artificial viscosity"));
      const List& of_group = group->fluid() ? scheme : scheme.sublist("solids");
      group->label = name;
      group->velocity_class = state_.grid.mixed() && !group->fluid() ? solid_class : fluid_class;
      group->transfer = make_transfer<G>(transfer_choice(of_group, group->fluid()));
      group->scheme.midpoint = state_.scheme.midpoint;
      group->scheme.damping = get<double>(of_group, "damping");
      if (!group->fluid())
        group->scheme.stress_relaxation = get<double>(of_group, "stress relaxation");
      group->scheme.printed_work = get<std::string>(scheme, "MUSL work") == "printed";
      group->scheme.strain_length =
          cfl_ * state_.grid.lattice.h / get<double>(time, "largest volume change");
      if (group->fluid() && state_.scheme.midpoint) {
        if (state_.debt.extent(0) == 0)
          state_.debt = Array<double>("energy owed", state_.grid.lattice.size);
        group->debt = state_.debt;
      }
      state_.groups.push_back(std::move(group));
    }
    add_springs(state_, scene);
    seed(state_, scene, exact);
    set_lighting_times(state_, scene);
    prepare(state_);
    put_to_sleep(state_, scene);
    fastest_ = begin_step(state_, others_);
    dt_ = stable_step();
    const Balance start = balance();
    check_start(scene, dt_, fastest_, start.totals.mass, start.totals.total());
  }

  double time() const override { return state_.time; }
  double dt() const override { return dt_; }
  long step_count() const override { return state_.step; }
  long particle_count() const override { return state_.particles(); }
  std::optional<Sleeping> sleeping() const override {
    if (!state_.sleep.on()) return {};
    return Sleeping{state_.sleep.count(),
                    std::sqrt(dot(state_.sleep.impulse(), state_.sleep.impulse()))};
  }

  void advance(double end) override {
    if (state_.step > 0) fastest_ = begin_step(state_, others_);
    dt_ = std::min(stable_step(), growth_ * dt_);
    if (!(fastest_ < 1e299))
      throw std::runtime_error("step " + std::to_string(state_.step) + ", time " +
                               std::to_string(state_.time) +
                               " s: the state is no longer finite; try a smaller 'time/CFL'");
    const double left = end - state_.time;
    const bool last = dt_ >= left * (1 - 1e-12);
    taken_ = last ? left : dt_;
    finish_step(state_, others_, taken_);
    if (last) state_.time = end;
  }

  Balance balance() const override {
    Balance b;
    b.step = state_.step;
    b.time = state_.time;
    b.dt = dt();
    b.particles = state_.particles();
    b.outflow = state_.outflow;
    b.left = state_.left;
    if (!state_.springs.empty()) b.springs = state_.springs.energy();
    for (int d = 0; d < D; ++d) b.wall_impulse[d] = state_.wall_impulse[d];
    for (const auto& g : state_.groups) {
      Totals of_group;
      long count = 0;
      state_.sleep.for_all(*g, [&] {
        count += g->particles.count;
        of_group +=
            g->totals(0, g->particles.count, g->transfer->affine_inertia(state_.grid.lattice.h));
      });
      b.totals += of_group;
      b.materials.push_back({g->label, !g->fluid(), count, of_group});
      b.floors += g->floors();
    }
    b.totals.internal -= owed();
    return b;
  }

  Snapshot snapshot(Snapshot earlier) const override {
    return snapshot_of(state_, std::move(earlier));
  }

  Footprint footprint() const override {
    Footprint f;
    std::map<std::string, double> bytes;
    for (const auto& g : state_.groups) {
      Particles<G> p = g->particles;
      const long count = p.count + state_.sleep.count(*g);
      f.particles += static_cast<double>(count);
      p.each_column([&](const char* name, const Table<double>& c, bool) {
        bytes[name] += static_cast<double>(count * c.extent(1) * sizeof(double));
      });
      bytes["id"] += static_cast<double>(count * sizeof(std::int64_t));
      bytes["bin"] += static_cast<double>(count * sizeof(int));
    }
    for (const auto& [name, sum] : bytes) f.columns.push_back({name, sum / f.particles});
    f.cells = 1;
    for (int d = 0; d < D; ++d) f.cells *= state_.grid.lattice.cells[d];
    f.grid_bytes =
        static_cast<double>(state_.grid.bytes() + state_.sums.bytes() + state_.spare.bytes() +
                            state_.means.bytes() + state_.sleep.bytes());
    f.sort_bytes = static_cast<double>(state_.sorter.bytes() + state_.wavefront.bytes());
    return f;
  }

  void keep(Archive& archive) override {
    const Archive::Part part(archive, "state");
    brisance::keep(archive, state_);
    archive.keep("dt", dt_);  // limits the growth of the next; the fastest signal is found anew
  }

  std::vector<Seen> probe(const std::vector<Window>& windows) const override {
    return brisance::probe(state_, windows);
  }
  void carry(std::vector<Window>& windows) override { riders_.carry(state_, taken_, windows); }

 private:
  State<G> state_;
  Exchange<G> others_;
  Riders<G> riders_;
  double taken_ = 0;    ///< the last step, which may be shorter than dt_ [s]
  double fastest_ = 0;  ///< signal over the grid [m/s]
  double cfl_ = 0, growth_ = 0, dt_ = 0;

  double owed() const {
    double sum = 0;
    const auto debt = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), state_.debt);
    for (std::size_t n = 0; n < debt.extent(0); ++n) sum += debt(n);
    return sum;
  }

  double stable_step() const { return cfl_ * state_.grid.lattice.h / std::max(fastest_, 1e-300); }

  static TransferChoice transfer_choice(const List& scheme, bool fluid) {
    return {get<std::string>(scheme, "shape"), get<std::string>(scheme, "transfer"),
            fluid ? get<std::string>(scheme, "quadrature") : "particle"};
  }

  static Grid<G> make_grid(const List& scene) {
    const List& grid = scene.sublist("grid");
    const List& scheme = scene.sublist("scheme");
    const auto origin = get<std::vector<double>>(grid, "origin");
    const auto cells = get<std::vector<int>>(grid, "cells");
    double low[D];
    int count[D];
    Boundaries<D> ends;
    const char* axes[] = {"x", "y", "z"};
    for (int d = 0; d < D; ++d) {
      low[d] = origin[d];
      count[d] = cells[d];
      ends.side[d][0] =
          side_of(get<std::string>(scene.sublist("boundaries"), std::string(axes[d]) + " low"));
      ends.side[d][1] =
          side_of(get<std::string>(scene.sublist("boundaries"), std::string(axes[d]) + " high"));
    }
    bool fluids = false, solids = false, limited = false;
    const List& materials = scene.sublist("materials");
    for (const auto& name : list_names(materials)) {
      const List& material = materials.sublist(name);
      const bool fluid = is_fluid(get<std::string>(material, "law"));
      (fluid ? fluids : solids) = true;
      if (!fluid) continue;
      const List* own = find_list(material, "artificial viscosity");
      const List& q = own ? *own : scheme.sublist("artificial viscosity");
      limited = limited || (get<std::string>(q, "form") != "none" && get<double>(q, "limiter") > 0);
    }
    const auto linear = [](const List& of) { return get<std::string>(of, "shape") == "linear"; };
    ends.mirrors = (fluids && !linear(scheme)) || (solids && !linear(scheme.sublist("solids")));
    GridNeeds needs;
    needs.classes = fluids && solids ? 2 : 1;
    needs.quadrature = fluids && get<std::string>(scheme, "quadrature") == "cell";
    needs.limiter = limited;
    return Grid<G>(Lattice<D>(low, count, get<double>(grid, "cell size")), ends, needs);
  }

  static StepScheme make_scheme(const List& scene) {
    const List& scheme = scene.sublist("scheme");
    StepScheme s;
    s.midpoint = get<std::string>(scheme, "integration") == "midpoint";
    s.split_length = get<double>(scheme, "split length");
    s.rates = {get<double>(scheme, "volume relaxation"), get<double>(scheme, "pressure relaxation"),
               get<double>(scheme, "heat conduction")};
    s.summation = get<std::string>(scheme, "summation") == "colours" ? Summation::colours
                                                                     : Summation::duplicates;
    s.relaxation_interval = get<int>(scheme, "relaxation interval");
    if (const List* solids = find_list(scheme, "solids"))
      s.relaxes_stress = get<double>(*solids, "stress relaxation") > 0;
    return s;
  }
};

}  // namespace

std::unique_ptr<Simulation> make_simulation(const List& scene, const ExactSolution* exact) {
  check_grid_memory(scene, available_memory());
  if (get<std::string>(scene, "geometry") == "line")
    return std::make_unique<SimulationIn<Line>>(scene, exact);
  return std::make_unique<SimulationIn<PlaneStrain>>(scene, exact);
}

}  // namespace brisance
