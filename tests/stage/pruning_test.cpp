#include "stage/pruning.hpp"

#include <gtest/gtest.h>

#include "support/every_executor.hpp"
#include "support/ridges.hpp"
#include "support/topology.hpp"

namespace facet {
namespace {

constexpr PruningParams to_stability{PruningMode::stability, 0};
constexpr PruningParams gonzalez(int n) {
  return {PruningMode::gonzalez, n};
}

template <class Executor>
Mask pruned(Executor& executor, const PruningParams& params, const Mask& mask, const Image<float>& depth) {
  Mask edge = mask, original(mask.size(), 9), mark(mask.size(), 9), grown(mask.size(), 9);
  prune(executor, params, depth.view(), edge.view(), {original.view(), mark.view(), grown.view()});
  return edge;
}
Mask pruned(const PruningParams& params, const Mask& mask, const Image<float>& depth) {
  CpuExecutor executor;
  return pruned(executor, params, mask, depth);
}
/// The same on a frame without missing depth.
Mask pruned(const PruningParams& params, const Mask& mask) {
  return pruned(params, mask, Image<float>(mask.size(), 1.0f));
}

/// A long horizontal line with a spur of `spur_px` pixels standing on its middle.
Mask line_with_spur(int spur_px) {
  return make_image<std::uint8_t>({61, 31}, [&](int x, int y) {
    return (y == 20 && x >= 5 && x < 56) || (x == 30 && y < 20 && y >= 20 - spur_px) ? 1 : 0;
  });
}

/// Two squares joined by a line, with a branch on one of them and a loose line apart.
const std::vector<std::string> dumb_bell{"......................",  //
                                         ".#####.......######...",  //
                                         ".#...#.......#....#...",  //
                                         ".#...#########....#...",  //
                                         ".#...#.......#....#...",  //
                                         ".#####.......######...",  //
                                         "......................"};

TEST(Pruning, EndPointsHaveNoNeighbourOneOrTwoThatTouch) {
  for (unsigned code = 0; code < 256; ++code) {
    int count = 0;
    bool touch = false;
    for (unsigned i = 0; i < 8; ++i) {
      count += static_cast<int>(code >> i & 1u);
      touch |= (code >> i & 1u) && (code >> (i + 1) % 8 & 1u);
    }
    const bool expected = count <= 1 || (count == 2 && touch);
    EXPECT_EQ((is_end_point(neighbours_of(code)) & 1u) != 0, expected) << code;
  }
}

TEST(Pruning, VanishesSpursOfUpToNPixelsAndKeepsTheLine) {
  for (const int spur_px : {1, 5, 9}) {
    const Mask kept = pruned(gonzalez(10), line_with_spur(spur_px));
    for (int x = 5; x < 56; ++x) EXPECT_TRUE(kept(x, 20) || kept(x, 19)) << x;
    EXPECT_LE(count_set(kept), 52) << "the line, and at most a stump where the spur stood";
    for (int y = 0; y < 19; ++y) EXPECT_EQ(kept(30, y), 0) << "spur of " << spur_px;
  }
}

TEST(Pruning, KeepsTheLengthOfSpursLongerThanN) {
  EXPECT_TRUE(same_image(pruned(gonzalez(5), line_with_spur(12)), line_with_spur(12)));
}

TEST(Pruning, KeepsALongLineToTheLastPixel) {
  EXPECT_TRUE(same_image(pruned(gonzalez(10), line_with_spur(0)), line_with_spur(0)));
  const Mask spiral = spiral_mask(41);
  EXPECT_TRUE(same_image(pruned(gonzalez(10), spiral), spiral));
}

TEST(Pruning, VanishesALooseLineOfUpToTwiceN) {
  const auto loose =
      make_image<std::uint8_t>({61, 9}, [](int x, int y) { return y == 4 && x >= 10 && x < 20; });
  EXPECT_EQ(count_set(pruned(gonzalez(5), loose)), 0);
  EXPECT_EQ(count_set(pruned(gonzalez(4), loose)), 10);
}

TEST(Pruning, ToStabilityLeavesLoopsAndTheLinesBetweenThem) {
  Mask with_branches = drawn_mask(dumb_bell);
  for (int x = 19; x < 21; ++x) with_branches(x, 1) = 1;
  EXPECT_TRUE(same_image(pruned(to_stability, with_branches), drawn_mask(dumb_bell)));
}

TEST(Pruning, ToStabilityKeepsALineFromOneImageBorderToAnother) {  // it bounds the regions on both sides
  Mask line(Size{33, 9});
  for (int x = 0; x < 33; ++x) line(x, 4) = 1;
  EXPECT_TRUE(same_image(pruned(to_stability, line), line));
  line(20, 4) = 0;
  EXPECT_EQ(count_set(pruned(to_stability, line)), 0) << "with a gap it bounds nothing";
}

TEST(Pruning,
     ToStabilityKeepsALineBetweenTwoHolesInTheDepth) {  // missing depth bounds regions as an edge does
  Mask line(Size{33, 9});
  for (int x = 8; x < 25; ++x) line(x, 4) = 1;
  Image<float> depth(line.size(), 1.0f);
  for (int y = 0; y < 9; ++y) depth(7, y) = depth(25, y) = 0;
  EXPECT_TRUE(same_image(pruned(to_stability, line, depth), line));
  depth(7, 3) = depth(7, 4) = depth(7, 5) = 1;
  EXPECT_EQ(count_set(pruned(to_stability, line, depth)), 0) << "with one open end it bounds nothing";
}

TEST(Pruning, ToStabilityKeepsNoLineThatRunsAlongAHoleInTheDepth) {
  Mask line(Size{33, 9});
  for (int x = 8; x < 25; ++x) line(x, 4) = 1;
  const auto depth =
      make_image<float>(line.size(), [](int x, int y) { return y > 4 && x > 3 && x < 29 ? 0 : 1; });
  EXPECT_EQ(count_set(pruned(to_stability, line, depth)), 0);
}

TEST(Pruning, ToStabilityKeepsTheRegionsBetweenLinesAndHoles) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Mask lines = line_mask({83, 61}, seed);
    const Mask measured = blob_mask({83, 61}, seed + 50, 20);
    const auto depth = make_image<float>(lines.size(), [&](int x, int y) { return measured(x, y); });
    const auto regions_bounded_by = [&](const Mask& edge) {
      return count_regions(
          make_image<std::uint8_t>(edge.size(), [&](int x, int y) { return edge(x, y) || !measured(x, y); }));
    };
    EXPECT_EQ(regions_bounded_by(pruned(to_stability, lines, depth)), regions_bounded_by(lines));
  }
}

