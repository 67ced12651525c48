// Each law at many points that are strained to and fro, without grid and particles, on one thread.
#include <benchmark/benchmark.h>

#include <Teuchos_ParameterList.hpp>
#include <vector>

#include "core/parameters.hpp"
#include "materials/fluid.hpp"
#include "materials/registry.hpp"
#include "perf/benchmarks.hpp"
#include "test/explosive.hpp"

namespace brisance::perf {
namespace {

constexpr int points = 4096;  // of which stresses and states fit the second cache

/// `energy`: at the start [J/kg]; `strain`: of a step, along x and in shear.
template <class Law>
void update(benchmark::State& state, const Law& law, double rho, double energy, double strain) {
  typename Law::History start = law.initial(rho, energy, true);
  std::vector<typename Law::History> history(points, start);
  std::vector<Sym3> stress(points);
  if constexpr (Law::fluid)
    for (auto& s : stress) s = law.state(rho, start).stress;
  Strain in;
  in.dt = 1e-6;
  in.h = in.spacing = 1e-3;
  double way = 1;
  for ([[maybe_unused]] auto once : state) {
    for (int k = 0; k < points; ++k) {
      // Some points more than others, as in a flow: which branch a law takes is not the same.
      const double e = way * strain * (1 + k % 7);
      in.rate[0] = e / in.dt;
      in.rate[3] = 0.5 * e / in.dt;
      in.growth = 1 + e;
      in.rho0 = way > 0 ? rho : rho / (1 + e);
      in.rho1 = way > 0 ? rho / (1 + e) : rho;
      in.volume_change = 1 / in.rho1 - 1 / in.rho0;
      stress[k] = law.update(in, stress[k], history[k]).stress;
    }
    benchmark::DoNotOptimize(stress.data());
    benchmark::ClobberMemory();
    way = -way;
  }
  state.counters["points/s"] = benchmark::Counter(points * static_cast<double>(state.iterations()),
                                                  benchmark::Counter::kIsRate);
}

template <class Law>
void add(const Law& law, double rho, double energy, double strain) {
  benchmark::RegisterBenchmark(
      (std::string("law/") + Law::name).c_str(),
      [=](benchmark::State& state) { update(state, law, rho, energy, strain); })
      ->Unit(benchmark::kMicrosecond);
}

template <class Solid>
void add_solid(List given, double strain) {
  const Solid law(check(given, Solid::valid_parameters(given)));
  add(law, law.density(), 0, strain);
}

}  // namespace

void register_laws() {
  add(Fluid<PerfectGas>{PerfectGas(1.4), {}, {}}, 1.2, 2e5, 1e-3);
  List tnt = test::tnt();
  tnt.set("burn", "at once");
  add(Fluid<Jwl>{Jwl(check(tnt, Jwl::valid_parameters())), {}, {}}, 1630, 6e9 / 1630, 1e-3);
  List steel;
  steel.set("Young's modulus", 200e9).set("Poisson's ratio", 0.29).set("density", 7850.);
  add_solid<Elastic>(steel, 1e-4);
  add_solid<VonMises>(List(steel).set("yield stress", 500e6), 1e-3);
  add_solid<DruckerPrager>(List(steel).set("compressive strength", 40e6), 1e-4);
  add_solid<Concrete>(List(), 2e-5);
}

}  // namespace brisance::perf
