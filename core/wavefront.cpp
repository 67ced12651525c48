#include "core/wavefront.hpp"

#include <algorithm>
#include <utility>

#include "core/geometry.hpp"
#include "core/lay_tiles.hpp"

namespace brisance {
namespace {

/// In so many lines at either end those are looked for that cross a periodic end: of the highest
/// three a particle is in the first at most, and splines meet there with half a line each.
constexpr int lines_that_wrap = 4;
constexpr int least_lines = 16;  ///< of a chunk
constexpr int chunks_per_thread = 2;

/// Particles begin .. end, put aside from a row of a table on.
struct Aside {
  int begin = 0, end = 0, row = 0;
  bool holds(int p) const { return p >= begin && p < end; }
  int operator()(int p) const { return row + p - begin; }
  int size() const { return end - begin; }
};

/// What a chunk knows of a group.
struct Part {
  Aside tail, wrapped;
  int tail_from = 0;  ///< line, counted along the wave
  int offset = 0;     ///< place of the next line
  int first_moved = 0, last_moved = 0, fullest = 0, left = 0;
  std::vector<int> coming;  ///< plane k: the k-th that comes into each bin, modulo a power of two
  std::vector<int> sorted;  ///< of a line, bin by bin
  std::vector<int> tiled;   ///< of a row
};

template <class G>
struct Stream {
  Group<G>* group = nullptr;
  bool taken = false;
  int shift = 0;  ///< of the memory in which particles are written to that in which they are read
  int wrapping = 0;  ///< how many particles may cross a periodic end
  Array<int> first;  ///< of each bin, in the new order
  Array<int> next;   ///< of each bin: how many have come; zeros before and after a wave
  int planes = 0;    ///< how many are kept of those that come into a bin
  Table<double> aside;
  std::vector<double*> columns;
  std::vector<Part> parts;  ///< of chunks
  bool most_moved = false, any_left = false;

  Particles<G>& particles() const { return group->particles; }
};

/// Of some columns: place i + shift <- place source(i).
template <int columns>
void gather(const double* const* from, int shift, const int* source, int size) {
  int i = 0;
  for (; i + Wide::lanes <= size; i += Wide::lanes) {
    int at[Wide::lanes];
    for (int lane = 0; lane < Wide::lanes; ++lane) at[lane] = source[i + lane];
    for (int k = 0; k < columns; ++k)
      Wide::gather(from[k], at).write(const_cast<double*>(from[k]) + shift + i);
  }
  for (; i < size; ++i)
    for (int k = 0; k < columns; ++k) const_cast<double*>(from[k])[shift + i] = from[k][source[i]];
}

/// Lines of bins.
struct Chunk {
  int begin, end;
  bool first, last;  ///< of the wave
  int tail_from;     ///< the first line along the wave that is worked on before
  int size() const { return end - begin; }
};

}  // namespace

template <class G>
struct Wavefront<G>::Wave {
  RowLayout<D> layout;
  int lines = 0, line = 0;  ///< lines, and bins in each
  bool up = false;          ///< whether the wave runs to lines of higher numbers
  bool wraps = false;
  std::vector<Stream<G>> streams;
  std::vector<Chunk> chunks;

  explicit Wave(const Lattice<D>& lattice)
      : layout(lattice), lines(lattice.size / layout.line), line(layout.line) {}

  int first_of(const Stream<G>& s, int l) const { return s.particles().first(l * line); }
  /// How many particles so many lines hold at most.
  int fullest(const Stream<G>& s, int neighbours) const {
    int most = 0;
    for (int l = 0; l + neighbours <= lines; ++l)
      most = std::max(most, first_of(s, l + neighbours) - first_of(s, l));
    return most;
  }

  bool choose(const std::vector<std::unique_ptr<Group<G>>>& groups, bool wraps_, double farthest);
  int how_many_wrap(const Stream<G>& s, double farthest) const;
  void cut(const std::vector<std::unique_ptr<Group<G>>>& groups, int wanted);
  void find_tails();

