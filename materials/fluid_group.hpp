#pragma once
// The steps of a fluid: its stress follows from density and energy.
#include "materials/fluid_stages.hpp"
#include "materials/group_impl.hpp"

namespace brisance {

template <class G, class M>
class FluidGroup final : public MaterialGroup<G, M> {
 public:
  using MaterialGroup<G, M>::MaterialGroup;
  using MaterialGroup<G, M>::D;

  bool relaxes() const override { return M::thermal; }

  void start() override {
    const Point point = this->point();
    Kokkos::parallel_for(
        "start", this->range(), KOKKOS_LAMBDA(const int p) { point.refresh(p); });
  }

  void half_step(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    this->each(in, "half step", fluid_stages::HalfStep<G>{Around(grid), dt});
  }

  void finish(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    this->each(in, "strain", fluid_stages::Strained<G>{Around(grid), dt});
    receive_energy(in, "receive energy");
  }

  void update(Sweep<D>& in, const Grid<G>& grid, double dt) override {
    this->each(in, "update", fluid_stages::Update<G>{Around(grid), dt, this->scheme.printed_work});
  }

  void correct_volume(Sweep<D>& in, double rate) override {
    this->each(in, "correct volume", fluid_stages::CorrectVolume{rate});
  }
  void load_pressure(Sweep<D>& in) override {
    this->each(in, "load pressure", fluid_stages::LoadPressure{});
  }
  void propose_exchange(Sweep<D>& in, double rate, double dt) override {
    this->each(in, "propose exchange", fluid_stages::ProposeExchange{rate, dt, in.lattice().h});
  }
  void exchange_volume(Sweep<D>& in, bool exchanges, double heat) override {
    this->each(in, "exchange volume", fluid_stages::ExchangeVolume{exchanges, heat});
  }
  void exchange_energy(Sweep<D>& in, bool exchanges, bool conducts) override {
    this->each(in, "exchange energy",
               fluid_stages::ExchangeEnergy{exchanges, conducts && M::conducts});
    receive_energy(in, "receive exchange");
  }

 private:
  using typename MaterialGroup<G, M>::Around;
  using typename MaterialGroup<G, M>::Point;

  /// Adds the work column [J/kg] to the energies and sets the stress. No energy falls below a fifth
  /// of what it was in one go: what a particle lacks for that, the others of its bin give.
  void receive_energy(Sweep<D>& in, const char* name) {
    if constexpr (!M::thermal) {
      this->each(in, name, fluid_stages::ReceiveWork{});
    } else {
      static_assert(M::fields[0].member == &M::History::energy, "the first column is the energy");
      const Receive receive{this->point(), this->debt, this->floors_};
      in.add(
          name, KOKKOS_LAMBDA(const Row<D>& row) { receive(row); });
    }
  }

  struct Receive {
    Point point;
    Array<double> owed;
    Kokkos::View<std::int64_t, Space> floors;

    KOKKOS_INLINE_FUNCTION void operator()(const Row<D>& row) const {
      if (lacks(row)) {
        share(row);
        point.each(row, [&](const auto& p) BRISANCE_INLINE { point.refresh(p); });
      } else {
        point.each(row, [&](const auto& p) BRISANCE_INLINE {
          const Particles<G>& points = point.particles;
          points.put(points.history, p, 0, points.get(points.history, p) + point.work(p));
          point.refresh(p);
        });
      }
    }

    /// Of a particle's energy after its work, what is more than a fifth of that before. [J/kg]
    template <class I>
    KOKKOS_FORCEINLINE_FUNCTION auto margin(const I& p) const {
      return 0.8 * point.particles.get(point.particles.history, p) + point.work(p);
    }

    /// Whether a particle of the row needs what others have, or one of its bins owes something.
    KOKKOS_FORCEINLINE_FUNCTION bool lacks(const Row<D>& row) const {
      bool some = false;
      point.particles.for_all(row, [&](const auto& p) BRISANCE_INLINE {
        const auto rest = margin(p);
        some = some || any(rest < std::decay_t<decltype(rest)>(0));
      });
      if (owed.extent(0) > 0)
        for (int bin = row.begin; bin < row.end; ++bin) some = some || owed(bin) > 0;
      return some;
    }

    /// In proportion to what they can spare. What they cannot is owed to the bin, for the next
    /// group or step that can: light gas beside heavy products lacks more than all of it holds.
    KOKKOS_INLINE_FUNCTION void share(const Row<D>& row) const {
      const Particles<G>& points = point.particles;
      std::int64_t held = 0;
      points.for_tiles(row, 1, [&](const Tile& tile) {
        Wide lacking, spare;
        tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
          const Wide amount = points.get(points.mass, b) * margin(b);
          lacking -= least(amount, 0);
          spare += most(amount, 0);
        });
        if (any(lacking > spare))
          for (int lane = 0; lane < Wide::lanes; ++lane) held += lacking[lane] > spare[lane];
        if (owed.extent(0) > 0) {
          lacking += tile.gather([&](int bin) { return owed(bin); });
          const Wide rest = most(lacking - spare, 0);
          tile.for_lanes([&](int lane, int bin) { owed(bin) = rest[lane]; });
        }
        const Wide given = select(
            lacking > spare, Wide(1),
            select(lacking > Wide(0), lacking, Wide(0)) / select(spare > Wide(0), spare, Wide(1)));
        tile.for_bundles([&](const auto& b) BRISANCE_INLINE {
          points.put(points.history, b, 0,
                     0.2 * points.get(points.history, b) + most(margin(b), 0) * (1 - given));
        });
      });
      if (held > 0) Kokkos::atomic_add(&floors(), held);
    }
  };
};

}  // namespace brisance
