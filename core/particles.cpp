#include "core/particles.hpp"

#include <algorithm>

#include "core/geometry.hpp"

namespace brisance {
namespace {

/// From one column to the next, in doubles: columns that start at the same place of a memory page
/// would push each other out of the cache.
std::size_t stride_of(int places) {
  constexpr std::size_t page = 512, apart = 216;
  const auto n = static_cast<std::size_t>(places);
  return n < 8 * page ? n : (n + page - 1) / page * page + apart;
}

/// Three lines of a lattice of 120, as a part of all.
constexpr int usual_margin = 40;

Table<double> no_column(int components) { return Table<double>("none", 0, components); }

}  // namespace

template <class G>
Particles<G>::Particles(int capacity, const ColumnNeeds& needs)
    : position(no_column(D)),
      velocity(no_column(D)),
      mass(no_column(1)),
      volume(no_column(1)),
      stress(no_column(needs.stress == Stress::pressure ? 1 : G::stress_components)),
      history(no_column(needs.history)),
      gradient{no_column(D * D)},
      work{no_column(0)},
      acts_apart(needs.half_stress) {
  if (acts_apart) acting = no_column(static_cast<int>(stress.extent(1)));
  if (needs.affine) affine = no_column(D * D);
  if (needs.extent) extent = no_column(D);
  if (needs.compression) compression = no_column(1);
  scratch = no_column(needs.relaxation ? 3 : needs.stress_relaxation ? 4 : 0);
  passing_ = no_column(D * D + (needs.work ? 1 : 0));
  by_row_ = kernels_on_host && !needs.passing_lasts;
  each_column([&](const char*, const Table<double>& column, bool carried) {
    if (carried) carried_ += static_cast<int>(column.extent(1));
  });
  ++carried_;  // ids
  store_ = Table<double>("particles", 0, carried_ + 1);
  reserve(capacity);
}

template <class G>
void Particles<G>::reserve(int needed) {
  if (needed > capacity_) {
    capacity_ = std::max(needed, capacity_ + capacity_ / 4);
    margin_ = std::max(margin_, capacity_ / usual_margin);
    Kokkos::resize(store_, stride_of(capacity_ + margin_), carried_ + 1);
    each_column([&](const char* name, Table<double>& column, bool carried) {
      if (!carried) column = Table<double>(std::string(name), capacity_, column.extent(1));
    });
    Kokkos::resize(bin, capacity_);
  }
  lay_out();
}

template <class G>
void Particles<G>::make_margin(int needed) {
  if (margin_ >= needed) return;
  margin_ = needed + needed / 4;
  Kokkos::resize(store_, stride_of(capacity_ + margin_), carried_ + 1);
  lay_out();
}

template <class G>
void Particles<G>::slide(int places) {
  offset_ += places;
  lay_out();
}

template <class G>
void Particles<G>::make_room_for_row(int particles) {
  const int needed = particles + Wide::lanes;  // a bundle that is not full is read as one that is
  if (!by_row_ || needed <= row_room_) return;
  constexpr int line = 8;  // no two threads write to one
  row_room_ = (needed + needed / 4 + line - 1) / line * line + line;
  const int threads = Kokkos::Experimental::UniqueToken<Space>().size();
  passing_ = Table<double>("passing", row_room_ * threads, passing_.extent(1));
  lay_out();
}

template <class G>
Particles<G> Particles<G>::none() const {
  Particles<G> others = *this;
  others.store_ = Table<double>("particles", 0, carried_ + 1);
  others.each_column([&](const char*, Table<double>& column, bool) {
    column = no_column(static_cast<int>(column.extent(1)));
  });
  others.passing_ = no_column(static_cast<int>(passing_.extent(1)));
  others.row_room_ = 0;
  others.first = {};
  others.order = {};
  others.bin = {};
  others.count = others.capacity_ = others.margin_ = others.offset_ = 0;
  others.lay_out();
  return others;
}

template <class G>
void Particles<G>::lay_out() {
  int next = shifted_ ? 1 : 0;
  each_column([&](const char*, Table<double>& column, bool carried) {
    if (!carried) return;
    const int end = next + static_cast<int>(column.extent(1));
    column = Kokkos::subview(store_, Kokkos::make_pair(offset_, offset_ + capacity_),
                             Kokkos::make_pair(next, end));
    next = end;
  });
  static_assert(sizeof(std::int64_t) == sizeof(double));
  id = Array<std::int64_t>(reinterpret_cast<std::int64_t*>(slot(next, offset_).data()), capacity_);
  if (!acts_apart) acting = stress;
  const auto passing = [&](int from, int to) {
    return Passing{Kokkos::subview(passing_, Kokkos::ALL, Kokkos::make_pair(from, to))};
  };
  gradient = passing(0, D * D);
  work = passing(D * D, static_cast<int>(passing_.extent(1)));
}

template struct Particles<Line>;
template struct Particles<PlaneStrain>;

}  // namespace brisance
