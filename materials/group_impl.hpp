#pragma once
// A group of particles of one material, as far as fluids and solids are alike.
#include "core/geometry.hpp"
#include "core/group.hpp"
#include "materials/point.hpp"

namespace brisance {

template <class G, class M>
class MaterialGroup : public Group<G> {
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
    needs.half_stress = this->scheme.midpoint && !M::fluid;
    needs.relaxation = needs.relaxation && this->relaxes();
    needs.compression = needs.compression && this->relaxes();
    needs.stress_relaxation = this->scheme.stress_relaxation > 0 && !M::fluid;
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
          if constexpr (!M::fluid) {
            Sym3 stress;
            for (int k = 0; k < 3; ++k) stress[k] = -given;
            point.particles.template set_sigma<M::stress>(p, stress);
          }
        });
  }

  void find_signals(Sweep<D>& in) override {
    make_room_for_signals(in.rows());
    const Point point = this->point();
    const double strain_length = this->scheme.strain_length, h = in.lattice().h;
    const auto of_rows = signals_;
    in.add(
        "signals", KOKKOS_LAMBDA(const Row<D>& row) {
          double over_grid = 0, in_matter = 0;
          point.each(row, [&](const auto& p) BRISANCE_INLINE {
            const auto rate = point.rate(p);
            const auto rho = point.rho(p), c = point.material.sound_speed(rho, point.load(p));
            const auto signal = point.material.signal_speed(rate, rho, c, h);
            using T = decltype(point.rho(p));
            T v = 0;
            for (int d = 0; d < D; ++d)
              v = most(v, fabs(point.particles.get(point.particles.velocity, p, d)));
            in_matter = most(in_matter, greatest(finite(signal)));
            over_grid =
                most(over_grid,
                     greatest(finite(most(v + signal, T(strain_length) * fabs(trace(rate))))));
          });
          of_rows(row.number, 0) = over_grid;
          of_rows(row.number, 1) = in_matter;
        });
  }

  Signals signals() const override {
    const auto of_rows = signals_;
    Signals s;
    Kokkos::parallel_reduce(
        "fastest signals", Kokkos::RangePolicy<Space>(0, static_cast<int>(of_rows.extent(0))),
        KOKKOS_LAMBDA(const int r, double& over_grid, double& in_matter) {
          over_grid = most(over_grid, of_rows(r, 0));
          in_matter = most(in_matter, of_rows(r, 1));
        },
        Kokkos::Max<double>(s.over_grid), Kokkos::Max<double>(s.in_matter));
    return {most(s.over_grid, 0), most(s.in_matter, 0)};
  }

  void set_signals(const Lattice<D>& lattice, const Signals& known) override {
    make_room_for_signals(RowLayout<D>(lattice).rows);
    Kokkos::deep_copy(Kokkos::subview(signals_, Kokkos::ALL, 0), known.over_grid);
    Kokkos::deep_copy(Kokkos::subview(signals_, Kokkos::ALL, 1), known.in_matter);
  }

  Totals totals(int begin, int end, double affine_inertia) const override;
  void report(const Array<double>& pressure, const Array<double>& energy) const override;

 private:
  Table<double> signals_;  ///< of each row: the fastest over the grid and in matter [m/s]

  void make_room_for_signals(int rows) {
    if (static_cast<int>(signals_.extent(0)) != rows)
      signals_ = Table<double>("signals of rows", rows, 2);
  }

 protected:
  M material;

  using Point = MaterialPoint<G, M>;
  using Around = Surroundings<G>;

  Point point() const { return {material, this->particles}; }
  Kokkos::RangePolicy<Space> range() const {
    return Kokkos::RangePolicy<Space>(0, this->particles.count);
  }

  /// A stage that does f(point, p) for each particle, p being one of them or, where the law is
  /// wide, a bundle; what it does to one does not concern another.
  template <class F>
  void each(Sweep<D>& in, const char* name, const F& f) {
    const Point point = this->point();
    in.add(
        name, KOKKOS_LAMBDA(const Row<D>& row) {
          point.each(row, [&](const auto& p) BRISANCE_INLINE { f(point, p); });
        });
  }
  /// Infinity for what is not a number, which a maximum would pass over.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION static T finite(const T& speed) {
    return select(speed < T(1e300), speed, T(1e300));
  }
};

template <class G, class M>
Totals MaterialGroup<G, M>::totals(int begin, int end, double affine_inertia) const {
  const Point point = this->point();
  const bool affine = point.particles.affine.extent(1) > 0;
  // Fixed blocks, summed in order: the same bits for any number of threads.
  constexpr int block = 1024;
  const int blocks = (end - begin + block - 1) / block;
  const Array<Totals> partial("partial totals", blocks);
  Kokkos::parallel_for(
      "totals", Kokkos::RangePolicy<Space>(0, blocks), KOKKOS_LAMBDA(const int b) {
        Totals sum;
        const int last = begin + (b + 1) * block < end ? begin + (b + 1) * block : end;
        for (int p = begin + b * block; p < last; ++p) {
          const History h = point.load(p);
          const double m = point.particles.m(p);
          const Vec<D> v = point.particles.v(p);
          double twice = dot(v, v);
          if (affine)
            for (int k = 0; k < D * D; ++k)
              twice += affine_inertia * square(point.particles.affine(p, k));
          for (int d = 0; d < D; ++d) {
            sum.momentum[d] += m * v[d];
            sum.absolute_momentum[d] += m * fabs(v[d]);
          }
          sum.motion += m * sqrt(dot(v, v));
          sum.mass += m;
          sum.kinetic += 0.5 * m * twice;
          sum.internal += m * M::energy(h);
          if constexpr (!M::fluid)
            sum.work.add(point.material.energies(point.particles.template sigma<M::stress>(p),
                                                 point.rho(p), h),
                         m);
        }
        partial(b) = sum;
      });
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), partial);
  Totals t;
  for (int b = 0; b < blocks; ++b) t += host(b);
  return t;
}

template <class G, class M>
void MaterialGroup<G, M>::report(const Array<double>& pressure, const Array<double>& energy) const {
  const Point point = this->point();
  Kokkos::parallel_for(
      "report", range(), KOKKOS_LAMBDA(const int p) {
        const History h = point.load(p);
        if constexpr (M::fluid)
          pressure(p) = -trace(point.material.state(point.rho(p), h).stress) / 3;
        else
          pressure(p) = -trace(point.particles.template sigma<M::stress>(p)) / 3;
        energy(p) = M::energy(h);
      });
}

}  // namespace brisance
