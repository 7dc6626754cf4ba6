#include "stage/outline_trim.hpp"

#include <gtest/gtest.h>

#include "support/every_executor.hpp"

namespace facet {
namespace {

constexpr Size size{40, 30};
constexpr float near_m = 0.8f, far_m = 1.2f;

/// A near disc of radius 8 before a far wall, as a sensor sees it that makes it 3 px larger.
bool is_on_disc(int x, int y, float radius_px) {
  const auto dx = static_cast<float>(x - 20), dy = static_cast<float>(y - 15);
  return dx * dx + dy * dy <= radius_px * radius_px;
}
Image<float> fattened_disc() {
  Image<float> depth(size, far_m);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (is_on_disc(x, y, 11)) depth(x, y) = near_m;
  return depth;
}

template <class Executor>
Image<float> trimmed(Executor& executor, float radius_px, const Image<float>& background,
                     Image<float> depth) {
  trim_outlines(executor, radius_px, 0.03f, background.view(), depth.view());
  return depth;
}

TEST(OutlineTrim, DropsWhatTheSensorAddedAndNothingElse) {
  CpuExecutor executor;
  const Image<float> seen = fattened_disc(), depth = trimmed(executor, 3, seen, seen);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const bool seen_near = is_on_disc(x, y, 11);
      if (is_on_disc(x, y, 7.5f) || !seen_near) {
        EXPECT_EQ(depth(x, y), seen_near ? near_m : far_m) << x << ' ' << y;
      } else if (!is_on_disc(x, y, 9)) {
        EXPECT_EQ(depth(x, y), 0) << x << ' ' << y;
      }
    }
}

TEST(OutlineTrim, AnOutlineBesideMissingDepthIsTrimmedByWhatLiesBehind) {
  CpuExecutor executor;
  const Image<float> behind = fattened_disc();
  Image<float> seen = behind;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < 20; ++x)
      if (!is_on_disc(x, y, 11)) seen(x, y) = 0;
  const Image<float> depth = trimmed(executor, 3, behind, seen);
  EXPECT_EQ(depth(10, 15), 0);
  EXPECT_EQ(depth(30, 15), 0);
  EXPECT_EQ(depth(14, 15), near_m);
}

TEST(OutlineTrim, KeepsSteepSurfacesAndSmallSteps) {
  CpuExecutor executor;
  Image<float> depth(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)  // 65 degrees at a focal length of 600 px, and a step of 5 mm
      depth(x, y) = 1 / (1.0f - static_cast<float>(x) * 0.0035f) + (y < 15 ? 0.005f : 0.0f);
  const Image<float> kept = trimmed(executor, 3.5f, depth, depth);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) EXPECT_EQ(kept(x, y), depth(x, y));
}

TEST(OutlineTrim, IsTheSameOnEveryExecutor) {
  const Image<float> seen = fattened_disc();
  for (const float radius_px : {0.5f, 2.0f, 4.5f})
    expect_same_on_every_executor([&](auto& executor) { return trimmed(executor, radius_px, seen, seen); });
}

TEST(OutlineTrim, OnlyStereoFattensUnlessToldOtherwise) {
  EXPECT_EQ(fattening_px({}, Sensor::stereo), 3.5f);
  EXPECT_EQ(fattening_px({}, Sensor::kinect_v1), 0);
  EXPECT_EQ(fattening_px({.fattening_px = 0}, Sensor::stereo), 0);
  EXPECT_EQ(fattening_px({.fattening_px = 2}, Sensor::azure_kinect), 2);
}

}  // namespace
}  // namespace facet
