#include "stage/fill_missing.hpp"

#include <gtest/gtest.h>
#include <tuple>
#include <vector>

#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

/// Runs the stage and returns depth and the mask of made-up pixels.
template <class Executor>
std::tuple<Image<float>, Mask> filled(Executor& executor, const FillParams& params,
                                      const Image<float>& depth) {
  std::tuple out{depth, Mask(depth.size(), 9)};
  Mask open(depth.size()), rim(depth.size());
  Image<float> proposal(depth.size());
  fill_missing(executor, params, std::get<0>(out).view(), std::get<1>(out).view(),
               {open.view(), rim.view(), proposal.view()});
  return out;
}
Image<float> filled_depth(const FillParams& params, const Image<float>& depth) {
  CpuExecutor executor;
  return std::get<0>(filled(executor, params, depth));
}

constexpr FillParams from_all_sides{true, FillPrefer::nearest, 512, 0, 0.02f, 48};
constexpr FillParams from_the_far_side{true, FillPrefer::far, 512, 0, 0.02f, 48};

/// One pass of Algorithm 1 read literally, apart from the absolute value: for every measured b beside a
/// missing pixel, the mean of every 3x3 neighbourhood containing b; each missing pixel beside b takes the
/// mean nearest to b. Of several b the one with the least difference wins,
/// of equal ones the larger mean. Means are over measured pixels.
Image<float> literal_pass(const Image<float>& depth) {
  Image<float> out = depth;
  Image<double> best(depth.size(), 1e9);
  const auto at = [&](int x, int y) {
    return depth.size().contains(x, y) ? static_cast<double>(depth(x, y)) : 0.0;
  };
  for (int by = 0; by < depth.height(); ++by)
    for (int bx = 0; bx < depth.width(); ++bx) {
      if (at(bx, by) == 0) continue;
      double nearest = 0, difference = 1e9;
      for (int wy = by - 1; wy <= by + 1; ++wy)
        for (int wx = bx - 1; wx <= bx + 1; ++wx) {
          double sum = 0, n = 0;
          for (int y = wy - 1; y <= wy + 1; ++y)
            for (int x = wx - 1; x <= wx + 1; ++x) sum += at(x, y), n += at(x, y) > 0;
          const double d = std::abs(sum / n - at(bx, by));
          if (d < difference || (d == difference && sum / n > nearest)) nearest = sum / n, difference = d;
        }
      for (int y = by - 1; y <= by + 1; ++y)
        for (int x = bx - 1; x <= bx + 1; ++x) {
          if (!depth.size().contains(x, y) || at(x, y) > 0) continue;
          const bool better = difference < best(x, y) ||
                              (difference == best(x, y) && nearest > static_cast<double>(out(x, y)));
          if (better) best(x, y) = difference, out(x, y) = static_cast<float>(nearest);
        }
    }
  return out;
}

TEST(FillMissing, IsAlgorithm1PassByPass) {
  Image<float> expected = random_depth({37, 29}, 12);
  for (int pass = 1; pass <= 3; ++pass) {
    FillParams params = from_all_sides;
    params.max_passes = 1;
    const Image<float> out = filled_depth(params, expected);
    expected = literal_pass(expected);
    for (int y = 0; y < 29; ++y)
      for (int x = 0; x < 37; ++x) EXPECT_NEAR(out(x, y), expected(x, y), 1e-5) << x << ", " << y;
  }
}

TEST(FillMissing, TakesTheMeanNearestToItsNeighbourNotTheSmallest) {  // argmin of the difference has no sign
  const auto depth = make_image<float>({9, 5}, [](int x, int) { return x < 3 ? 0.5f : x < 5 ? 1.0f : 0.0f; });
  FillParams params = from_all_sides;
  params.max_passes = 1;
  const Image<float> out = filled_depth(params, depth);
  for (int y = 0; y < 5; ++y)
    EXPECT_EQ(out(5, y), 1.0f) << "argmin(mean - b) gives 5/6: the window that has 0.5 in it";
}

TEST(FillMissing, FillsHolesOfAConstantSurfaceWithThatConstant) {
  const auto holes =
      make_image<float>({33, 9}, [](int x, int y) { return x > 3 && x < 29 && y > 1 && y < 8 ? 0.0 : 1.5; });
  for (const FillParams& params : {from_all_sides, from_the_far_side})
    EXPECT_TRUE(same_image(filled_depth(params, holes), Image<float>(holes.size(), 1.5f)));
}

