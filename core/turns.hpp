#pragma once
// Who works on which block of rows, and when. Each thread has a range of its own, since it is told
// by the same blocks what lies where, and helps others when it is through.
//
// Where neighbours add to the same nodes (`apart`), a block of an odd number comes after both
// beside it: the order of additions to a node is the same for any number of threads, yet memory is
// walked through once, and the nodes of a block lie in the cache still when those beside it add.
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "core/types.hpp"

namespace brisance {

class Turns {
 public:
  Turns(int blocks, int workers, bool apart)
      : apart_(apart),
        ranges_(std::min(workers, apart ? (blocks + 1) / 2 : blocks)),
        done_(apart ? blocks : 0) {
    const std::int64_t step = apart ? 2 : 1, steps = (blocks + step - 1) / step, count = ranges();
    const auto begin_of = [&](int r) {
      return static_cast<int>(std::min<std::int64_t>(blocks, step * (steps * r / count)));
    };
    for (int r = 0; r < count; ++r) {
      ranges_[r].begin = begin_of(r);
      ranges_[r].end = begin_of(r + 1);
    }
  }

  /// Calls f(block) for blocks whose turn it is until all are taken. To be called for all workers,
  /// in any order.
  template <class F>
  void work(int worker, const F& f) {
    for (int k = 0; k < ranges(); ++k)
      while (take((worker + k) % ranges(), f)) {
      }
  }

 private:
  struct alignas(64) Range {
    int begin, end;
    std::atomic<int> turn{0};
  };

  /// In turn t the even block t comes and the odd block t - lag, whose neighbours have come then,
  /// also where two threads take turns.
  static constexpr int lag = 4;

  bool apart_;
  std::vector<Range> ranges_;
  std::vector<std::atomic<bool>> done_;

  int ranges() const { return static_cast<int>(ranges_.size()); }

  template <class F>
  bool take(int r, const F& f) {
    Range& range = ranges_[r];
    const int size = range.end - range.begin, turn = range.turn.fetch_add(1);
    if (turn >= size + (apart_ ? lag : 0)) return false;
    const bool odd = apart_ && turn % 2 == 1;
    const int block = range.begin + turn - (odd ? lag : 0);
    if (block < range.begin || block >= range.end) return true;
    if (odd) {
      wait_for(block - 1);
      if (block + 1 < range.end)
        wait_for(block + 1);
      else if (r + 1 < ranges())
        see_to_first_of(ranges_[r + 1], f);
    }
    do_block(block, f);
    return true;
  }

  template <class F>
  void do_block(int block, const F& f) {
    f(block);
    if (apart_) done_[block].store(true, std::memory_order_release);
  }

  /// Its own worker may not have begun.
  template <class F>
  void see_to_first_of(Range& range, const F& f) {
    int none = 0;
    if (range.turn.compare_exchange_strong(none, 1))
      do_block(range.begin, f);
    else
      wait_for(range.begin);
  }

  void wait_for(int block) const {
    while (!done_[block].load(std::memory_order_acquire)) std::this_thread::yield();
  }
};

/// Calls f(block, thread) for all blocks, on the host. The thread is one of those of the space.
template <class F>
void in_turns(const std::string& name, int blocks, bool apart, const F& f) {
  const int workers = Space().concurrency();
  const Kokkos::Experimental::UniqueToken<Space> threads;
  Turns turns(blocks, workers, apart);
  Kokkos::parallel_for(name,
                       Kokkos::RangePolicy<Space, Kokkos::Schedule<Kokkos::Static>>(0, workers),
                       [&, threads](int worker) {
                         const int thread = threads.acquire();
                         turns.work(worker, [&](int block) { f(block, thread); });
                         threads.release(thread);
                       });
}

}  // namespace brisance
