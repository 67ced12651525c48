#pragma once
// A group of particles of one material: the kernels that carry its law to its particles.
#include "core/geometry.hpp"
#include "core/group.hpp"
#include "materials/point.hpp"

namespace brisance {

template <class G, class M>
class MaterialGroup final : public Group<G> {
 public:
  static constexpr int D = G::dim;
  using History = typename M::History;

  explicit MaterialGroup(const M& material_) : material(material_) {}

  Stress stress() const override { return M::stress; }
  bool fluid() const override { return M::fluid; }

  std::vector<FieldName> history_fields() const override {
    std::vector<FieldName> names;
    for (const auto& f : M::fields) names.push_back({f.name, f.unit});
    return names;
  }

  void allocate(int capacity, ColumnNeeds needs) override {
    needs.stress = M::stress;
    needs.history = M::field_count;
    needs.affine = this->transfer->affine();
    needs.work = this->scheme.midpoint;
    needs.relaxation = needs.relaxation && M::fluid;
    needs.extent = D > 1 && (this->transfer->sized() || (needs.extent && M::fluid));
    this->particles = Particles<G>(capacity, needs);
  }

  void initialise(int begin, bool from_energy) override {
    const Point point = this->point();
    Kokkos::parallel_for(
        "initialise", Kokkos::RangePolicy<Space>(begin, this->particles.count),
        KOKKOS_LAMBDA(const int p) {
          const double given = point.particles.stress(p, 0);
          point.save(p, point.material.initial(point.rho(p), given, from_energy));
        });
  }

  void start() override {
    const Point point = this->point();
    each(
        "start", KOKKOS_LAMBDA(const int p) { point.refresh(p); });
  }

  Signals signals(double h) const override {
    const Point point = this->point();
    const double strain_length = this->scheme.strain_length;
    Signals s;
    Kokkos::parallel_reduce(
        "signals", range(),
        KOKKOS_LAMBDA(const int p, double& fastest, double& in_matter) {
          const Sym3 rate = strain_rate<G>(point.particles.matrix(point.particles.gradient, p));
          const double rho = point.rho(p), c = point.material.sound_speed(rho, point.load(p));
          const double signal = point.material.signal_speed(rate, rho, c, h);
          double v = 0;
          for (int d = 0; d < D; ++d) v = most(v, fabs(point.particles.velocity(p, d)));
          in_matter = most(in_matter, finite(signal));
          fastest = most(fastest, finite(most(v + signal, strain_length * fabs(trace(rate)))));
        },
        Kokkos::Max<double>(s.fastest), Kokkos::Max<double>(s.in_matter));
    return {most(s.fastest, 0), most(s.in_matter, 0)};
  }

  void half_step(const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    each(
        "half step", KOKKOS_LAMBDA(const int p) {
          const Strain in = point.strain(p, 0.5 * dt, around);
          History h = point.load(p);
          const Response r =
              point.material.update(in, point.particles.template sigma<M::stress>(p), h);
          point.particles.template set_sigma<M::stress>(p, r.stress);
        });
  }

  void finish(double dt) override {
    const Point point = this->point();
    each(
        "strain", KOKKOS_LAMBDA(const int p) {
          const Sym3 rate = strain_rate<G>(point.particles.matrix(point.particles.gradient, p));
          point.particles.vol(p) *= point.growth(rate, dt);
        });
    receive_energy("receive energy");
  }

  void update(const Grid<G>& grid, double dt) override {
    const Point point = this->point();
    const Around around(grid);
    const bool printed = this->scheme.printed_work;
    each(
        "update", KOKKOS_LAMBDA(const int p) {
          Strain in = point.strain(p, dt, around);
          in.viscous_before = true;
          if (printed) in.volume_change = trace(in.rate) * dt / in.rho1;
          History h = point.load(p);
          const Response r =
              point.material.update(in, point.particles.template sigma<M::stress>(p), h);
          point.particles.vol(p) = point.particles.m(p) / in.rho1;
          point.particles.template set_sigma<M::stress>(p, r.stress);
          point.save(p, h);
        });
  }

  void correct_volume(double rate) override {
    const Point point = this->point();
    each(
        "correct volume", KOKKOS_LAMBDA(const int p) {
          const double s = point.particles.scratch(p, 0), emptiness = point.particles.scratch(p, 1);
          if (emptiness > 0 || !(s > 0)) return;
          point.particles.vol(p) *= clamp(1 - rate * (1 - 1 / s), 0.7, 1.4);
          point.refresh(p);
        });
  }

  void load_pressure() override {
    const Point point = this->point();
    each(
        "load pressure", KOKKOS_LAMBDA(const int p) {
          point.particles.scratch(p, 0) = -point.particles.template sigma<M::stress>(p)[0];
        });
  }

