#include "synth/azure_kinect.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "synth/flat_rendering.hpp"

namespace facet {
namespace {

AzureKinect without_effects() {
  AzureKinect sensor;
  sensor.random_error = sensor.systematic_error = sensor.flying_pixels = sensor.multipath = sensor.mask =
      sensor.quantisation = false;
  return sensor;
}

TEST(AzureKinect, WithoutEffectsTheReadingIsExact) {
  EXPECT_EQ(measure(without_effects(), wall(1.5f), test_camera, 1)(17, 3), wall(1.5f).depth_m(17, 3));
}

TEST(AzureKinect, RandomErrorGrowsWithDistanceAndWithLowReflectivityAndStaysUnderTheSpecification) {
  AzureKinect sensor = without_effects();
  sensor.random_error = true;
  for (const float z : {0.6f, 1.5f, 3.0f}) {
    sensor.reflectivity = 1;
    const double expected = 0.0006 + 0.0005 * z * z;
    EXPECT_NEAR(spread_of(measure(sensor, wall(z), test_camera, 5)).deviation, expected, 0.05 * expected)
        << z;
    sensor.reflectivity = 0.25f;
    EXPECT_NEAR(spread_of(measure(sensor, wall(z), test_camera, 5)).deviation, 2 * expected, 0.1 * expected)
        << z;
  }
  sensor.reflectivity = 1;
  EXPECT_LE(random_error_m(sensor, 50.0f, 0), 0.017f);
}

TEST(AzureKinect, SystematicErrorIsSmoothBoundedAndTheSameForEveryFrameOfARun) {
  AzureKinect sensor = without_effects();
  sensor.systematic_error = true;
  const Rendering image = wall(2);
  const Image<float> a = measure(sensor, image, test_camera, 1), b = measure(sensor, image, test_camera, 2);
  float largest = 0;
  for (int y = 1; y < 240; ++y) {
    for (int x = 1; x < 320; ++x) {
      ASSERT_EQ(a(x, y), b(x, y));
      largest = std::max(largest, std::abs(a(x, y) - image.depth_m(x, y)));
      ASSERT_LT(std::abs(a(x, y) - a(x - 1, y)), 0.0005f);
    }
  }
  EXPECT_LE(largest, 0.011f + 0.002f);
  EXPECT_GT(largest, 0.003f);
  sensor.run_seed = 2;
  EXPECT_NE(measure(sensor, image, test_camera, 1)(100, 100), a(100, 100));
}

TEST(AzureKinect, HalfOfThePixelsAtAJumpLieBetweenBothSidesAndTheRestIsMissing) {
  AzureKinect sensor = without_effects();
  sensor.flying_pixels = true;
  const Image<float> depth = measure(sensor, wall_with_plate(1.5f, 1.0f), test_camera, 3);
  int flying = 0, missing = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const float z = depth(x, y);
      missing += z == 0;
      flying += z > 1.0001f && z < 1.4999f;
      ASSERT_LE(z, 1.5001f);
    }
  }
  EXPECT_GT(flying, 200);
  EXPECT_NEAR(static_cast<double>(flying) / (flying + missing), 0.5, 0.06);
  EXPECT_LT(flying + missing, 2 * 2 * (50 + 120));  // at most two pixels wide
}

TEST(AzureKinect, ConcaveCornersAreRoundedTowardsTheCameraByMillimetresAndConvexOnesAreNot) {
  AzureKinect sensor = without_effects();
  sensor.multipath = true;
  for (const float sign : {-1.0f, 1.0f}) {
    Rendering image = wall(1.0f);
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        // Two walls at 45 deg that meet in the middle column, away from the camera for sign = -1.
        const float u = (static_cast<float>(x) - test_camera.cx) / test_camera.fx;
        image.depth_m(x, y) = 1.0f / (1 - sign * std::abs(u));
      }
    }
    const Image<float> depth = measure(sensor, image, test_camera, 1);
    const float moved = image.depth_m(159, 120) - depth(159, 120);
    if (sign < 0) {
      EXPECT_GT(moved, 0.002f);
      EXPECT_LT(moved, 0.010f);
    } else {
      EXPECT_NEAR(moved, 0, 1e-6);
    }
    EXPECT_NEAR(depth(100, 120), image.depth_m(100, 120), 1e-4);
  }
}

TEST(AzureKinect, TheMaskIsAHexagonAndReadingsAreWholeMillimetres) {
  const Image<float> depth = measure(AzureKinect{}, wall(1), test_camera, 1);
  EXPECT_EQ(depth(0, 0), 0);
  EXPECT_EQ(depth(319, 239), 0);
  EXPECT_GT(depth(0, 120), 0);
  EXPECT_GT(depth(160, 0), 0);
  for (int x = 0; x < 320; ++x) EXPECT_NEAR(depth(x, 120) * 1000, std::round(depth(x, 120) * 1000), 1e-3);
}

TEST(AzureKinect, ReadingsOutsideTheRangeAreMissing) {
  EXPECT_EQ(measure(without_effects(), wall(0.45f), test_camera, 1)(160, 120), 0);
  EXPECT_EQ(measure(without_effects(), wall(4.0f), test_camera, 1)(160, 120), 0);
}

}  // namespace
}  // namespace facet
