#include "stream/bounded_queue.hpp"

#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <numeric>
#include <thread>

namespace facet {
namespace {

TEST(BoundedQueue, ItemsLeaveInTheOrderInWhichTheyCameHoweverOftenTheBufferGoesRound) {
  BoundedQueue<int> queue(3);
  int next = 0;
  for (int round = 0; round < 5; ++round) {
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(queue.push(2 * round + i));
    for (int i = 0; i < 2; ++i) {
      const auto taken = queue.pop();
      ASSERT_TRUE(taken);
      EXPECT_EQ(taken->item, next);
      EXPECT_EQ(taken->ticket, static_cast<std::uint64_t>(next++));
    }
  }
}

TEST(BoundedQueue, ManyThreadsAtBothEndsGetEveryItemOnceAndNeverFillMoreThanThereIsRoom) {
  constexpr int producers = 3, each = 2000;
  BoundedQueue<int> queue(4);
  std::atomic<long> sum = 0;
  std::atomic<int> count = 0;
  std::vector<std::jthread> consumers;
  for (int i = 0; i < 3; ++i)
    consumers.emplace_back([&] {
      while (const auto taken = queue.pop()) sum += taken->item, ++count;
    });
  {
    std::vector<std::jthread> threads;
    for (int p = 0; p < producers; ++p)
      threads.emplace_back([&, p] {
        for (int i = 0; i < each; ++i) queue.push(p * each + i);
      });
  }
  queue.close();
  consumers.clear();
  constexpr long n = producers * each;
  EXPECT_EQ(count, n);
  EXPECT_EQ(sum, n * (n - 1) / 2);
  const QueueStatistics statistics = queue.statistics();
  EXPECT_EQ(statistics.taken_in, static_cast<std::uint64_t>(n));
  EXPECT_LE(statistics.max_depth, 4u);
  EXPECT_LE(statistics.mean_depth, 4.0);
  EXPECT_EQ(statistics.dropped, 0u);
}

TEST(BoundedQueue, WhereItIsFullTheOldestGivesWayAndIsCounted) {
  BoundedQueue<std::unique_ptr<int>> queue(2);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(queue.push_over_oldest(std::make_unique<int>(i)));
  queue.close();
  EXPECT_EQ(*queue.pop()->item, 3);
  const auto last = queue.pop();
  EXPECT_EQ(*last->item, 4);
  EXPECT_EQ(last->ticket, 1u) << "tickets count what leaves";
  EXPECT_FALSE(queue.pop());
  EXPECT_EQ(queue.statistics().dropped, 3u);
  EXPECT_EQ(queue.statistics().taken_in, 5u);
  EXPECT_EQ(queue.statistics().max_depth, 2u);
}

TEST(BoundedQueue, ClosedItStillGivesWhatItHolds) {
  BoundedQueue<int> queue(2);
  queue.push(1);
  queue.close();
  EXPECT_TRUE(queue.pop());
  EXPECT_FALSE(queue.pop());
}

TEST(BoundedQueue, StoppingSendsAwayWhoeverWaitsAtEitherEnd) {
  BoundedQueue<int> empty(1), full(1);
  full.push(1);
  bool pushed = true, popped = true;
  {
    const std::jthread producer([&] { pushed = full.push(2); });
    const std::jthread consumer([&] { popped = empty.pop().has_value(); });
    empty.stop();
    full.stop();
  }
  EXPECT_FALSE(pushed);
  EXPECT_FALSE(popped);
  EXPECT_FALSE(full.pop()) << "what it holds is lost";
  EXPECT_FALSE(full.push_over_oldest(3));
}

TEST(BoundedQueue, TheMeanDepthIsThatOfTheTimeBetweenFirstItemAndClosing) {
  BoundedQueue<int> queue(4);
  queue.push(0);
  queue.push(1);
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  queue.close();
  const double mean = queue.statistics().mean_depth;
  EXPECT_GT(mean, 1.0);
  EXPECT_LE(mean, 2.0);
  EXPECT_EQ(BoundedQueue<int>(4).statistics().mean_depth, 0) << "nothing ever came";
}

}  // namespace
}  // namespace facet