  // Of a chunk; j counts its lines along the wave.

  int line_at(const Chunk& c, int j) const { return up ? c.begin + j : c.end - 1 - j; }
  /// The g-th line of all along the wave.
  int line_of_all(int g) const { return up ? g : lines - 1 - g; }
  bool worked_on_before(const Chunk& c, int j) const {
    return (j == 0 && !c.first) || j >= c.tail_from || (wraps && c.first && j < lines_that_wrap) ||
           (wraps && c.last && j >= c.size() - lines_that_wrap);
  }

  struct Bins {
    int begin, end;
    bool holds(int b) const { return b >= begin && b < end; }
  };
  Bins bins(const Chunk& c) const { return {c.begin * line, c.end * line}; }
  /// Those of a chunk that particles of a line reach without wrapping.
  Bins near(const Chunk& c, int l) const {
    return {std::max(c.begin, l - 1) * line, std::min(c.end, l + 2) * line};
  }
  int bins_in_plane() const {
    int n = 1;
    while (n < 3 * line) n *= 2;
    return n;
  }
  /// Those that have left stay in the line, in a bin that no shape asks for.
  int bin_of(int bin, int l) const { return bin < lines * line ? bin : (l + 1) * line - 1; }

  int how_many(const Stream<G>& s, int l, const Bins& to) const;
  int flow(const Stream<G>& s, int border) const;

