#pragma once
// The steps of a solid: its stress is state, turned and strained step by step.
#include "materials/group_impl.hpp"

namespace brisance {
namespace solid_stages {

/// The stress half a step on, which acts at the nodes.
template <class G>
struct HalfStep {
  Surroundings<G> around;
  double dt;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    point.look_ahead(p);
    auto h = point.load(p);
    const auto old = point.turn(p, 0.5 * dt, h);
    const auto r = point.material.update(point.strain(p, 0.5 * dt, around), old, h);
    point.particles.template set_sigma<P::Law::stress>(point.particles.acting, p, r.stress);
  }
};

/// The state at the end of the step. The work is that of the midpoint step, or of the mean stress
/// of the step on its strain (MUSL).
template <class G>
struct Finish {
  Surroundings<G> around;
  double dt;
  bool midpoint;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    auto h = point.load(p);
    const auto strain = point.strain(p, dt, around);
    const auto old = point.turn(p, dt, h);
    const auto r = point.material.update(strain, old, h);
    if (midpoint)
      h.energy += point.work(p);
    else
      h.energy +=
          0.5 * dt / strain.rho0 * (contract(old, strain.rate) + contract(r.stress, strain.rate));
    point.finish(p, strain, r, h);
  }
};

struct LoadStress {
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    const auto stress = point.stress(p);
    using T = decltype(point.volume(p));
    for (int k = 0; k < 3; ++k) point.set_scratch(p, k, stress[k]);
    point.set_scratch(p, 3, select(P::Law::whole(point.load(p)), point.volume(p), T(0)));
  }
};

/// Stress <- stress without a share of the residuals that scratch holds.
struct RelaxStress {
  double rate;
  template <class P, class I>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(const P& point, const I& p) const {
    const auto state = point.load(p);
    using T = std::decay_t<decltype(state.energy)>;
    const T share =
        select(P::Law::whole(state),
               least(T(0.5), rate * point.material.sound_speed(point.rho(p), state)), T(0));
    auto stress = point.stress(p);
    for (int k = 0; k < 3; ++k) stress[k] -= share * point.scratch(p, k);
    point.set_stress(p, stress);
  }
};

}  // namespace solid_stages

template <class G, class M>
class SolidGroup final : public MaterialGroup<G, M> {
 public:
  using MaterialGroup<G, M>::MaterialGroup;
  using MaterialGroup<G, M>::D;

  void start() override {}

  void half_step(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    this->each(in, "half step of solid", solid_stages::HalfStep<G>{Around(grid), dt});
  }
  void finish(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    this->each(in, "finish solid", solid_stages::Finish<G>{Around(grid), dt, true});
  }
  void update(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    this->each(in, "update solid", solid_stages::Finish<G>{Around(grid), dt, false});
  }
  void load_stress(Sweep<D>& in) override {
    this->each(in, "load stress", solid_stages::LoadStress{});
  }
  void relax_stress(Sweep<D>& in, double dt) override {
    const double rate = this->scheme.stress_relaxation * dt / in.lattice().h;
    this->each(in, "relax stress", solid_stages::RelaxStress{rate});
  }

 private:
  using typename MaterialGroup<G, M>::Around;
};

}  // namespace brisance
