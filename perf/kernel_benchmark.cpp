// The kernels of a step one by one, on a box of gas with 2 x 2 particles in each cell. GB/s count
// what a kernel has to read and write of its particles' columns at least, once.
#include <benchmark/benchmark.h>

#include <string>

#include "perf/benchmarks.hpp"
#include "test/state.hpp"

namespace brisance::perf {
namespace {

using G = PlaneStrain;
using Stages = Sweep<G::dim>;

constexpr int cells = 200;
constexpr double dt = 1e-12;  // so that particles stay where they are

struct Kernel {
  const char* name;
  double values, affine_values;  ///< of a particle, read or written; the latter with affine fields
  void (*add)(Stages&, State<G>&);
};

const Kernel kernels[] = {
    {"momentum", 5, 4,
     [](Stages& in, State<G>& s) {
       s.groups[0]->transfer->scatter_momentum(in, s.groups[0]->particles, s.sums);
     }},
    {"gradient", 2, 0,
     [](Stages& in, State<G>& s) {
       s.groups[0]->transfer->gather_gradient(in, s.groups[0]->particles, s.grid.before);
     }},
    {"material half a step", 5, 0,
     [](Stages& in, State<G>& s) { s.groups[0]->half_step(in, s.grid, dt); }},
    {"force", 4, 0,
     [](Stages& in, State<G>& s) {
       s.groups[0]->transfer->scatter_force(in, s.groups[0]->particles, s.grid, Stress::pressure,
                                            s.sums);
     }},
    {"end of the step", 11, 8,
     [](Stages& in, State<G>& s) {
       s.groups[0]->transfer->finish_midpoint(in, s.groups[0]->particles, s.grid, Stress::pressure,
                                              0, 0.97, dt);
     }},
    {"material whole step", 4, 0,
     [](Stages& in, State<G>& s) { s.groups[0]->finish(in, s.grid, dt); }},
    {"bins", 2.5, 0, [](Stages& in, State<G>& s) {
       s.groups[0]->transfer->find_bins(in, s.groups[0]->particles);
     }}};

State<G> box(const TransferChoice& choice) {
  test::RandomGas of;
  of.transfer = choice;
  of.cells = cells;
  of.per_cell = 2;
  of.regular = true;
  of.velocity_range = 0.1;
  State<G> state = test::random_gas<G>(of);
  test::step(state);  // nodes have velocities, cells their means
  return state;
}

void count(benchmark::State& state, double particles, double values) {
  const double all = particles * static_cast<double>(state.iterations());
  state.counters["particles/s"] = benchmark::Counter(all, benchmark::Counter::kIsRate);
  state.counters["GB/s"] = benchmark::Counter(8e-9 * values * all, benchmark::Counter::kIsRate);
}

void run(benchmark::State& state, const TransferChoice& choice, const Kernel& kernel) {
  State<G> gas = box(choice);
  for ([[maybe_unused]] auto once : state) {
    Stages stages(gas.grid.lattice);
    kernel.add(stages, gas);
    stages.run();
    Kokkos::fence();
  }
  const bool affine = gas.groups[0]->transfer->affine();
  count(state, gas.groups[0]->particles.count, kernel.values + (affine ? kernel.affine_values : 0));
}

/// Of particles that are in order.
void sort(benchmark::State& state, const TransferChoice& choice) {
  State<G> gas = box(choice);
  Particles<G>& particles = gas.groups[0]->particles;
  for ([[maybe_unused]] auto once : state) gas.sorter.sort(particles, gas.grid.lattice);
  double values = 0.5;
  particles.each_column([&](const char*, const Table<double>& column, bool carried) {
    if (carried) values += 2 * static_cast<double>(column.extent(1));
  });
  count(state, particles.count, values);
}

}  // namespace

void register_kernels() {
  for (const TransferChoice& choice :
       {TransferChoice{"linear", "FLIP", "cell"}, TransferChoice{"linear", "FLIP", "particle"},
        TransferChoice{"GIMP", "FLIP", "particle"}, TransferChoice{"quadratic", "MLS", "particle"},
        TransferChoice{"cubic", "MLS", "particle"}}) {
    const std::string path = "kernel/" + test::name_of(choice) + "/";
    for (const Kernel& kernel : kernels)
      add(path + kernel.name, [=](benchmark::State& state) { run(state, choice, kernel); });
  }
  const TransferChoice any;
  add("kernel/sort", [=](benchmark::State& state) { sort(state, any); });
}

}  // namespace brisance::perf
