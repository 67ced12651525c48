// Each block is worked on once, whoever works, and where neighbours add to the same nodes, a block
// of an odd number after both beside it.
#include "core/turns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace brisance {
namespace {

/// Blocks in the order in which they are done, with all workers called one after the other.
std::vector<int> order_of(int blocks, const std::vector<int>& workers, bool apart) {
  Turns turns(blocks, static_cast<int>(workers.size()), apart);
  std::vector<int> order;
  for (const int worker : workers) turns.work(worker, [&](int block) { order.push_back(block); });
  return order;
}

std::vector<int> workers(int count, bool last_first) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  if (last_first) std::reverse(all.begin(), all.end());
  return all;
}

TEST(Turns, GiveEachBlockOnce) {
  for (const int blocks : {0, 1, 2, 3, 7, 20, 125})
    for (const int count : {1, 2, 3, 8})
      for (const bool apart : {false, true})
        for (const bool last_first : {false, true}) {
          std::vector<int> order = order_of(blocks, workers(count, last_first), apart);
          std::sort(order.begin(), order.end());
          std::vector<int> all(blocks);
          std::iota(all.begin(), all.end(), 0);
          EXPECT_EQ(order, all) << blocks << " blocks, " << count << " workers";
        }
}

/// Also where a range's own worker has not begun when another needs its first block.
TEST(Turns, GiveABlockBetweenOthersAfterBoth) {
  for (const int blocks : {2, 3, 9, 20, 33})
    for (const int count : {1, 2, 3, 8})
      for (const bool last_first : {false, true}) {
        const std::vector<int> order = order_of(blocks, workers(count, last_first), true);
        std::vector<std::size_t> when(blocks);
        for (std::size_t k = 0; k < order.size(); ++k) when[order[k]] = k;
        for (int b = 1; b < blocks; b += 2) {
          EXPECT_GT(when[b], when[b - 1]);
          if (b + 1 < blocks) {
            EXPECT_GT(when[b], when[b + 1]);
          }
        }
      }
}

TEST(Turns, OfThreadsAtOnceKeepTheOrderToo) {
  for (int repeat = 0; repeat < 50; ++repeat) {
    constexpr int blocks = 41, count = 4;
    Turns turns(blocks, count, true);
    std::vector<std::atomic<int>> done(blocks);
    std::atomic<int> early{0};
    std::vector<std::thread> threads;
    for (int worker = 0; worker < count; ++worker)
      threads.emplace_back([&, worker] {
        turns.work(worker, [&](int b) {
          if (b % 2 == 1) early += done[b - 1] == 0 || (b + 1 < blocks && done[b + 1] == 0);
          ++done[b];
        });
      });
    for (auto& t : threads) t.join();
    EXPECT_EQ(early, 0);
    for (const auto& d : done) EXPECT_EQ(d, 1);
  }
}

}  // namespace
}  // namespace brisance
