#pragma once
// The steps of a fluid: its stress follows from density and energy.
#include "materials/group_impl.hpp"

namespace brisance {

template <class G, class M>
class FluidGroup final : public MaterialGroup<G, M> {
 public:
  using MaterialGroup<G, M>::MaterialGroup;
  using MaterialGroup<G, M>::D;
  using History = typename M::History;

  bool relaxes() const override { return M::thermal; }

  void start() override {
    const Point point = this->point();
    Kokkos::parallel_for(
        "start", this->range(), KOKKOS_LAMBDA(const int p) { point.refresh(p); });
  }

  void half_step(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    this->each(
        in, "half step", KOKKOS_LAMBDA(const int p) {
          const Strain strain = point.strain(p, 0.5 * dt, around);
          History h = point.load(p);
          const Response r =
              point.material.update(strain, point.particles.template sigma<M::stress>(p), h);
          point.particles.template set_sigma<M::stress>(p, r.stress);
        });
  }

  void finish(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    this->each(
        in, "strain", KOKKOS_LAMBDA(const int p) {
          const Sym3 rate = strain_rate<G>(point.particles.matrix(point.particles.gradient, p));
          if constexpr (M::burns) {
            History h = point.load(p);
            point.material.advance_burn(point.strain(p, dt, around), h);
            point.save(p, h);
          }
          point.particles.vol(p) *= point.growth(rate, dt);
        });
    receive_energy(in, "receive energy");
  }

  void update(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    const bool printed = this->scheme.printed_work;
    this->each(
        in, "update", KOKKOS_LAMBDA(const int p) {
          Strain strain = point.strain(p, dt, around);
          strain.viscous_before = true;
          if (printed) strain.volume_change = trace(strain.rate) * dt / strain.rho1;
          History h = point.load(p);
          const Response r =
              point.material.update(strain, point.particles.template sigma<M::stress>(p), h);
          point.particles.vol(p) *= strain.growth;
          point.particles.template set_sigma<M::stress>(p, r.stress);
          point.save(p, h);
        });
  }

  void correct_volume(Sweep<D>& in, double rate) override {
    const Point point = this->point();
    this->each(
        in, "correct volume", KOKKOS_LAMBDA(const int p) {
          const double s = point.particles.scratch(p, 0), emptiness = point.particles.scratch(p, 1);
          if (emptiness > 0 || !(s > 0) || !M::relaxes(point.load(p))) return;
          const double share = rate * point.material.eos.volume_share;
          point.particles.vol(p) *= clamp(1 - share * (1 - 1 / s), 0.7, 1.4);
          point.refresh(p);
        });
  }

  void load_pressure(Sweep<D>& in) override {
    const Point point = this->point();
    this->each(
        in, "load pressure", KOKKOS_LAMBDA(const int p) {
          point.particles.scratch(p, 0) = -point.particles.template sigma<M::stress>(p)[0];
        });
  }

  void propose_exchange(Sweep<D>& in, double rate, double dt) override {
    const double h_cell = in.lattice().h;
    const Point point = this->point();
    this->each(
        in, "propose exchange", KOKKOS_LAMBDA(const int p) {
          const History h = point.load(p);
          const double pressure = point.pressure(p), smooth = point.smooth_pressure(p);
          double z = 0;
          if (pressure > 0 && M::relaxes(h)) {
            const double rho = point.rho(p), c = point.material.sound_speed(rho, h);
            const double modulus = rho * c * c * smooth / pressure;
            const double most_z = 0.3 * least(1, point.particles.m(p) * h.energy /
                                                     (pressure * point.particles.vol(p)));
            z = clamp(least(1, rate * dt * c / h_cell) * (pressure - smooth) / modulus, -most_z,
                      most_z);
          }
          point.particles.scratch(p, 1) = z;
        });
  }

