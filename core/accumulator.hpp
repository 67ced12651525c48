#pragma once
// Where particles add what they give to the nodes.
#include "core/types.hpp"

namespace brisance {

/// How adds of several threads to one node are kept apart.
/// - colours: blocks of rows two apart are worked on at once, each adds straight to the sum; the
///   order of the additions, hence every bit, is the same for any number of threads;
/// - duplicates: Kokkos' ScatterView, a copy for each thread (or atomics, where the backend prefers
///   them): what other backends take, and unsorted data could. Clearing and adding up the copies
///   costs a tenth to a quarter of a step of gas.
enum class Summation { colours, duplicates };

class Accumulator {
 public:
  using Scatter = Kokkos::Experimental::ScatterView<double**, Kokkos::LayoutLeft, Space>;

  Table<double> total;
  Scatter scatter;  ///< of duplicates

  Accumulator(int nodes, int columns, Summation by = Summation::colours)
      : total("sums", nodes, columns),
        duplicates_(by == Summation::duplicates || !kernels_on_host) {
    // Made once; making one in every step costs more than using it.
    if (duplicates_) scatter = Kokkos::Experimental::create_scatter_view(total);
  }

  bool duplicates() const { return duplicates_; }

  /// Memory of the sum and of what threads hold beside it. [B]
  std::size_t bytes() const {
    return total.span() * sizeof(double) * (duplicates_ ? 1 + Space().concurrency() : 1);
  }

  void clear() { clear(static_cast<int>(total.extent(1))); }
  /// The columns first .. end - 1 only, where no others are asked for.
  void clear(int end, int first = 0) {
    if (duplicates_)
      scatter.reset();
    else
      Kokkos::deep_copy(Kokkos::subview(total, Kokkos::ALL, Kokkos::make_pair(first, end)), 0.0);
  }
  /// To be called when all has been added, before `total` is read.
  void contribute() {
    if (!duplicates_) return;
    Kokkos::deep_copy(total, 0.0);
    Kokkos::Experimental::contribute(total, scatter);
  }

 private:
  bool duplicates_;
};

}  // namespace brisance
