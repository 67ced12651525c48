#include "core/wavefront.hpp"

#include <algorithm>
#include <utility>

#include "core/geometry.hpp"
#include "core/turns.hpp"
#include "core/wave.hpp"

namespace brisance {
namespace {

constexpr int chunks_per_thread = 3;

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
  if (chunks_ > 0)
    wave_->cut(groups, chunks_, 1);
  else
    wave_->cut(groups, threads, threads > 1 ? chunks_per_thread : 1);
  if (chunks_ == 0 && static_cast<int>(wave_->chunks.size()) < threads) {
    for (Stream<G>& s : wave_->streams) s.taken = false;
    return false;
  }
  wave_->make_room();
  return true;
}

template <class G>
void Wavefront<G>::run(Sweep<D>& sweep) {
  Wave<G>& w = *wave_;
  const std::string name = sweep.name();
  const auto for_chunks = [&](const std::string& called, const auto& f) {
    in_turns(called, static_cast<int>(w.chunks.size()), false, f);
  };
  for_chunks(name, [&](int k, int thread) { w.prepare(sweep, k, thread); });
  w.place_chunks();
  for_chunks(name + " (2)", [&](int k, int thread) { w.roll(sweep, k, thread); });
  for_chunks("put back", [&](int k, int) {
    for (const auto& s : w.streams)
      if (s.taken) w.put_back(s, s.parts[k]);
  });
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
  for (const auto& s : wave_->streams) {
    sum += (s.first.span() + s.next.span()) * sizeof(int) +
           (s.wrapped.span() + s.held.span()) * sizeof(double);
    for (const Part& part : s.parts)
      sum +=
          (part.coming.capacity() + part.sorted.capacity() + part.tiled.capacity()) * sizeof(int);
  }
  return sum;
}

template class Wavefront<Line>;
template class Wavefront<PlaneStrain>;

}  // namespace brisance
