#include "synth/kinect_v1.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "synth/flat_rendering.hpp"

namespace facet {
namespace {

KinectV1 without_effects() {
  KinectV1 sensor;
  sensor.axial_noise = AxialNoise::none;
  sensor.quantisation = sensor.lateral_noise = sensor.shadow = sensor.window_matching = sensor.dropouts =
      sensor.registration_border = false;
  return sensor;
}

TEST(KinectV1, WithoutEffectsTheReadingIsExact) {
  const Image<float> depth = measure(without_effects(), wall(1.2345f), test_camera, 1);
  EXPECT_NEAR(depth(7, 9), 1.2345f, 1e-6);
  EXPECT_NEAR(depth(319, 239), 1.2345f, 1e-6);
}

TEST(KinectV1, DisparitiesAreMultiplesOfAnEighthOfAPixel) {
  const Image<float> depth = measure(KinectV1{}, wall(1.3f), test_camera, 1);
  int read = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      if (depth(x, y) == 0) continue;
      const float eighths = 8 * 43.2f / depth(x, y);
      ASSERT_NEAR(eighths, std::round(eighths), 1e-3);
      ++read;
    }
  }
  EXPECT_GT(read, 40000);
}

TEST(KinectV1, AxialNoiseHasTheDeviationOfThePublishedFormulas) {
  KinectV1 sensor = without_effects();
  for (const float z : {0.8f, 1.0f, 2.0f}) {
    sensor.axial_noise = AxialNoise::nguyen;
    const double nguyen = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    EXPECT_NEAR(spread_of(measure(sensor, wall(z), test_camera, 11)).deviation, nguyen, 0.06 * nguyen) << z;
    sensor.axial_noise = AxialNoise::khoshelham;
    const double khoshelham = 0.001425 * z * z;
    const Spread spread = spread_of(measure(sensor, wall(z), test_camera, 11));
    EXPECT_NEAR(spread.deviation, khoshelham, 0.06 * khoshelham) << z;
    EXPECT_NEAR(spread.mean, z, 0.2 * khoshelham);
  }
}

TEST(KinectV1, AxialNoiseIsNormallyDistributed) {
  KinectV1 sensor = without_effects();
  sensor.axial_noise = AxialNoise::khoshelham;
  const Image<float> depth = measure(sensor, wall(1), test_camera, 3);
  const Spread spread = spread_of(depth);
  int within[3] = {};
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      for (int k = 0; k < 3; ++k)
        within[k] += std::abs(depth(x, y) - spread.mean) < (k + 1) * spread.deviation;
    }
  }
  EXPECT_NEAR(within[0] / 76800.0, 0.6827, 0.02);
  EXPECT_NEAR(within[1] / 76800.0, 0.9545, 0.01);
  EXPECT_NEAR(within[2] / 76800.0, 0.9973, 0.005);
}

TEST(KinectV1, TheScaleMultipliesTheNoise) {
  KinectV1 sensor = without_effects();
  sensor.axial_noise = AxialNoise::khoshelham;
  const double once = spread_of(measure(sensor, wall(1), test_camera, 4)).deviation;
  sensor.scale = 4;
  EXPECT_NEAR(spread_of(measure(sensor, wall(1), test_camera, 4)).deviation, 4 * once, 0.1 * once);
  sensor.scale = 0;
  EXPECT_LT(spread_of(measure(sensor, wall(1), test_camera, 4)).deviation, 1e-5);
}

TEST(KinectV1, ShadowLiesLeftOfANearerObjectAndIsAsWideAsTheDisparityDifference) {
  KinectV1 sensor = without_effects();
  sensor.shadow = true;
  const Image<float> depth = measure(sensor, wall_with_plate(1.0f, 0.8f), test_camera, 1);
  int left = 0, right = 0;
  for (int x = 0; x < 150; ++x) left += depth(x, 100) == 0;
  for (int x = 150; x < 320; ++x) right += depth(x, 100) == 0;
  EXPECT_NEAR(left, 525 * 0.075 * (1 / 0.8 - 1 / 1.0), 1.5);  // 9.8 px
  EXPECT_EQ(right, 0);
}

TEST(KinectV1, WindowMatchingGivesOneSideOrNothingNeverADepthBetween) {
  KinectV1 sensor = without_effects();
  sensor.window_matching = true;
  const Image<float> depth = measure(sensor, wall_with_plate(1.2f, 0.8f), test_camera, 1);
  int missing = 0, displaced = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const float z = depth(x, y);
      const bool plate = x >= 150 && x < 200 && y >= 60 && y < 180;
      missing += z == 0;
      if (z == 0) continue;
      ASSERT_TRUE(std::abs(z - 0.8f) < 1e-4f || std::abs(z - 1.2f) < 1e-4f) << z;
      displaced += plate != (z < 1);
    }
  }
  EXPECT_GT(missing + displaced, 20);   // the outline of 340 px is ragged ...
  EXPECT_LT(missing + displaced, 800);  // ... within a few pixels
}

TEST(KinectV1, OutlinesAreDisplacedByAboutThePublishedLateralNoise) {
  KinectV1 sensor = without_effects();
  sensor.lateral_noise = true;
  double squares = 0;
  int rows = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Image<float> depth = measure(sensor, wall_with_plate(1.2f, 0.8f), test_camera, seed);
    for (int y = 80; y < 160; y += 8) {
      int edge = 0;  // near pixels left of the middle of the plate, without displacement 25
      for (int x = 100; x < 175; ++x) edge += depth(x, y) < 1;
      squares += (edge - 25.0) * (edge - 25.0);
      ++rows;
    }
  }
  EXPECT_NEAR(std::sqrt(squares / rows), 0.8, 0.3);
}

TEST(KinectV1, GrazingSurfacesLoseReadings) {
  KinectV1 sensor = without_effects();
  sensor.dropouts = true;
  sensor.dropout_share = 0;
  const auto missing = [&](float tilt) {
    const Image<float> depth = measure(sensor, wall(1.5f, tilt), test_camera, 2);
    int count = 0;
    for (int y = 0; y < 240; ++y) count += depth(160, y) == 0;
    return count / 240.0;
  };
  EXPECT_EQ(missing(1.0f), 0);
  EXPECT_GT(missing(1.45f), 0.2);
  EXPECT_LT(missing(1.45f), 0.7);
}

TEST(KinectV1, ReadingsOutsideTheRangeAreMissing) {
  EXPECT_EQ(measure(without_effects(), wall(0.3f), test_camera, 1)(5, 5), 0);
  EXPECT_EQ(measure(without_effects(), wall(9.0f), test_camera, 1)(5, 5), 0);
}

TEST(KinectV1, TheSeedAloneDecidesTheNoise) {
  const Image<float> a = measure(KinectV1{}, wall(1), test_camera, 1),
                     b = measure(KinectV1{}, wall(1), test_camera, 1),
                     c = measure(KinectV1{}, wall(1), test_camera, 2);
  int equal_c = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      ASSERT_EQ(a(x, y), b(x, y));
      equal_c += a(x, y) == c(x, y);
    }
  }
  EXPECT_LT(equal_c, 0.7 * 320 * 240);  // missing stays missing, and steps are coarse
}

}  // namespace
}  // namespace facet
