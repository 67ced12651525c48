#pragma once
// What a wave of core/wavefront.hpp knows, and does, of lines of bins. A line that the stages have
// worked on is followed: its particles are appended to the bins that they come into, and the line
// before, into which all have come then, is laid out and rewritten.
#include <vector>

#include "core/group.hpp"

namespace brisance {

/// In so many lines at either end those are looked for that cross a periodic end: of the highest
/// three a particle is in the first at most, and splines meet there with half a line each.
constexpr int lines_that_wrap = 4;

/// Particles begin .. end, put aside from a row of a table on.
struct Aside {
  int begin = 0, end = 0, row = 0;
  bool holds(int p) const { return p >= begin && p < end; }
  int operator()(int p) const { return row + p - begin; }
  int size() const { return end - begin; }
};

/// What a chunk knows of a group.
struct Part {
  Aside held;  ///< the places of rows that come where the chunk behind still reads
  int held_first = 0, held_end = 0;  ///< of these, those that are taken
  int offset = 0;                    ///< place of the next line
  int first_moved = 0, last_moved = 0, fullest = 0, left = 0;
  std::vector<int> coming;  ///< plane k: the k-th that comes into each bin, modulo a power of two
  std::vector<int> sorted;  ///< of a line, bin by bin
  std::vector<int> tiled;   ///< of a row
};

/// The particles of a group.
template <class G>
struct Stream {
  Group<G>* group = nullptr;
  bool taken = false;
  int shift = 0;  ///< of the memory in which particles are written to that in which they are read
  int wrapping = 0;  ///< how many particles may cross a periodic end
  Array<int> first;  ///< of each bin, in the new order
  Array<int> next;   ///< of each bin: how many have come; zeros before and after a wave
  int planes = 0;    ///< how many are kept of those that come into a bin
  std::vector<double*> columns;
  Aside wraps;  ///< the particles that come around from the end where the wave begins
  Table<double> wrapped, held;
  std::vector<double*> held_columns;
  std::vector<Part> parts;  ///< of chunks
  bool most_moved = false, any_left = false;

  Particles<G>& particles() const { return group->particles; }
};

/// Lines of bins.
struct Chunk {
  int begin, end;
  bool first, last;  ///< of the wave
  int size() const { return end - begin; }
};

/// See core/wave_plan.cpp for what is settled before, and core/wave_sort.cpp for the rest.
template <class G>
struct Wave {
  static constexpr int D = G::dim;

  struct Bins {
    int begin, end;
    bool holds(int b) const { return b >= begin && b < end; }
  };

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
  void cut(const std::vector<std::unique_ptr<Group<G>>>& groups, int threads, int for_each_thread);
  void make_room();

  /// Where the particles of chunks begin in the new order, and what chunks hold back: to be called
  /// when the lines beside their ends have been worked on.
  void place_chunks();
  int how_many(const Stream<G>& s, int l, const Bins& to) const;
  int flow(const Stream<G>& s, int border) const;

  // Of a chunk; j counts its lines along the wave.

  int line_at(const Chunk& c, int j) const { return up ? c.begin + j : c.end - 1 - j; }
  /// The g-th line of all along the wave.
  int line_of_all(int g) const { return up ? g : lines - 1 - g; }
  bool worked_on_before(const Chunk& c, int j) const {
    return (j == 0 && !c.first) || (j == c.size() - 1 && !c.last) ||
           (wraps && c.first && j < lines_that_wrap) ||
           (wraps && c.last && j >= c.size() - lines_that_wrap);
  }

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

  void work_on(const Sweep<D>& sweep, const Chunk& c, int j, int thread) const;
  void prepare(const Sweep<D>& sweep, int chunk, int thread);
  void append(Stream<G>& s, Part& part, int l, const Bins& to) const;
  bool comes_around(int l) const {
    return wraps && (l < lines_that_wrap || l >= lines - lines_that_wrap);
  }
  template <class F>
  void for_sources(int l, const F& f) const;
  void sort_line(Stream<G>& s, Part& part, int l) const;
  int count(Stream<G>& s, int l) const;
  void close(Stream<G>& s, Part& part, const Chunk& c, int l) const;
  void lay_in_tiles(const Stream<G>& s, Part& part, const Row<D>& row) const;
  void lay(Stream<G>& s, Part& part, const Chunk& c, int j) const;
  bool holds_back(const Stream<G>& s, const Chunk& c, int begin, int end) const;
  void permute(const Stream<G>& s, Part& part, const Chunk& c, int begin, int end,
               bool wrapped) const;
  void roll(const Sweep<D>& sweep, int chunk, int thread);
  void put_back(const Stream<G>& s, const Part& part) const;
};

}  // namespace brisance
