#pragma once
// Sorting within a sweep. In a step no particle moves by a cell, so those of a line of bins come
// from this line and the two beside it. A wave runs over the lines: the stages of the sweep work on
// one, and one line behind them the particles come into their new order, while they lie in the
// cache. They are rewritten into the memory they come from, a little further down; the next wave
// runs from the other end and writes them further up. The order is that of core/sort.hpp, which
// goes over all columns in the main memory once more: 14 ns a particle with `fast`, in place of 9.
//
// Threads take chunks of lines. The two lines at each border of chunks are worked on before. What
// comes where the chunk behind still reads is held back until all are through.
#include <memory>
#include <vector>

#include "core/group.hpp"

namespace brisance {

template <class G>
struct Wave;

template <class G>
class Wavefront {
 public:
  static constexpr int D = G::dim;

  /// 0: as many chunks as suit the threads.
  explicit Wavefront(int chunks = 0);
  ~Wavefront();
  Wavefront(Wavefront&&) noexcept;
  Wavefront& operator=(Wavefront&&) noexcept;

  /// Chooses the groups whose particles a sweep over their lines can sort, among those that are
  /// `in_motion`, if nothing moves further than `farthest` [m]. Returns whether there are any. To
  /// be called before the sweep is filled: columns may come to lie elsewhere.
  bool takes(const std::vector<std::unique_ptr<Group<G>>>& groups, const Lattice<D>& lattice,
             const Boundaries<D>& boundaries, double farthest);
  /// Does what the sweep holds, the last of which finds the bins of particles, and sorts those of
  /// the groups chosen. Those that have left the domain stay in line and are still to be taken out.
  void run(Sweep<D>& sweep);

  /// Whether the last wave sorted a group; and what it has seen then.
  bool sorted(const Group<G>& group) const;
  /// Whether most particles are at other places than before.
  bool most_moved(const Group<G>& group) const;
  /// Whether any have left the domain.
  bool any_left(const Group<G>& group) const;

  /// Memory of the work arrays. [B]
  std::size_t bytes() const;

 private:
  int chunks_;
  std::unique_ptr<Wave<G>> wave_;
};

}  // namespace brisance
