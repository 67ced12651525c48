#pragma once
// Particles into the order of their bins and tiles: a stable counting sort, so that the order, and
// with it every sum over particles, is the same for any number of threads.
#include "core/particles.hpp"
#include "core/transfer.hpp"

namespace brisance {

/// Bins begin .. end - 1.
struct BinRange {
  int begin = 0, end = 0;
};

template <class G>
class Sorter {
 public:
  /// Sorts by the column `bin`, which it uses up, and counts the bins. Particles that have left the
  /// domain come to stand behind the rest, from the new `count` on, where they can still be read;
  /// returns how many they are.
  int sort(Particles<G>& particles, const Lattice<G::dim>& lattice);
  /// The same, after it has found the bins.
  int sort(Particles<G>& particles, const Transfer<G>& transfer, const Lattice<G::dim>& lattice);

  /// Whether the last sort rewrote all columns from one end to the other.
  bool most_moved() const { return most_moved_; }

  /// Memory of the work arrays. [B]
  std::size_t bytes() const {
    return (source_.span() + counts_.span()) * sizeof(int) + touched_.span() * sizeof(BinRange);
  }

 private:
  Array<int> source_;
  Table<int> counts_;  ///< (bin, chunk of particles): first the count, then the next free place
  Array<BinRange> touched_;  ///< by each chunk
  bool most_moved_ = false;
};

}  // namespace brisance
