// What is settled before a wave: which groups go, which way, in which chunks, and what these put
// aside.
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

/// Into chunks of about as many particles.
template <class G>
void Wave<G>::cut(const std::vector<std::unique_ptr<Group<G>>>& groups, int wanted) {
  wanted = std::min(wanted, std::max(1, lines / least_lines));
  std::int64_t total = 0, so_far = 0;
  for (const auto& g : groups) total += g->particles.count;
  chunks.clear();
  int begin = 0;
  for (int l = 0; l < lines; ++l) {
    for (const auto& g : groups)
      so_far += g->particles.first((l + 1) * line) - g->particles.first(l * line);
    const int made = static_cast<int>(chunks.size()) + 1;
    const bool enough = so_far * wanted >= total * made;
    const int end = l + 1;
    if (end == lines ||
        (made < wanted && enough && end - begin >= least_lines && lines - end >= least_lines)) {
      chunks.push_back({begin, end, false, false, 0});
      begin = end;
    }
  }
  (up ? chunks.front() : chunks.back()).first = true;
  (up ? chunks.back() : chunks.front()).last = true;
}

/// What chunks ahead overwrite.
template <class G>
void Wave<G>::find_tails() {
  for (Chunk& c : chunks) c.tail_from = c.size();
  for (Stream<G>& s : streams) {
    if (!s.taken) continue;
    s.parts.resize(chunks.size());
    int rows = 0;
    for (std::size_t k = 0; k < chunks.size(); ++k) {
      Chunk& c = chunks[k];
      Part& part = s.parts[k];
      part.tail_from = c.size();
      part.tail = part.wrapped = {};
      const auto particles_of = [&](int from, int to) {  // lines
        return Aside{first_of(s, std::min(from, to)), first_of(s, std::max(from, to) + 1), rows};
      };
      if (!c.last) {
        const int edge = s.shift + (up ? first_of(s, c.end - 1) - s.wrapping
                                       : first_of(s, c.begin + 1) + s.wrapping);
        const int lowest = c.first ? 0 : -1;
        int& from = part.tail_from;
        while (from > lowest) {
          const int l = line_at(c, from - 1);
          if (up ? first_of(s, l + 1) <= edge : first_of(s, l) >= edge) break;
          --from;
        }
        part.tail = particles_of(line_at(c, from), line_at(c, c.size()));
        rows += part.tail.size();
        c.tail_from = std::min(c.tail_from, std::max(from, 0));
      } else if (wraps) {
        part.wrapped = particles_of(line_of_all(0), line_of_all(lines_that_wrap - 1));
        rows += part.wrapped.size();
      }
    }
    s.columns.clear();
    s.particles().each_slot([&](const Array<double>& column, const Array<double>&) {
      s.columns.push_back(column.data());
    });
    if (static_cast<int>(s.aside.extent(0)) < rows)
      s.aside = Table<double>("put aside", rows + rows / 4, s.columns.size());
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

#define BRISANCE_WAVE(G)                                                                      \
  template bool Wave<G>::choose(const std::vector<std::unique_ptr<Group<G>>>&, bool, double); \
  template void Wave<G>::cut(const std::vector<std::unique_ptr<Group<G>>>&, int);             \
  template void Wave<G>::find_tails();
BRISANCE_WAVE(Line)
BRISANCE_WAVE(PlaneStrain)
#undef BRISANCE_WAVE

}  // namespace brisance
