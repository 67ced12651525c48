// What is settled before a wave: which groups go, which way, in which chunks, where these begin,
// and what they hold back.
#include <algorithm>

#include "core/geometry.hpp"
#include "core/wave.hpp"

namespace brisance {
namespace {

constexpr int least_lines = 16;  ///< of a chunk

}  // namespace

/// How many particles may cross a periodic end, at most, in one direction.
template <class G>
int Wave<G>::how_many_wrap(const Stream<G>& s, double farthest) const {
  const Particles<G>& points = s.particles();
  const Lattice<D>& lattice = layout.lattice;
  const double low = lattice.origin[D - 1], high = low + lattice.cells[D - 1] * lattice.h;
  const auto count = [&](int from, int to) {
    int sum = 0;
    for (int p = first_of(s, from); p < first_of(s, to); ++p) {
      const double x = points.position(p, D - 1);
      sum += x < low + 1.001 * farthest || x > high - 1.001 * farthest;
    }
    return sum;
  };
  return std::max(count(0, lines_that_wrap), count(lines - lines_that_wrap, lines));
}

/// Which streams go, and which way.
template <class G>
bool Wave<G>::choose(const std::vector<std::unique_ptr<Group<G>>>& groups, bool wraps_,
                     double farthest) {
  wraps = wraps_;
  streams.resize(groups.size());
  const Group<G>* largest = nullptr;
  std::vector<int> shifts(groups.size());
  for (std::size_t k = 0; k < groups.size(); ++k) {
    Stream<G>& s = streams[k];
    s.group = groups[k].get();
    Particles<G>& particles = s.particles();
    s.taken = s.group->in_motion && particles.count > 0;
    if (!s.taken) continue;
    s.wrapping = wraps ? how_many_wrap(s, farthest) : 0;
    shifts[k] = fullest(s, 3) + s.wrapping;
    s.taken = shifts[k] < particles.count / 8;  // else there are too few lines
    if (!s.taken) continue;
    particles.make_margin(shifts[k]);
    if (largest == nullptr || particles.count > largest->particles.count) {
      largest = s.group;
      up = particles.room_below() >= shifts[k];
    }
  }
  for (std::size_t k = 0; k < groups.size(); ++k) {
    Stream<G>& s = streams[k];
    const int room = up ? s.particles().room_below() : s.particles().room_above();
    s.taken = s.taken && room >= shifts[k];
    // Up by an eighth more, if there is room, since the next wave, down again, may need more. If it
    // needs more than that, an ordinary sort brings all to the beginning of their margins.
    s.shift = up ? -room : std::min(room, shifts[k] + shifts[k] / 8);
  }
  return std::any_of(streams.begin(), streams.end(), [](const auto& s) { return s.taken; });
}

/// Into chunks for threads, of which each finds smaller ones last: who is through helps others with
/// these.
template <class G>
void Wave<G>::cut(const std::vector<std::unique_ptr<Group<G>>>& groups, int threads,
                  int for_each_thread) {
  const int of_thread = std::clamp(lines / (least_lines * threads), 1, for_each_thread),
            wanted = std::min(threads * of_thread, std::max(1, lines / least_lines));
  const auto share = [&](int made) {  // of all particles
    const int k = made % of_thread, left = of_thread - k;
    const double rest = static_cast<double>(left * (left + 1)) / (of_thread * (of_thread + 1));
    return (made / of_thread + 1 - rest) * of_thread / wanted;
  };
  std::int64_t total = 0, so_far = 0;
  for (const auto& g : groups) total += g->particles.count;
  chunks.clear();
  int begin = 0;
  for (int l = 0; l < lines; ++l) {
    for (const auto& g : groups)
      so_far += g->particles.first((l + 1) * line) - g->particles.first(l * line);
    const int made = static_cast<int>(chunks.size()) + 1;
    const bool enough = static_cast<double>(so_far) >= static_cast<double>(total) * share(made);
    const int end = l + 1;
    if (end == lines ||
        (made < wanted && enough && end - begin >= least_lines && lines - end >= least_lines)) {
      chunks.push_back({begin, end, false, false});
      begin = end;
    }
  }
  (up ? chunks.front() : chunks.back()).first = true;
  (up ? chunks.back() : chunks.front()).last = true;
}

template <class G>
void Wave<G>::make_room() {
  for (Stream<G>& s : streams) {
    if (!s.taken) continue;
    s.parts.resize(chunks.size());
    s.columns.clear();
    s.particles().each_slot([&](const Array<double>& column, const Array<double>&) {
      s.columns.push_back(column.data());
    });
    s.wraps = {};
    if (wraps) {
      const int a = line_of_all(0), b = line_of_all(lines_that_wrap - 1);
      s.wraps = {first_of(s, std::min(a, b)), first_of(s, std::max(a, b) + 1), 0};
      if (static_cast<int>(s.wrapped.extent(0)) < s.wraps.size())
        s.wrapped = Table<double>("come around", s.wraps.size(), s.columns.size());
    }
    const int per_bin = fullest(s, 1) / layout.lattice.cells[0] + 1;
    s.planes = 16;
    while (s.planes < 2 * per_bin + 8) s.planes *= 2;
    const int bins = layout.lattice.size;
    if (static_cast<int>(s.next.extent(0)) != bins) {
      s.next = Array<int>("places of particles", bins);
      s.first = Array<int>("first of bin", bins + 2);
    }
  }
}

/// Of the particles of a line, those whose new bins are among some.
template <class G>
int Wave<G>::how_many(const Stream<G>& s, int l, const Bins& to) const {
  const int* const bin = s.particles().bin.data();
  int sum = 0;
  for (int p = first_of(s, l); p < first_of(s, l + 1); ++p) sum += to.holds(bin[p]);
  return sum;
}

/// How many more particles there are below a line than before.
template <class G>
int Wave<G>::flow(const Stream<G>& s, int border) const {
  const int here = border * line;
  int sum = how_many(s, border, {here - line, here}) - how_many(s, border - 1, {here, here + line});
  if (wraps)
    for (int g = 0; g < lines_that_wrap; ++g)
      sum += how_many(s, lines - 1 - g, {0, lines_that_wrap * line}) -
             how_many(s, g, {(lines - lines_that_wrap) * line, lines * line});
  return sum;
}

template <class G>
void Wave<G>::place_chunks() {
  for (Stream<G>& s : streams) {
    if (!s.taken) continue;
    for (const Chunk& c : chunks)
      s.first(c.begin * line) = c.begin == 0 ? 0 : first_of(s, c.begin) + flow(s, c.begin);
    s.first(lines * line) = s.first(lines * line + 1) = s.particles().count;
    const int longest_row = fullest(s, 1);
    int rows = 0;
    for (std::size_t k = 0; k < chunks.size(); ++k) {
      const Chunk& c = chunks[k];
      Part& part = s.parts[k];
      part.fullest = part.left = 0;
      part.first_moved = s.particles().count;
      part.last_moved = -1;
      part.coming.resize(static_cast<std::size_t>(s.planes) * bins_in_plane());
      part.tiled.resize(2 * std::abs(s.shift) + Wide::lanes);  // the last eight may reach over
      const int begin = s.first(c.begin * line), end = s.first(c.end * line);
      part.held = {begin, begin, rows};
      part.held_first = end;
      part.held_end = begin;
      if (!c.first) {
        const int edge = first_of(s, up ? c.begin + 1 : c.end - 1) - s.shift;
        part.held = {up ? begin : std::clamp(edge - longest_row, begin, end),
                     up ? std::clamp(edge + longest_row, begin, end) : end, rows};
      }
      rows += part.held.size();
    }
    if (static_cast<int>(s.held.extent(0)) < rows)
      s.held = Table<double>("held back", rows + rows / 4, s.columns.size());
    s.held_columns.clear();
    for (std::size_t k = 0; k < s.columns.size() && rows > 0; ++k)
      s.held_columns.push_back(&s.held(0, k));
  }
}

#define BRISANCE_WAVE(G)                                                                      \
  template bool Wave<G>::choose(const std::vector<std::unique_ptr<Group<G>>>&, bool, double); \
  template void Wave<G>::cut(const std::vector<std::unique_ptr<Group<G>>>&, int, int);        \
  template void Wave<G>::make_room();                                                         \
  template void Wave<G>::place_chunks();
BRISANCE_WAVE(Line)
BRISANCE_WAVE(PlaneStrain)
#undef BRISANCE_WAVE

}  // namespace brisance
