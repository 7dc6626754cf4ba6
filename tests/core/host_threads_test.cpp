#include "core/host_threads.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace facet {
namespace {

/// Three workers that take turns, the last piece of work first.
class Backwards : public HostThreads {
 public:
  Backwards() : HostThreads(3) {}

 private:
  void run(int count, const Task& task) override {
    for (int i = count; i-- > 0;) task(i, i % workers());
  }
};

TEST(HostThreads, ByItselfIsTheCallingThreadAlone) {
  HostThreads threads;
  std::vector<std::pair<int, int>> calls;
  threads.share_out(3, [&](int i, int worker) { calls.emplace_back(i, worker); });
  EXPECT_EQ(calls, (std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {2, 0}}));
  calls.clear();
  threads.for_each_band(9, [&](int begin, int end) { calls.emplace_back(begin, end); });
  EXPECT_EQ(calls, (std::vector<std::pair<int, int>>{{0, 9}}));
}

TEST(HostThreads, OfSeveralWorkersSharesOutEveryPieceOnce) {
  Backwards threads;
  std::vector<std::pair<int, int>> calls;
  threads.share_out(4, [&](int i, int worker) { calls.emplace_back(i, worker); });
  EXPECT_EQ(calls, (std::vector<std::pair<int, int>>{{3, 0}, {2, 2}, {1, 1}, {0, 0}}));
  std::vector<int> visits(50);
  threads.for_each_row(50, [&](int y) { ++visits[static_cast<std::size_t>(y)]; });
  EXPECT_EQ(visits, std::vector<int>(50, 1));
}

TEST(HostThreads, PartsCoverEverythingOnceAndNoneIsTooSmall) {
  Backwards threads;
  for (const std::size_t count : {0u, 1u, 9u, 20u, 31u, 1000u}) {
    std::vector<int> visits(count);
    threads.for_each_part(count, 10, [&](std::size_t i, std::size_t begin, std::size_t end) {
      EXPECT_LT(i, 3u);
      EXPECT_GE(end - begin, std::min<std::size_t>(count, 10));
      for (std::size_t k = begin; k < end; ++k) ++visits[k];
    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
  }
}

}  // namespace
}  // namespace facet
