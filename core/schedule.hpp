#pragma once
// In which order the rows of bins are worked on. Kernels are functions of a row; what follows one
// upon the other without a look at nodes that others still add to goes into one sweep, which works
// on a row after the other while its particles lie in the nearest cache.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "core/accumulator.hpp"
#include "core/row.hpp"
#include "core/turns.hpp"

namespace brisance {

/// Stages that are worked on together: all stages of a row, then the next row. Where kernels do not
/// run on the host, each stage is a kernel of its own, launched as it is added.
template <int D>
class Sweep {
 public:
  explicit Sweep(const Lattice<D>& lattice) : layout_(lattice) {}

  const Lattice<D>& lattice() const { return layout_.lattice; }
  int rows() const { return layout_.rows; }

  /// f(row), which reads and writes the particles of the row, and nodes that no stage of this sweep
  /// writes.
  template <class F>
  void add(const char* name, const F& f) {
    if constexpr (kernels_on_host)
      stages_.push_back(std::make_unique<StageOf<F>>(name, f));
    else
      launch(name, f);
  }

  /// f(row, to) with to(node, column) += value.
  template <class F>
  void add(const char* name, const Accumulator& sums, const F& f) {
    if (sums.duplicates()) {
      duplicates_ = true;
      add(name, Scattering<F>{f, sums.scatter});
    } else {
      colours_ = true;
      add(name, Adding<F>{f, sums.total});
    }
  }

  /// Columns first .. end - 1 of sums <- 0, before any stage adds to them.
  void clear(Accumulator& sums, int end, int first = 0) {
    if (sums.duplicates())
      sums.clear(end, first);
    else
      cleared_.push_back({sums.total, first, end});
  }

  /// Works on all rows and forgets the stages.
  void run() {
    if (!colours_) clear_all();
    if (stages_.empty()) return;
    if (duplicates_) {
      const Kokkos::Experimental::UniqueToken<Space> threads;
      Kokkos::parallel_for(name(), Fixed(0, layout_.blocks), [this, threads](int block) {
        const int thread = threads.acquire();
        work_on_block(block, thread);
        threads.release(thread);
      });
    } else {
      in_turns(name(), layout_.blocks, colours_,
               [this](int block, int thread) { work_on_block(block, thread); });
    }
    forget();
  }

  // For those who choose the order of rows themselves, in a sweep that adds nothing to nodes:

  void work_on(const Row<D>& row) const {
    for (const auto& stage : stages_) (*stage)(row);
  }
  /// Profilers see the names of all stages, apart by commas.
  std::string name() const { return watched() ? names() : "sweep"; }
  void forget() {
    stages_.clear();
    cleared_.clear();
    colours_ = duplicates_ = false;
  }

 private:
  // Copies of sums ask for the same blocks of a thread each time.
  using Fixed = Kokkos::RangePolicy<Space, Kokkos::Schedule<Kokkos::Static>>;

  struct Stage {
    const char* name;
    explicit Stage(const char* name_) : name(name_) {}
    virtual ~Stage() = default;
    virtual void operator()(const Row<D>& row) const = 0;
  };
  template <class F>
  struct StageOf final : Stage {
    F f;
    StageOf(const char* name_, const F& f_) : Stage(name_), f(f_) {}
    void operator()(const Row<D>& row) const override { f(row); }
  };
  template <class F>
  struct Adding {
    F f;
    Table<double> to;
    KOKKOS_INLINE_FUNCTION void operator()(const Row<D>& row) const { f(row, to); }
  };
  template <class F>
  struct Scattering {
    F f;
    Accumulator::Scatter scatter;
    KOKKOS_INLINE_FUNCTION void operator()(const Row<D>& row) const { f(row, scatter.access()); }
  };

  struct Cleared {
    Table<double> sums;
    int first, end;
    void nodes(int from, int to) const {
      for (int k = first; k < end; ++k)
        std::fill(&sums(from, k), &sums(from, k) + (to - from), 0.0);
    }
  };

  RowLayout<D> layout_;
  std::vector<std::unique_ptr<Stage>> stages_;
  std::vector<Cleared> cleared_;
  bool colours_ = false, duplicates_ = false;

  /// A pass of its own over the nodes takes a fiftieth of a step with two threads, which gain
  /// nothing there: a block that comes before its neighbours clears what they add to, too.
  void work_on_block(int block, int thread) const {
    if (block % 2 == 0)
      for (const Cleared& c : cleared_)
        c.nodes(layout_.first_bin(block), layout_.first_bin(block + 2));
    const int end = std::min(layout_.rows, (block + 1) * layout_.rows_in_block);
    for (int k = block * layout_.rows_in_block; k < end; ++k) {
      Row<D> row = layout_.row(k);
      row.thread = thread;
      work_on(row);
    }
  }
  void clear_all() {
    for (const Cleared& c : cleared_) c.nodes(0, layout_.lattice.size);
    cleared_.clear();
  }

  static bool watched() {
    return Kokkos::Tools::Experimental::get_callbacks().begin_parallel_for != nullptr;
  }
  std::string names() const {
    std::string all;
    for (const auto& stage : stages_)
      if (all.find(stage->name) == std::string::npos)  // groups of one law say it once
        all += (all.empty() ? "" : ", ") + std::string(stage->name);
    return all;
  }

  template <class F>
  void launch(const char* name, const F& f) {
    const auto layout = layout_;
    Kokkos::parallel_for(
        name, Fixed(0, layout.rows), KOKKOS_LAMBDA(const int k) { f(layout.row(k)); });
  }
};

}  // namespace brisance