  void work_on(const Sweep<D>& sweep, const Chunk& c, int j, int thread) const;
  void prepare(Stream<G>& s, int chunk);
  void put_aside(const Stream<G>& s, const Aside& those) const;
  void append(Stream<G>& s, Part& part, int l, const Bins& to) const;
  bool comes_around(int l) const {
    return wraps && (l < lines_that_wrap || l >= lines - lines_that_wrap);
  }
  template <class F>
  void for_sources(const Stream<G>& s, int l, const F& f) const;
  void sort_line(Stream<G>& s, Part& part, int l) const;
  int count(Stream<G>& s, int l) const;
  void close(Stream<G>& s, Part& part, const Chunk& c, int l) const;
  void lay_in_tiles(const Stream<G>& s, Part& part, const Row<D>& row) const;
  void lay(Stream<G>& s, Part& part, const Chunk& c, int j) const;
  void permute(const Stream<G>& s, const Part& part, int begin, int end, bool looks_aside,
               bool wrapped) const;
  void roll(const Sweep<D>& sweep, int chunk, int thread);
};

/// How many particles may cross a periodic end, at most, in one direction.
template <class G>
int Wavefront<G>::Wave::how_many_wrap(const Stream<G>& s, double farthest) const {
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
bool Wavefront<G>::Wave::choose(const std::vector<std::unique_ptr<Group<G>>>& groups, bool wraps_,
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
    s.shift = up ? -shifts[k] : shifts[k];
  }
  return largest != nullptr;
}

/// Into chunks of about as many particles.
template <class G>
void Wavefront<G>::Wave::cut(const std::vector<std::unique_ptr<Group<G>>>& groups, int wanted) {
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
void Wavefront<G>::Wave::find_tails() {
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

/// Of the particles of a line, those whose new bins are among some.
template <class G>
int Wavefront<G>::Wave::how_many(const Stream<G>& s, int l, const Bins& to) const {
  const int* const bin = s.particles().bin.data();
  int sum = 0;
  for (int p = first_of(s, l); p < first_of(s, l + 1); ++p) sum += to.holds(bin[p]);
  return sum;
}

/// How many more particles there are below a line than before.
template <class G>
int Wavefront<G>::Wave::flow(const Stream<G>& s, int border) const {
  const int here = border * line;
  int sum = how_many(s, border, {here - line, here}) - how_many(s, border - 1, {here, here + line});
  if (wraps)
    for (int g = 0; g < lines_that_wrap; ++g)
      sum += how_many(s, lines - 1 - g, {0, lines_that_wrap * line}) -
             how_many(s, g, {(lines - lines_that_wrap) * line, lines * line});
  return sum;
}

template <class G>
void Wavefront<G>::Wave::work_on(const Sweep<D>& sweep, const Chunk& c, int j, int thread) const {
  const int l = line_at(c, j);
  for (int k = 0; k < layout.pieces; ++k) {
    Row<D> row = layout.row(l * layout.pieces + k);
    row.thread = thread;
    row.owned_end = std::min(row.owned_end, c.end * line);
    sweep.work_on(row);
  }
}

template <class G>
void Wavefront<G>::Wave::put_aside(const Stream<G>& s, const Aside& those) const {
  for (std::size_t k = 0; k < s.columns.size(); ++k) {
    const double* const from = s.columns[k] + those.begin;
    std::copy(from, from + those.size(), &s.aside(0, k) + those.row);
  }
}

template <class G>
void Wavefront<G>::Wave::prepare(Stream<G>& s, int chunk) {
  const Chunk& c = chunks[chunk];
  Part& part = s.parts[chunk];
  part.fullest = part.left = 0;
  part.first_moved = s.particles().count;
  part.last_moved = -1;
  if (part.tail.size() > 0) put_aside(s, part.tail);
  if (part.wrapped.size() > 0) put_aside(s, part.wrapped);
  const int begin = c.begin * line, end = c.end * line;
  s.first(begin) = c.begin == 0 ? 0 : first_of(s, c.begin) + flow(s, c.begin);
  if (c.end == lines) s.first(end) = s.first(end + 1) = s.particles().count;
  part.coming.resize(static_cast<std::size_t>(s.planes) * bins_in_plane());
  part.tiled.resize(2 * std::abs(s.shift));
}

/// Particles of a line to the bins that they come into, in the order in which they are or, where
/// the wave runs down, from the last on.
template <class G>
void Wavefront<G>::Wave::append(Stream<G>& s, Part& part, int l, const Bins& to) const {
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
void Wavefront<G>::Wave::for_sources(const Stream<G>&, int l, const F& f) const {
  if (comes_around(l) && l >= lines - lines_that_wrap)
    for (int k = 0; k < lines_that_wrap; ++k) f(k);
  for (int k = std::max(l - 1, 0); k <= std::min(l + 1, lines - 1); ++k) f(k);
  if (comes_around(l) && l < lines_that_wrap)
    for (int k = lines - lines_that_wrap; k < lines; ++k) f(k);
}

/// How many particles the fullest bin of a line gets; finds their numbers anew where some come
/// around from the other end.
template <class G>
int Wavefront<G>::Wave::count(Stream<G>& s, int l) const {
  const Bins here{l * line, (l + 1) * line};
  int* const next = s.next.data();
  if (comes_around(l)) {
    std::fill(next + here.begin, next + here.end, 0);
    for_sources(s, l, [&](int from) {
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
void Wavefront<G>::Wave::close(Stream<G>& s, Part& part, const Chunk& c, int l) const {
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
void Wavefront<G>::Wave::sort_line(Stream<G>& s, Part& part, int l) const {
  const Bins here{l * line, (l + 1) * line};
  const int begin = s.first(here.begin);
  part.sorted.resize(s.first(here.end) - begin);
  int* const next = s.next.data();
  for_sources(s, l, [&](int from) {
    for (int p = first_of(s, from); p < first_of(s, from + 1); ++p) {
      const int b = bin_of(s.particles().bin(p), from);
      if (here.holds(b)) part.sorted[s.first(b) - begin + next[b]++] = p;
    }
  });
  std::fill(next + here.begin, next + here.end, 0);
}

/// tiled <- the particles of a row in the order of tiles, from those that have come into its bins.
template <class G>
void Wavefront<G>::Wave::lay_in_tiles(const Stream<G>& s, Part& part, const Row<D>& row) const {
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

template <class G>
void Wavefront<G>::Wave::permute(const Stream<G>& s, const Part& part, int begin, int end,
                                 bool looks_aside, bool wrapped) const {
  const int *const source = part.tiled.data(), size = end - begin;
  const int columns = static_cast<int>(s.columns.size());
  if (looks_aside) {
    for (int k = 0; k < columns; ++k) {
      const double *const from = s.columns[k], *const aside = &s.aside(0, k);
      double* const to = s.columns[k] + s.shift + begin;
      for (int i = 0; i < size; ++i) {
        const int p = source[i];
        to[i] = wrapped && part.wrapped.holds(p) ? aside[part.wrapped(p)]
                : part.tail.holds(p)             ? aside[part.tail(p)]
                                                 : from[p];
      }
    }
    return;
  }
  // Four columns at once ask a quarter as often where their particles come from.
  const double* const* from = s.columns.data();
  const int shift = s.shift + begin;
  int left = columns;
  for (; left >= 4; left -= 4, from += 4) gather<4>(from, shift, source, size);
  if (left == 3) gather<3>(from, shift, source, size);
  if (left == 2) gather<2>(from, shift, source, size);
  if (left == 1) gather<1>(from, shift, source, size);
}

/// Particles of a line to their new places.
template <class G>
void Wavefront<G>::Wave::lay(Stream<G>& s, Part& part, const Chunk& c, int j) const {
  const bool wrapped = wraps && c.last && j >= c.size() - lines_that_wrap;
  const bool looks_aside = wrapped || (!c.last && j + 1 >= part.tail_from);
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
    permute(s, part, begin, begin + size, looks_aside, wrapped);
  }
  // A bin that no shape asks for holds those that have left.
  part.left += s.first((l + 1) * line) - s.first((l + 1) * line - 1);
}

template <class G>
void Wavefront<G>::Wave::roll(const Sweep<D>& sweep, int chunk, int thread) {
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
  if (wave_ == nullptr) wave_ = std::make_unique<Wave>(lattice);
  for (Stream<G>& s : wave_->streams) s.taken = false;
  if (!(farthest < 0.999 * lattice.h)) return false;
  if (!wave_->choose(groups, boundaries.side[D - 1][0] == Side::periodic, farthest)) return false;
  const int threads = Space().concurrency();
  const int chunks = chunks_ > 0 ? chunks_ : threads == 1 ? 1 : chunks_per_thread * threads;
  wave_->cut(groups, std::min(chunks, std::max(1, wave_->lines / least_lines)));
  if (chunks_ == 0 && static_cast<int>(wave_->chunks.size()) < threads) {
    for (Stream<G>& s : wave_->streams) s.taken = false;
    return false;
  }
  wave_->find_tails();
  return true;
}

template <class G>
void Wavefront<G>::run(Sweep<D>& sweep) {
  Wave& w = *wave_;
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
  for_chunks(name + " (ends of chunks)", [&](int k, int thread) {
    const Chunk& c = w.chunks[k];
    for (int j = 0; j < c.size(); ++j)
      if (w.worked_on_before(c, j)) w.work_on(sweep, c, j, thread);
  });
  for_chunks("put ends of chunks aside", [&](int k, int) {
    for (auto& s : w.streams)
      if (s.taken) w.prepare(s, k);
  });
  for_chunks(name, [&](int k, int thread) { w.roll(sweep, k, thread); });
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
  if (wave_ == nullptr) return false;
  for (const auto& s : wave_->streams)
    if (s.group == &group) return s.taken;
  return false;
}
template <class G>
bool Wavefront<G>::most_moved(const Group<G>& group) const {
  for (const auto& s : wave_->streams)
    if (s.group == &group) return s.most_moved;
  return false;
}
template <class G>
bool Wavefront<G>::any_left(const Group<G>& group) const {
  for (const auto& s : wave_->streams)
    if (s.group == &group) return s.any_left;
  return false;
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
