#include "core/wavefront.hpp"

#include <algorithm>
#include <utility>

#include "core/geometry.hpp"
#include "core/wave.hpp"

namespace brisance {
namespace {

constexpr int chunks_per_thread = 2;

/// None where no wave has looked at the group yet.
template <class G>
const Stream<G>* stream_of(const Wave<G>* wave, const Group<G>& group) {
  if (wave == nullptr) return nullptr;
  for (const auto& s : wave->streams)
    if (s.group == &group) return &s;
  return nullptr;
}

}  // namespace

template <class G>
Wavefront<G>::Wavefront(int chunks) : chunks_(chunks) {}
template <class G>
Wavefront<G>::~Wavefront() = default;
template <class G>
Wavefront<G>::Wavefront(Wavefront&&) noexcept = default;
template <class G>
Wavefront<G>& Wavefront<G>::operator=(Wavefront&&) noexcept = default;

template <class G>
bool Wavefront<G>::takes(const std::vector<std::unique_ptr<Group<G>>>& groups,
                         const Lattice<D>& lattice, const Boundaries<D>& boundaries,
                         double farthest) {
  if constexpr (D == 1 || !kernels_on_host) return false;
  if (wave_ == nullptr) wave_ = std::make_unique<Wave<G>>(lattice);
  for (Stream<G>& s : wave_->streams) s.taken = false;
  if (!(farthest < 0.999 * lattice.h)) return false;
  if (!wave_->choose(groups, boundaries.side[D - 1][0] == Side::periodic, farthest)) return false;
  const int threads = Space().concurrency();
  const int chunks = chunks_ > 0 ? chunks_ : threads == 1 ? 1 : chunks_per_thread * threads;
  wave_->cut(groups, chunks);
  if (chunks_ == 0 && static_cast<int>(wave_->chunks.size()) < threads) {
    for (Stream<G>& s : wave_->streams) s.taken = false;
    return false;
  }
  wave_->find_tails();
  return true;
}

template <class G>
void Wavefront<G>::run(Sweep<D>& sweep) {
  Wave<G>& w = *wave_;
  const int chunks = static_cast<int>(w.chunks.size());
  const std::string name = sweep.name();
  using Each = Kokkos::RangePolicy<Space, Kokkos::Schedule<Kokkos::Dynamic>>;
  const Kokkos::Experimental::UniqueToken<Space> threads;
  const auto for_chunks = [&](const std::string& called, const auto& f) {
    Kokkos::parallel_for(called, Each(0, chunks).set_chunk_size(1), [&, threads](const int k) {
      const int thread = threads.acquire();
      f(k, thread);
      threads.release(thread);
    });
  };
  for_chunks(name, [&](int k, int thread) {
    const Chunk& c = w.chunks[k];
    for (int j = 0; j < c.size(); ++j)
      if (w.worked_on_before(c, j)) w.work_on(sweep, c, j, thread);
  });
  for_chunks("put ends of chunks aside", [&](int k, int) {
    for (auto& s : w.streams)
      if (s.taken) w.prepare(s, k);
  });
  for_chunks(name + " (2)", [&](int k, int thread) { w.roll(sweep, k, thread); });
  sweep.forget();

  for (auto& s : w.streams) {
    if (!s.taken) continue;
    Particles<G>& particles = s.particles();
    int first_moved = particles.count, last_moved = -1, fullest = 0, left = 0;
    for (const Part& part : s.parts) {
      first_moved = std::min(first_moved, part.first_moved);
      last_moved = std::max(last_moved, part.last_moved);
      fullest = std::max(fullest, part.fullest);
      left += part.left;
    }
    s.any_left = left > 0;
    s.most_moved = last_moved + 1 - first_moved > particles.count / 2;
    std::swap(particles.first, s.first);
    particles.slide(s.shift);
    particles.make_room_for_row(fullest);
  }
}

template <class G>
bool Wavefront<G>::sorted(const Group<G>& group) const {
  const auto* s = stream_of(wave_.get(), group);
  return s != nullptr && s->taken;
}
template <class G>
bool Wavefront<G>::most_moved(const Group<G>& group) const {
  const auto* s = stream_of(wave_.get(), group);
  return s != nullptr && s->most_moved;
}
template <class G>
bool Wavefront<G>::any_left(const Group<G>& group) const {
  const auto* s = stream_of(wave_.get(), group);
  return s != nullptr && s->any_left;
}

template <class G>
std::size_t Wavefront<G>::bytes() const {
  if (wave_ == nullptr) return 0;
  std::size_t sum = 0;
  for (const auto& s : wave_->streams)
    sum += (s.first.span() + s.next.span()) * sizeof(int) + s.aside.span() * sizeof(double);
  return sum;
}

template class Wavefront<Line>;
template class Wavefront<PlaneStrain>;

}  // namespace brisance
