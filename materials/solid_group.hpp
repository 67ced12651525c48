#pragma once
// The steps of a solid: its stress is state, turned and strained step by step.
#include "materials/group_impl.hpp"

namespace brisance {

template <class G, class M>
class SolidGroup final : public MaterialGroup<G, M> {
 public:
  using MaterialGroup<G, M>::MaterialGroup;
  using MaterialGroup<G, M>::D;
  using History = typename M::History;

  void start() override {}

  void half_step(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    this->each(
        in, "half step of solid", KOKKOS_LAMBDA(const int p) {
          History h = point.load(p);
          const Sym3 old = point.turn(p, 0.5 * dt, h);
          const Response r = point.material.update(point.strain(p, 0.5 * dt, around), old, h);
          point.particles.template set_sigma<M::stress>(point.particles.acting, p, r.stress);
        });
  }

  void finish(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    this->each(
        in, "finish solid", KOKKOS_LAMBDA(const int p) {
          History h = point.load(p);
          const Strain strain = point.strain(p, dt, around);
          const Response r = point.material.update(strain, point.turn(p, dt, h), h);
          h.energy += point.particles.work(p, 0);
          store(point, p, strain, r, h);
        });
  }

  /// The work is that of the mean stress of the step on its strain.
  void update(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    this->each(
        in, "update solid", KOKKOS_LAMBDA(const int p) {
          History h = point.load(p);
          const Strain strain = point.strain(p, dt, around);
          const Sym3 old = point.turn(p, dt, h);
          const Response r = point.material.update(strain, old, h);
          h.energy += 0.5 * dt / strain.rho0 *
                      (contract(old, strain.rate) + contract(r.stress, strain.rate));
          store(point, p, strain, r, h);
        });
  }

  void load_stress(Sweep<D>& in) override {
    const Point point = this->point();
    this->each(
        in, "load stress", KOKKOS_LAMBDA(const int p) {
          for (int k = 0; k < 3; ++k) point.particles.scratch(p, k) = point.particles.stress(p, k);
          point.particles.scratch(p, 3) = M::whole(point.load(p)) ? point.particles.vol(p) : 0;
        });
  }

  void relax_stress(Sweep<D>& in, double dt) override {
    const Point point = this->point();
    const double rate = this->scheme.stress_relaxation * dt / in.lattice().h;
    this->each(
        in, "relax stress", KOKKOS_LAMBDA(const int p) {
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

  KOKKOS_INLINE_FUNCTION static void store(const Point& point, int p, const Strain& strain,
                                           const Response& r, const History& h) {
    point.particles.vol(p) *= strain.growth;
    point.particles.template set_sigma<M::stress>(p, r.stress);
    point.save(p, h);
  }
};

}  // namespace brisance
