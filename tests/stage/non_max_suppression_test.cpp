#include "stage/non_max_suppression.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/topology.hpp"

namespace facet {
namespace {

template <class Executor>
Mask ridges_of(Executor& executor, const Image<float>& strength, const Mask& direction, float low,
               float high) {
  Mask ridge(strength.size(), 9);
  non_max_suppression(executor, strength.view(), direction.view(), low, high, ridge.view());
  return ridge;
}
Mask ridges_of(const Image<float>& strength, const Mask& direction, float low = 0.1f, float high = 0.5f) {
  CpuExecutor executor;
  return ridges_of(executor, strength, direction, low, high);
}

/// Strength with a maximum along the line through (30, 20) at right angles to direction4(i).
Image<float> ridge_across(int i, double offset_px) {
  const Offset d = direction4(i);
  return make_image<float>({61, 41}, [&](int x, int y) {
    const double across = ((x - 30) * d.dx + (y - 20) * d.dy) / std::hypot(d.dx, d.dy) - offset_px;
    return std::exp(-across * across / 8);
  });
}

TEST(NonMaxSuppression, LeavesOnePixelAcrossARidgeInEachOfTheFourDirections) {
  for (int i = 0; i < 4; ++i)
    for (const double offset_px : {0.0, 0.2}) {
      const Mask ridge =
          ridges_of(ridge_across(i, offset_px), Mask(Size{61, 41}, static_cast<std::uint8_t>(i)));
      const Offset d = direction4(i);
      for (int k = -10; k <= 10; ++k) {
        const int x = 30 - k * d.dy, y = 20 + k * d.dx;  // along the ridge
        int across = 0;
        for (int s = -4; s <= 4; ++s) across += ridge(x + s * d.dx, y + s * d.dy) != 0;
        EXPECT_EQ(across, 1) << "direction " << i;
        EXPECT_EQ(ridge(x, y), static_cast<std::uint8_t>(Ridge::strong));
      }
    }
}

TEST(NonMaxSuppression, MakesOneLineOfAPlateauOfTwoPixels) {
  const auto step = make_image<float>({33, 9}, [](int x, int) { return x == 15 || x == 16 ? 1.0f : 0.0f; });
  const Mask ridge = ridges_of(step, Mask(Size{33, 9}));
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 33; ++x) EXPECT_EQ(ridge(x, y) != 0, x == 15);
}

TEST(NonMaxSuppression, TellsWeakFromStrongRidgesAndDropsTheRest) {
  const auto lines = make_image<float>({33, 9}, [](int x, int) {
    return x == 5 ? 0.6f : x == 12 ? 0.5f : x == 20 ? 0.3f : x == 27 ? 0.1f : 0.0f;
  });
  const Mask ridge = ridges_of(lines, Mask(Size{33, 9}));
  EXPECT_EQ(ridge(5, 4), static_cast<std::uint8_t>(Ridge::strong));
  EXPECT_EQ(ridge(12, 4), static_cast<std::uint8_t>(Ridge::weak)) << "thresholds have to be exceeded";
  EXPECT_EQ(ridge(20, 4), static_cast<std::uint8_t>(Ridge::weak));
  EXPECT_EQ(ridge(27, 4), static_cast<std::uint8_t>(Ridge::none));
}

TEST(NonMaxSuppression, OfAConstantLeavesNothingInside) {
  const Mask ridge = ridges_of(Image<float>(Size{33, 9}, 1.0f), Mask(Size{33, 9}));
  for (int y = 0; y < 9; ++y)
    for (int x = 1; x < 33; ++x) EXPECT_EQ(ridge(x, y), 0);
}

TEST(NonMaxSuppression, IsTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& strength) {
    const auto direction =
        make_image<std::uint8_t>(strength.size(), [](int x, int y) { return (x / 3 + y / 5) % 4; });
    expect_same_on_every_executor(
        [&](auto& executor) { return ridges_of(executor, strength, direction, 0.7f, 1.5f); });
  });
}

}  // namespace
}  // namespace facet