  void propose_exchange(double rate, double dt, double h_cell) override {
    const Point point = this->point();
    each(
        "propose exchange", KOKKOS_LAMBDA(const int p) {
          const History h = point.load(p);
          const double pressure = point.pressure(p), smooth = point.smooth_pressure(p);
          double z = 0;
          if (pressure > 0) {
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

  void exchange_volume() override {
    const Point point = this->point();
    each(
        "exchange volume", KOKKOS_LAMBDA(const int p) {
          const History h = point.load(p);
          const double inner = point.particles.m(p) * h.energy, volume = point.particles.vol(p);
          const double gain = point.particles.scratch(p, 1) * volume;
          point.particles.scratch(p, 0) = inner > 0 ? point.smooth_pressure(p) * gain / inner : 0;
          point.particles.scratch(p, 1) = inner;
          point.particles.vol(p) = volume + gain;
        });
  }

  void exchange_energy() override {
    const Point point = this->point();
    each(
        "exchange energy", KOKKOS_LAMBDA(const int p) {
          point.particles.work(p, 0) = -point.particles.scratch(p, 0) * point.load(p).energy;
        });
    receive_energy("receive exchange");
  }

  void load_heat(double rate, double dt) override {
    const Point point = this->point();
    each(
        "load heat", KOKKOS_LAMBDA(const int p) {
          const double compression = -trace(point.particles.matrix(point.particles.gradient, p));
          point.particles.scratch(p, 0) = point.load(p).energy;
          point.particles.scratch(p, 1) =
              point.particles.m(p) * clamp(rate * dt * compression, 0, 0.5);
        });
  }

  void conduct() override {
    const Point point = this->point();
    each(
        "conduct", KOKKOS_LAMBDA(const int p) {
          const double share = point.particles.scratch(p, 1) / point.particles.m(p);
          if (!(share > 0)) return;
          History h = point.load(p);
          h.energy -= share * point.particles.scratch(p, 0);
          point.save(p, h);
          point.refresh(p);
        });
  }

  Totals totals(int begin, int end, double affine_inertia) const override;
  void report(const Array<double>& pressure, const Array<double>& energy) const override;

 private:
  M material;

  using Point = MaterialPoint<G, M>;
  using Around = Surroundings<G>;

  Point point() const { return {material, this->particles}; }
  Kokkos::RangePolicy<Space> range() const {
    return Kokkos::RangePolicy<Space>(0, this->particles.count);
  }

  template <class F>
  void each(const char* name, const F& f) {
    Kokkos::parallel_for(name, range(), f);
  }
  /// Infinity for what is not a number, which a maximum would pass over.
  KOKKOS_INLINE_FUNCTION static double finite(double speed) {
    return speed < 1e300 ? speed : 1e300;
  }

  /// Adds the work column [J/kg] to the energies and sets the stress. No energy falls below a fifth
  /// of what it was in one go: what a particle lacks for that, the others of its bin give, in
  /// proportion to what they can spare.
  void receive_energy(const char* name) {
    const Point point = this->point();
    const auto first = point.particles.first;
    int held = 0;
    Kokkos::parallel_reduce(
        name, Kokkos::RangePolicy<Space>(0, static_cast<int>(first.extent(0)) - 2),
        KOKKOS_LAMBDA(const int bin, int& sum) {
          double lacking = 0, spare = 0;
          for (int p = first(bin); p < first(bin + 1); ++p) {
            const double e = point.load(p).energy, margin = 0.8 * e + point.particles.work(p, 0);
            (margin < 0 ? lacking : spare) += point.particles.m(p) * fabs(margin);
          }
          const double share = lacking > 0 ? (spare > lacking ? lacking / spare : 1) : 0;
          sum += lacking > spare;
          for (int p = first(bin); p < first(bin + 1); ++p) {
            History h = point.load(p);
            const double margin = 0.8 * h.energy + point.particles.work(p, 0);
            h.energy = 0.2 * h.energy + (margin < 0 ? 0 : margin * (1 - share));
            point.save(p, h);
            point.refresh(p);
          }
        },
        held);
    this->floors += held;
  }
};

template <class G, class M>
Totals MaterialGroup<G, M>::totals(int begin, int end, double affine_inertia) const {
  const Point point = this->point();
  const bool affine = point.particles.affine.extent(1) > 0;
  // Fixed blocks, summed in order: the same bits for any number of threads.
  constexpr int block = 1024, sums = D + 3;
  const int blocks = (end - begin + block - 1) / block;
  const Table<double> partial("partial totals", blocks, sums);
  Kokkos::parallel_for(
      "totals", Kokkos::RangePolicy<Space>(0, blocks), KOKKOS_LAMBDA(const int b) {
        double sum[sums] = {};
        const int last = begin + (b + 1) * block < end ? begin + (b + 1) * block : end;
        for (int p = begin + b * block; p < last; ++p) {
          const double m = point.particles.m(p);
          const Vec<D> v = point.particles.v(p);
          double twice = dot(v, v);
          if (affine)
            for (int k = 0; k < D * D; ++k)
              twice += affine_inertia * square(point.particles.affine(p, k));
          for (int d = 0; d < D; ++d) sum[d] += m * v[d];
          sum[D] += m;
          sum[D + 1] += 0.5 * m * twice;
          sum[D + 2] += m * M::energy(point.load(p));
        }
        for (int k = 0; k < sums; ++k) partial(b, k) = sum[k];
      });
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), partial);
  Totals t;
  for (int b = 0; b < blocks; ++b) {
    for (int d = 0; d < D; ++d) t.momentum[d] += host(b, d);
    t.mass += host(b, D);
    t.kinetic += host(b, D + 1);
    t.internal += host(b, D + 2);
  }
  return t;
}

template <class G, class M>
void MaterialGroup<G, M>::report(const Array<double>& pressure, const Array<double>& energy) const {
  const Point point = this->point();
  Kokkos::parallel_for(
      "report", range(), KOKKOS_LAMBDA(const int p) {
        const History h = point.load(p);
        pressure(p) = -trace(point.material.state(point.rho(p), h).stress) / 3;
        energy(p) = M::energy(h);
      });
}

}  // namespace brisance
