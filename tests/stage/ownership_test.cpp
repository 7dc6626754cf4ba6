#include "stage/ownership.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

using Labels = Image<std::uint16_t>;
constexpr float jump_ratio = 0.02f, noise_sigmas = 4;

template <class Executor>
Labels given_back(Executor& executor, const Image<float>& depth, const Labels& label) {
  Labels out = label, choice(label.size());
  Mask open(label.size());
  give_back_pixels(executor, jump_ratio, noise_sigmas, kinect_v1_noise(), depth.view(), out.view(),
                   open.view(), choice.view());
  return out;
}
Labels given_back(const Image<float>& depth, const Labels& label) {
  CpuExecutor executor;
  return given_back(executor, depth, label);
}

/// Patches of labels 1 to 5 between lines of unowned pixels.
Labels patches(Size size, int line_px) {
  return make_image<std::uint16_t>(size, [&](int x, int y) {
    const bool on_line = x % 12 < line_px || y % 12 < line_px;
    return on_line ? 0 : 1 + (x / 12 + 3 * (y / 12)) % 5;
  });
}

float largest_step(float depth_m) {
  return std::max(jump_ratio * depth_m, noise_sigmas * kinect_v1_noise().sigma_m(depth_m));
}

TEST(Ownership, LeavesNoGapBetweenTouchingSurfaces) {
  const Size size{60, 40};
  const Labels label = given_back(Image<float>(size, 1.0f), patches(size, 3));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) EXPECT_GT(label(x, y), 0);
}

TEST(Ownership, GivesADepthEdgeToTheSurfaceAtItsOwnDepth) {
  const Size size{30, 9};
  const auto depth = make_image<float>(size, [](int x, int) { return x <= 14 ? 1.0f : 1.5f; });
  for (const int edge_x : {14, 15}) {  // the edge on either side of the jump
    const auto label = make_image<std::uint16_t>(size, [&](int x, int) {
      return x < edge_x ? 1 : x > edge_x ? 2 : 0;
    });
    const Labels out = given_back(depth, label);
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 30; ++x)
        if (label(x, y) == 0) {
          EXPECT_EQ(out(x, y), x <= 14 ? 1 : 2);
        }
  }
}

TEST(Ownership, GivesAPixelToTheNeighbourNearestInDepth) {
  const auto depth = make_image<float>({3, 1}, [](int x, int) {
    return x == 0 ? 0.995f : x == 1 ? 1.0f : 1.002f;
  });
  const auto label = make_image<std::uint16_t>({3, 1}, [](int x, int) {
    return x == 0 ? 1 : x == 1 ? 0 : 2;
  });
  EXPECT_EQ(given_back(depth, label)(1, 0), 2);
}

TEST(Ownership, DecidesTiesForTheNearerNeighbourAndThenForTheFirstClockwiseFromTheNorth) {
  const auto depth = make_image<float>({3, 1}, [](int x, int) {
    return x == 0 ? 1.0078125f : x == 1 ? 1.0f : 0.9921875f;
  });
  const auto label = make_image<std::uint16_t>({3, 1}, [](int x, int) {
    return x == 0 ? 1 : x == 1 ? 0 : 2;
  });
  EXPECT_EQ(given_back(depth, label)(1, 0), 2);
  const Image<float> level(Size{3, 1}, 1.0f);
  EXPECT_EQ(given_back(level, label)(1, 0), 2) << "the east comes before the west";
  const auto mirrored = make_image<std::uint16_t>({3, 1}, [](int x, int) {
    return x == 0 ? 2 : x == 1 ? 0 : 1;
  });
  EXPECT_EQ(given_back(level, mirrored)(1, 0), 1);
}

TEST(Ownership, LeavesPixelsAloneThatStandApartFromEverySurface) {
  const Size size{33, 9};
  const auto depth = make_image<float>(size, [](int x, int) { return x == 16 ? 0.8f : 1.0f; });
  const auto label = make_image<std::uint16_t>(size, [](int x, int) { return x == 16 ? 0 : 1; });
  EXPECT_TRUE(same_image(given_back(depth, label), label));
}

TEST(Ownership, ObeysItsLawsOnRandomDepth) {
  const Size size{60, 40};
  const Image<float> depth = random_depth(size, 5);
  const Labels before = patches(size, 4), after = given_back(depth, before);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      if (before(x, y) > 0 || depth(x, y) == 0) {
        EXPECT_EQ(after(x, y), before(x, y)) << "owned and missing pixels keep what they have";
        continue;
      }
      bool has_eligible = false, owner_is_beside = false;
      for (int ny = std::max(0, y - 1); ny <= std::min(39, y + 1); ++ny)
        for (int nx = std::max(0, x - 1); nx <= std::min(59, x + 1); ++nx) {
          if ((nx == x && ny == y) || after(nx, ny) == 0) continue;
          const bool eligible = std::abs(depth(nx, ny) - depth(x, y)) <= largest_step(depth(x, y));
          has_eligible |= eligible;
          owner_is_beside |= eligible && after(nx, ny) == after(x, y);
        }
      EXPECT_EQ(after(x, y) > 0, has_eligible) << "all that can be given back is";
      EXPECT_EQ(after(x, y) > 0, owner_is_beside) << "a surface grows over steps below a depth edge only";
    }
}

TEST(Ownership, IsTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    const Labels label = patches(depth.size(), 5);
    expect_same_on_every_executor([&](auto& executor) { return given_back(executor, depth, label); });
  });
}

}  // namespace
}  // namespace facet