TEST(Pruning, ToStabilityKeepsNoLineThatRunsAlongTheImageBorderAndRoundItsCorner) {
  Mask line(Size{33, 9});
  for (int x = 5; x < 33; ++x) line(x, 0) = 1;
  for (int y = 0; y < 7; ++y) line(32, y) = 1;
  EXPECT_EQ(count_set(pruned(to_stability, line)), 0);
}

TEST(Pruning, ToStabilityKeepsALineThatCutsOffACornerOfTheImage) {
  Mask line(Size{33, 9});
  for (int i = 0; i < 5; ++i) line(28 + i, i) = 1;
  EXPECT_TRUE(same_image(pruned(to_stability, line), line));
}

TEST(Pruning, ToStabilityLeavesNothingOfWhatBoundsNoRegion) {
  EXPECT_EQ(count_set(pruned(to_stability, spiral_mask(41))), 0);
  EXPECT_EQ(count_set(pruned(to_stability, line_with_spur(12))), 0);
}

TEST(Pruning, ToStabilityKeepsEveryRegionClosed) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Mask lines = line_mask({83, 61}, seed);
    EXPECT_EQ(count_regions(pruned(to_stability, lines)), count_regions(lines));
  }
}

TEST(Pruning, ToStabilityLeavesNoPixelWithFewerThanTwoNeighbours) {
  const Mask kept = pruned(to_stability, line_mask({83, 61}, 4));
  EXPECT_GT(count_set(kept), 0);
  for (int y = 1; y < 60; ++y)
    for (int x = 1; x < 82; ++x) {
      int around = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) around += kept(x + dx, y + dy);
      if (kept(x, y)) {
        EXPECT_GE(around, 3);
      }
    }
}

TEST(Pruning, ByGonzalezOnlyDeletes) {
  const Mask lines = line_mask({83, 61}, 4), kept = pruned(gonzalez(10), lines);
  for (int y = 0; y < 61; ++y)
    for (int x = 0; x < 83; ++x) EXPECT_LE(kept(x, y), lines(x, y));
}

TEST(Pruning, ModeNoneLeavesTheEdgesAsTheyAre) {
  const Mask lines = line_mask({33, 9}, 1);
  EXPECT_TRUE(same_image(pruned({PruningMode::none, 10}, lines), lines));
}

TEST(Pruning, IsTheSameOnEveryExecutor) {
  for_each_awkward_mask([](const Mask& mask) {
    if (count_set(mask) > 60000) return;  // thick masks take hundreds of passes
    const Image<float> depth = random_depth(mask.size(), 6);
    expect_same_on_every_executor([&](auto& executor) { return pruned(executor, gonzalez(4), mask, depth); });
    if (mask.width() < 100)
      expect_same_on_every_executor(
          [&](auto& executor) { return pruned(executor, to_stability, mask, depth); });
  });
}

}  // namespace
}  // namespace facet