  void exchange_volume(Sweep<D>& in) override {
    const Point point = this->point();
    this->each(
        in, "exchange volume", KOKKOS_LAMBDA(const int p) {
          const History h = point.load(p);
          const double inner = M::relaxes(h) ? point.particles.m(p) * h.energy : 0,
                       volume = point.particles.vol(p);
          const double gain = point.particles.scratch(p, 1) * volume;
          point.particles.scratch(p, 0) = inner > 0 ? point.smooth_pressure(p) * gain / inner : 0;
          point.particles.scratch(p, 1) = inner;
          if (inner > 0) point.particles.vol(p) = volume + gain;
        });
  }

  void exchange_energy(Sweep<D>& in) override {
    const Point point = this->point();
    this->each(
        in, "exchange energy", KOKKOS_LAMBDA(const int p) {
          const History h = point.load(p);
          point.particles.work(p, 0) =
              M::relaxes(h) ? -point.particles.scratch(p, 0) * h.energy : 0;
        });
    receive_energy(in, "receive exchange");
  }

  void load_heat(Sweep<D>& in, double rate, double dt) override {
    const Point point = this->point();
    this->each(
        in, "load heat", KOKKOS_LAMBDA(const int p) {
          const double compression = -trace(point.particles.matrix(point.particles.gradient, p));
          const History h = point.load(p);
          const double share = M::conducts && M::relaxes(h) ? rate * dt * compression : 0;
          point.particles.scratch(p, 0) = h.energy;
          point.particles.scratch(p, 1) = point.particles.m(p) * clamp(share, 0, 0.5);
        });
  }

  void conduct(Sweep<D>& in) override {
    const Point point = this->point();
    this->each(
        in, "conduct", KOKKOS_LAMBDA(const int p) {
          const double share = point.particles.scratch(p, 1) / point.particles.m(p);
          if (!(share > 0)) return;
          History h = point.load(p);
          h.energy -= share * point.particles.scratch(p, 0);
          point.save(p, h);
          point.refresh(p);
        });
  }

 private:
  using typename MaterialGroup<G, M>::Around;
  using typename MaterialGroup<G, M>::Point;

  /// Adds the work column [J/kg] to the energies and sets the stress. No energy falls below a fifth
  /// of what it was in one go: what a particle lacks for that, the others of its bin give, in
  /// proportion to what they can spare. What they cannot is owed to the bin, for the next group or
  /// step that can: light gas beside heavy products lacks more than all of it holds.
  void receive_energy(Sweep<D>& in, const char* name) {
    const Point point = this->point();
    if constexpr (!M::thermal) {
      this->each(
          in, name, KOKKOS_LAMBDA(const int p) {
            History h = point.load(p);
            h.energy += point.particles.work(p, 0);
            point.save(p, h);
            point.refresh(p);
          });
      return;
    }
    const auto first = point.particles.first;
    const auto owed = this->debt;
    const bool on_credit = owed.extent(0) > 0;
    const auto floors = this->floors_;
    in.add(
        name, KOKKOS_LAMBDA(const Row<D>& row) {
          std::int64_t held = 0;
          for (int bin = row.begin; bin < row.end; ++bin) {
            double lacking = 0, spare = 0;
            for (int p = first(bin); p < first(bin + 1); ++p) {
              const double e = point.load(p).energy, margin = 0.8 * e + point.particles.work(p, 0);
              (margin < 0 ? lacking : spare) += point.particles.m(p) * fabs(margin);
            }
            held += lacking > spare;
            if (on_credit) lacking += owed(bin);
            const double share = lacking > 0 ? (spare > lacking ? lacking / spare : 1) : 0;
            if (on_credit) owed(bin) = most(lacking - spare, 0);
            for (int p = first(bin); p < first(bin + 1); ++p) {
              History h = point.load(p);
              const double margin = 0.8 * h.energy + point.particles.work(p, 0);
              h.energy = 0.2 * h.energy + (margin < 0 ? 0 : margin * (1 - share));
              point.save(p, h);
              point.refresh(p);
            }
          }
          if (held > 0) Kokkos::atomic_add(&floors(), held);
        });
  }
};

}  // namespace brisance
