#include "core/atomic.hpp"

#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace facet {
namespace {

TEST(FetchMin, LowersTheTargetAndReturnsWhatStoodThere) {
  int cell = 5;
  EXPECT_EQ(fetch_min(&cell, 3), 5);
  EXPECT_EQ(cell, 3);
  EXPECT_EQ(fetch_min(&cell, 4), 3);
  EXPECT_EQ(cell, 3);
}

TEST(FetchMin, LeavesTheSmallestValueOfAllThreads) {
  int cell = 1000000;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&cell, t] {
      for (int i = 100000; i >= 7; --i) fetch_min(&cell, 4 * i + t);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(cell, 28);
}

TEST(RaiseFlag, MayBeRaisedByManyThreadsAtOnce) {
  int flag = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) threads.emplace_back([&flag] { raise_flag(&flag); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(flag, 1);
}

}  // namespace
}  // namespace facet
