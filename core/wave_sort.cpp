// How a wave sorts the particles of lines.
#include <algorithm>

#include "core/geometry.hpp"
#include "core/lay_tiles.hpp"
#include "core/wave.hpp"

namespace brisance {
namespace {

/// Of some columns: place i + offset of `to` <- place source(i).
template <int columns>
void gather(const double* const* from, double* const* to, int offset, const int* source, int size) {
  int i = 0;
  for (; i + Wide::lanes <= size; i += Wide::lanes) {
    int at[Wide::lanes];
    for (int lane = 0; lane < Wide::lanes; ++lane) at[lane] = source[i + lane];
    for (int k = 0; k < columns; ++k) Wide::gather(from[k], at).write(to[k] + offset + i);
  }
  for (; i < size; ++i)
    for (int k = 0; k < columns; ++k) to[k][offset + i] = from[k][source[i]];
}

}  // namespace

template <class G>
void Wave<G>::work_on(const Sweep<D>& sweep, const Chunk& c, int j, int thread) const {
  const int l = line_at(c, j);
  for (int k = 0; k < layout.pieces; ++k) {
    Row<D> row = layout.row(l * layout.pieces + k);
    row.thread = thread;
    row.owned_end = std::min(row.owned_end, c.end * line);
    sweep.work_on(row);
  }
}

/// What others need before they begin.
template <class G>
void Wave<G>::prepare(const Sweep<D>& sweep, int chunk, int thread) {
  const Chunk& c = chunks[chunk];
  for (int j = 0; j < c.size(); ++j)
    if (worked_on_before(c, j)) work_on(sweep, c, j, thread);
  if (!wraps || !c.first) return;
  for (Stream<G>& s : streams)
    if (s.taken)
      for (std::size_t k = 0; k < s.columns.size(); ++k)
        std::copy(s.columns[k] + s.wraps.begin, s.columns[k] + s.wraps.end, &s.wrapped(0, k));
}

/// Particles of a line to the bins that they come into, in the order in which they are or, where
/// the wave runs down, from the last on.
template <class G>
void Wave<G>::append(Stream<G>& s, Part& part, int l, const Bins& to) const {
  const int* const bin = s.particles().bin.data();
  int *const next = s.next.data(), *const coming = part.coming.data();
  const int begin = first_of(s, l), end = first_of(s, l + 1);
  const int in_plane = bins_in_plane(), planes = s.planes;
  const auto one = [&](int p) {
    const int b = bin_of(bin[p], l);
    if (!to.holds(b)) return;
    const int k = next[b]++;
    if (k < planes) coming[k * in_plane + (b & (in_plane - 1))] = p;
  };
  if (up)
    for (int p = begin; p < end; ++p) one(p);
  else
    for (int p = end - 1; p >= begin; --p) one(p);
}

/// Calls f(line) for those from which particles may come into a line, in the order of particles.
template <class G>
template <class F>
void Wave<G>::for_sources(int l, const F& f) const {
  if (comes_around(l) && l >= lines - lines_that_wrap)
    for (int k = 0; k < lines_that_wrap; ++k) f(k);
  for (int k = std::max(l - 1, 0); k <= std::min(l + 1, lines - 1); ++k) f(k);
  if (comes_around(l) && l < lines_that_wrap)
    for (int k = lines - lines_that_wrap; k < lines; ++k) f(k);
}

/// How many particles the fullest bin of a line gets; finds their numbers anew where some come
/// around from the other end.
template <class G>
int Wave<G>::count(Stream<G>& s, int l) const {
  const Bins here{l * line, (l + 1) * line};
  int* const next = s.next.data();
  if (comes_around(l)) {
    std::fill(next + here.begin, next + here.end, 0);
    for_sources(l, [&](int from) {
      for (int p = first_of(s, from); p < first_of(s, from + 1); ++p) {
        const int b = bin_of(s.particles().bin(p), from);
        if (here.holds(b)) ++next[b];
      }
    });
  }
  int fullest = 0;
  for (int b = here.begin; b < here.end; ++b) fullest = std::max(fullest, next[b]);
  return fullest;
}

/// Where the bins of a line begin; forgets how many came.
template <class G>
void Wave<G>::close(Stream<G>& s, Part& part, const Chunk& c, int l) const {
  int *const next = s.next.data(), *const first = s.first.data();
  const int begin = l * line, end = begin + line;
  int place = part.offset;
  if (!up) {
    for (int b = begin; b < end; ++b) place -= next[b];
    part.offset = place;
  }
  // The chunks have begun with the places of their first bins: others may read these.
  if (begin > c.begin * line) first[begin] = place;
  for (int b = begin; b < end - 1; ++b) first[b + 1] = place += next[b];
  place += next[end - 1];
  if (up) {
    if (end < c.end * line) first[end] = place;
    part.offset = place;
  }
  std::fill(next + begin, next + end, 0);
}

/// The particles of a line, bin by bin, found among all that may come.
template <class G>
void Wave<G>::sort_line(Stream<G>& s, Part& part, int l) const {
  const Bins here{l * line, (l + 1) * line};
  const int begin = s.first(here.begin);
  part.sorted.resize(s.first(here.end) - begin);
  int* const next = s.next.data();
  for_sources(l, [&](int from) {
    for (int p = first_of(s, from); p < first_of(s, from + 1); ++p) {
      const int b = bin_of(s.particles().bin(p), from);
      if (here.holds(b)) part.sorted[s.first(b) - begin + next[b]++] = p;
    }
  });
  std::fill(next + here.begin, next + here.end, 0);
}

/// tiled <- the particles of a row in the order of tiles, from those that have come into its bins.
template <class G>
void Wave<G>::lay_in_tiles(const Stream<G>& s, Part& part, const Row<D>& row) const {
  const int in_plane = bins_in_plane(), all = in_plane * s.planes - 1;
  const int* const coming = part.coming.data();
  int* to = part.tiled.data();
  int number = row.number * Row<D>::tiles;
  for (int bin = row.begin; bin < row.end; bin += Wide::lanes, ++number) {
    const TileCounts counts(s.first, bin, row.end);
    s.particles().order(number) = counts.order;
    int of_lane[Wide::lanes], from[Wide::lanes];
    for (int lane = 0; lane < Wide::lanes; ++lane) {
      const int b = counts.order[lane];
      of_lane[lane] = counts.of_bin[b];
      from[lane] = ((bin + b) & (in_plane - 1)) + (up ? 0 : (of_lane[lane] - 1) * in_plane);
    }
    // Eight each time: those of lanes without a particle are overwritten by the next.
    for (int k = 0; k < of_lane[0]; ++k) {
      int present = 0;
      for (int lane = 0; lane < Wide::lanes; ++lane) {
        to[lane] = coming[from[lane] & all];
        from[lane] += up ? in_plane : -in_plane;
        present += of_lane[lane] > k;
      }
      to += present;
    }
  }
}

/// Whether places are where the chunk behind, or the line before that it needs, is still read.
template <class G>
bool Wave<G>::holds_back(const Stream<G>& s, const Chunk& c, int begin, int end) const {
  if (c.first) return false;
  return up ? begin + s.shift < first_of(s, c.begin + 1) : end + s.shift > first_of(s, c.end - 1);
}

template <class G>
void Wave<G>::permute(const Stream<G>& s, Part& part, const Chunk& c, int begin, int end,
                      bool wrapped) const {
  const int *const source = part.tiled.data(), size = end - begin;
  const int columns = static_cast<int>(s.columns.size());
  double* const* to = s.columns.data();
  int offset = s.shift + begin;
  if (holds_back(s, c, begin, end)) {
    part.held_first = std::min(part.held_first, begin);
    part.held_end = std::max(part.held_end, end);
    to = s.held_columns.data();
    offset = part.held(begin);
  }
  if (wrapped) {
    for (int k = 0; k < columns; ++k)
      for (int i = 0; i < size; ++i) {
        const int p = source[i];
        to[k][offset + i] = s.wraps.holds(p) ? s.wrapped(s.wraps(p), k) : s.columns[k][p];
      }
    return;
  }
  // Four columns at once ask a quarter as often where their particles come from.
  const double* const* from = s.columns.data();
  int left = columns;
  for (; left >= 4; left -= 4, from += 4, to += 4) gather<4>(from, to, offset, source, size);
  if (left == 3) gather<3>(from, to, offset, source, size);
  if (left == 2) gather<2>(from, to, offset, source, size);
  if (left == 1) gather<1>(from, to, offset, source, size);
}

/// Particles of a line to their new places.
template <class G>
void Wave<G>::lay(Stream<G>& s, Part& part, const Chunk& c, int j) const {
  const bool wrapped = wraps && c.last && j >= c.size() - lines_that_wrap;
  const int l = line_at(c, j);
  const bool crowded = count(s, l) > s.planes || comes_around(l);
  close(s, part, c, l);
  if (crowded) sort_line(s, part, l);
  const int line_begin = s.first(l * line);
  for (int k = 0; k < layout.pieces; ++k) {
    const Row<D> row = layout.row(l * layout.pieces + k);
    const int begin = s.first(row.begin), size = s.first(row.end) - begin;
    if (size == 0) continue;
    if (crowded)
      lay_tiles(
          row, s.first, s.particles().order,
          [&](int place) { return part.sorted[place - line_begin]; },
          [&](int place, int source) { part.tiled[place - begin] = source; });
    else
      lay_in_tiles(s, part, row);
    int differs = 0;
    for (int i = 0; i < size; ++i) differs |= part.tiled[i] ^ (begin + i);
    if (differs != 0) {
      part.first_moved = std::min(part.first_moved, begin);
      part.last_moved = std::max(part.last_moved, begin + size - 1);
    }
    part.fullest = std::max(part.fullest, size);
    permute(s, part, c, begin, begin + size, wrapped);
  }
  // A bin that no shape asks for holds those that have left.
  part.left += s.first((l + 1) * line) - s.first((l + 1) * line - 1);
}

template <class G>
void Wave<G>::roll(const Sweep<D>& sweep, int chunk, int thread) {
  const Chunk& c = chunks[chunk];
  for (auto& s : streams)
    if (s.taken) s.parts[chunk].offset = s.first((up ? c.begin : c.end) * line);
  for (int j = c.first ? 0 : -1; j <= c.size(); ++j) {
    if (j >= 0 && j < c.size() && !worked_on_before(c, j)) work_on(sweep, c, j, thread);
    for (auto& s : streams) {
      if (!s.taken) continue;
      Part& part = s.parts[chunk];
      const int l = line_at(c, j);
      if (j < c.size() || !c.last) append(s, part, l, near(c, l));
      if (j > 0) lay(s, part, c, j - 1);
    }
  }
}

template <class G>
void Wave<G>::put_back(const Stream<G>& s, const Part& part) const {
  for (std::size_t k = 0; k < s.columns.size() && part.held_first < part.held_end; ++k) {
    const double* const from = s.held_columns[k];
    std::copy(from + part.held(part.held_first), from + part.held(part.held_end),
              s.columns[k] + s.shift + part.held_first);
  }
}

#define BRISANCE_WAVE(G)                                          \
  template void Wave<G>::prepare(const Sweep<G::dim>&, int, int); \
  template void Wave<G>::roll(const Sweep<G::dim>&, int, int);    \
  template void Wave<G>::put_back(const Stream<G>&, const Part&) const;
BRISANCE_WAVE(Line)
BRISANCE_WAVE(PlaneStrain)
#undef BRISANCE_WAVE

}  // namespace brisance
