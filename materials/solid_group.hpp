#pragma once
// The steps of a solid: its stress is state, turned and strained step by step.
#include "materials/group_impl.hpp"

namespace brisance {

template <class G, class M>
class SolidGroup final : public MaterialGroup<G, M> {
 public:
  using MaterialGroup<G, M>::MaterialGroup;
  using History = typename M::History;

  void start() override {}

  void half_step(const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    this->each(
        "half step of solid", KOKKOS_LAMBDA(const int p) {
          History h = point.load(p);
          const Sym3 old = point.turn(p, 0.5 * dt, h);
          const Response r = point.material.update(point.strain(p, 0.5 * dt, around), old, h);
          point.particles.template set_sigma<M::stress>(point.particles.acting, p, r.stress);
        });
  }

  void finish(const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    this->each(
        "finish solid", KOKKOS_LAMBDA(const int p) {
          History h = point.load(p);
          const Strain in = point.strain(p, dt, around);
          const Response r = point.material.update(in, point.turn(p, dt, h), h);
          h.energy += point.particles.work(p, 0);
          store(point, p, in, r, h);
        });
  }

  /// The work is that of the mean stress of the step on its strain.
  void update(const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    this->each(
        "update solid", KOKKOS_LAMBDA(const int p) {
          History h = point.load(p);
          const Strain in = point.strain(p, dt, around);
          const Sym3 old = point.turn(p, dt, h);
          const Response r = point.material.update(in, old, h);
          h.energy += 0.5 * dt / in.rho0 * (contract(old, in.rate) + contract(r.stress, in.rate));
          store(point, p, in, r, h);
        });
  }

  void load_stress() override {
    const Point point = this->point();
    this->each(
        "load stress", KOKKOS_LAMBDA(const int p) {
          for (int k = 0; k < 3; ++k) point.particles.scratch(p, k) = point.particles.stress(p, k);
          point.particles.scratch(p, 3) = M::whole(point.load(p)) ? point.particles.vol(p) : 0;
        });
  }

  void relax_stress(double dt, double h) override {
    const Point point = this->point();
    const double rate = this->scheme.stress_relaxation * dt / h;
    this->each(
        "relax stress", KOKKOS_LAMBDA(const int p) {
          const History state = point.load(p);
          if (!M::whole(state)) return;
          const double share = least(0.5, rate * point.material.sound_speed(point.rho(p), state));
          for (int k = 0; k < 3; ++k)
            point.particles.stress(p, k) -= share * point.particles.scratch(p, k);
        });
  }

 private:
  using typename MaterialGroup<G, M>::Around;
  using typename MaterialGroup<G, M>::Point;

  KOKKOS_INLINE_FUNCTION static void store(const Point& point, int p, const Strain& in,
                                           const Response& r, const History& h) {
    point.particles.vol(p) *= in.rho0 / in.rho1;
    point.particles.template set_sigma<M::stress>(p, r.stress);
    point.save(p, h);
  }
};

}  // namespace brisance
