#include "stage/thinning.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "support/every_executor.hpp"
#include "support/ridges.hpp"
#include "support/topology.hpp"

namespace facet {
namespace {

template <class Executor>
Mask thinned(Executor& executor, const Mask& mask) {
  Mask edge = mask, mark(mask.size());
  thin(executor, edge.view(), mark.view());
  return edge;
}
Mask thinned(const Mask& mask) {
  CpuExecutor executor;
  return thinned(executor, mask);
}

/// The rule as Guo and Hall give it, by counts.
bool deletes_by_counts(unsigned code, int half) {
  const auto p = [code](unsigned i) { return (code >> i % 8 & 1u) != 0; };
  int crossings = 0, n1 = 0, n2 = 0;
  for (unsigned side = 0; side < 8; side += 2) {
    crossings += !p(side) && (p(side + 1) || p(side + 2));
    n1 += p(side + 7) || p(side);
    n2 += p(side) || p(side + 1);
  }
  const int n = std::min(n1, n2);
  const bool blocked = half == 0 ? (p(0) || p(1) || !p(3)) && p(2) : (p(4) || p(5) || !p(7)) && p(6);
  return crossings == 1 && n >= 2 && n <= 3 && !blocked;
}

TEST(Thinning, DeletesWhatGuoAndHallsCountsDelete) {
  for (unsigned code = 0; code < 256; ++code)
    for (const int half : {0, 1})
      EXPECT_EQ(guo_hall_deletes(code, half), deletes_by_counts(code, half)) << code << ", " << half;
}

TEST(Thinning, KeepsEveryLineEveryHoleAndEveryRegion) {
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (const Mask& mask :
         {blob_mask({83, 61}, seed), blob_mask({83, 61}, seed, 4), line_mask({83, 61}, seed),
          random_mask({83, 61}, seed, 0.5f), random_mask({83, 61}, seed, 0.2f)})
      EXPECT_EQ(topology_of(thinned(mask)), topology_of(mask));
}

TEST(Thinning, OnlyDeletes) {
  const Mask mask = blob_mask({83, 61}, 3), lines = thinned(mask);
  for (int y = 0; y < 61; ++y)
    for (int x = 0; x < 83; ++x) EXPECT_LE(lines(x, y), mask(x, y));
}

TEST(Thinning, LeavesNoBlockOfTwoByTwo) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    EXPECT_EQ(count_blocks(thinned(blob_mask({83, 61}, seed))), 0) << seed;
    EXPECT_EQ(count_blocks(thinned(line_mask({83, 61}, seed))), 0) << seed;
  }
}

TEST(Thinning, LeavesThinLinesAsTheyAre) {
  const Mask spiral = spiral_mask(41);
  const Mask kept = thinned(spiral);
  EXPECT_EQ(topology_of(kept), topology_of(spiral));
  EXPECT_GE(count_set(kept), count_set(spiral) - 41) << "corners of a staircase may go, the ends may not";
  EXPECT_EQ(kept(0, 0), 1);
}

TEST(Thinning, ReducesABarToALineAlongItsMiddleOfNearlyItsLength) {
  const auto bar =
      make_image<std::uint8_t>({60, 20}, [](int x, int y) { return x > 4 && x < 55 && y > 6 && y < 12; });
  const Mask line = thinned(bar);
  EXPECT_EQ(topology_of(line), (Topology{1, 1}));
  EXPECT_LE(count_set(line), 52);
  EXPECT_GE(count_set(line), 44);
  for (int y = 0; y < 20; ++y)
    for (int x = 8; x < 52; ++x) EXPECT_EQ(line(x, y), y == 9 ? 1 : 0);
}

TEST(Thinning, OfItsOwnResultChangesNothing) {
  const Mask once = thinned(random_mask({83, 61}, 3, 0.5f));
  EXPECT_TRUE(same_image(thinned(once), once));
}

TEST(Thinning, IsTheSameOnEveryExecutor) {
  for_each_awkward_mask([](const Mask& mask) {
    if (count_set(mask) > 130000) return;  // thick masks take many passes
    expect_same_on_every_executor([&](auto& executor) { return thinned(executor, mask); });
  });
}

}  // namespace
}  // namespace facet