TEST(FillMissing, ChangesNoMeasuredPixelAndMarksExactlyWhatItMadeUp) {
  const Image<float> depth = random_depth({61, 43}, 3);
  CpuExecutor executor;
  for (const FillParams& params : {FillParams{}, from_all_sides}) {
    const auto [out, mask] = filled(executor, params, depth);
    for (int y = 0; y < 43; ++y)
      for (int x = 0; x < 61; ++x) {
        if (depth(x, y) > 0) {
          EXPECT_EQ(out(x, y), depth(x, y));
        }
        EXPECT_EQ(mask(x, y), depth(x, y) == 0 && out(x, y) > 0 ? 1 : 0);
      }
  }
}

TEST(FillMissing, MakesUpNoDepthBeyondTheRangeOfTheFrame) {
  const Image<float> out = filled_depth(from_all_sides, random_depth({61, 43}, 3));
  for (int y = 0; y < 43; ++y)
    for (int x = 0; x < 61; ++x) EXPECT_TRUE(out(x, y) >= 0.5f && out(x, y) < 3.02f);
}

TEST(FillMissing, AdvancesOnePixelPerPassFromEachSide) {
  const auto gap = make_image<float>({31, 7}, [](int x, int) { return x >= 10 && x < 20 ? 0.0f : 1.5f; });
  for (int passes = 0; passes <= 5; ++passes) {
    FillParams params = from_all_sides;
    params.max_passes = passes;
    const Image<float> out = filled_depth(params, gap);
    for (int x = 0; x < 31; ++x) EXPECT_EQ(out(x, 3) > 0, x < 10 + passes || x >= 20 - passes) << x;
  }
}

/// A hole from row 5 to 15 and column 5 to 25; its least extent is 11 pixels.
Image<float> eleven_pixel_hole() {
  return make_image<float>({40, 20},
                           [](int x, int y) { return x >= 5 && x <= 25 && y >= 5 && y <= 15 ? 0.0 : 1.5; });
}

TEST(FillMissing, LeavesHolesThatAreTooWide) {
  FillParams params = from_all_sides;
  params.max_hole_px = 10;
  EXPECT_TRUE(same_image(filled_depth(params, eleven_pixel_hole()), eleven_pixel_hole()));
  params.max_hole_px = 11;
  EXPECT_TRUE(same_image(filled_depth(params, eleven_pixel_hole()), Image<float>(Size{40, 20}, 1.5f)));
}

TEST(FillMissing, LeavesHolesThatTheImageCutsOffUnlessAnyHoleMayBeFilled) {
  const auto corner = make_image<float>({33, 20}, [](int x, int y) { return x < 4 && y < 4 ? 0.0f : 1.5f; });
  FillParams params = from_all_sides;
  EXPECT_TRUE(same_image(filled_depth(params, corner), Image<float>(corner.size(), 1.5f)));
  params.max_hole_px = 40;
  EXPECT_TRUE(same_image(filled_depth(params, corner), corner));
}

/// A box at 1 m, its shadow of twelve columns, and the wall behind it at 2 m.
Image<float> shadow_scene() {
  return make_image<float>({60, 20}, [](int x, int) { return x < 20 ? 1.0f : x < 32 ? 0.0f : 2.0f; });
}

TEST(FillMissing, FromAllSidesPutsAShadowsEdgeIntoItsMiddle) {
  const Image<float> out = filled_depth(from_all_sides, shadow_scene());
  for (int y = 0; y < 20; ++y) {
    EXPECT_EQ(out(25, y), 1.0f);
    EXPECT_EQ(out(26, y), 2.0f);
  }
}

TEST(FillMissing, FromTheFarSideGivesAShadowToTheBackground) {
  for (const FillParams& params : {from_the_far_side, FillParams{}}) {
    const Image<float> out = filled_depth(params, shadow_scene());
    for (int y = 0; y < 20; ++y)
      for (int x = 20; x < 32; ++x) EXPECT_EQ(out(x, y), 2.0f) << x;
  }
}

TEST(FillMissing, LeavesAFrameWithoutAnyDepthMissing) {
  const Image<float> nothing(Size{33, 9});
  EXPECT_TRUE(same_image(filled_depth(from_all_sides, nothing), nothing));
}

TEST(FillMissing, IsTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (FillParams params : {FillParams{}, from_all_sides}) {
      params.max_passes = depth.width() > 100 ? 3 : params.max_passes;
      expect_same_on_every_executor([&](auto& executor) { return filled(executor, params, depth); });
    }
  });
}

}  // namespace
}  // namespace facet
