#include "synth/kinect_v1.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "synth/quickstart.hpp"

namespace facet {
namespace {

/// A frontal wall at `depth_m`.
Rendering wall(float depth_m) {
  Rendering image;
  image.depth_m = Image<float>({320, 240}, depth_m);
  image.normals = Image<Vec3>({320, 240}, Vec3{0, 0, -1});
  return image;
}
constexpr Camera camera{525, 525, 159.5f, 119.5f};

KinectV1 without_effects() {
  KinectV1 sensor;
  sensor.quantisation = sensor.axial_noise = sensor.lateral_noise = sensor.shadow = sensor.dropouts = false;
  return sensor;
}

TEST(KinectV1, WithoutEffectsTheReadingIsExact) {
  const Image<float> depth = measure(without_effects(), wall(1.2345f), camera, 1);
  EXPECT_NEAR(depth(7, 9), 1.2345f, 1e-6);
  EXPECT_NEAR(depth(319, 239), 1.2345f, 1e-6);
}

TEST(KinectV1, DisparitiesAreMultiplesOfAnEighthOfAPixel) {
  KinectV1 sensor;
  const Image<float> depth = measure(sensor, wall(1.3f), camera, 1);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      if (depth(x, y) == 0) continue;
      const float eighths = 8 * 43.2f / depth(x, y);
      ASSERT_NEAR(eighths, std::round(eighths), 1e-3);
    }
  }
}

TEST(KinectV1, AxialNoiseHasTheDeviationOfNguyen) {
  KinectV1 sensor = without_effects();
  sensor.axial_noise = true;
  for (const float z : {0.8f, 1.0f, 2.0f}) {
    const Image<float> depth = measure(sensor, wall(z), camera, 11);
    double sum = 0, squares = 0;
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) sum += depth(x, y), squares += depth(x, y) * depth(x, y);
    }
    const double n = 320 * 240, mean = sum / n;
    const double expected = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
    EXPECT_NEAR(std::sqrt(squares / n - mean * mean), expected, 0.05 * expected) << z;
    EXPECT_NEAR(mean, z, 0.1 * expected);
  }
}

TEST(KinectV1, ShadowLiesLeftOfANearerObjectAndIsAsWideAsTheDisparityDifference) {
  KinectV1 sensor = without_effects();
  sensor.shadow = true;
  Rendering image = wall(1.0f);
  for (int y = 0; y < 240; ++y) {
    for (int x = 150; x < 200; ++x) image.depth_m(x, y) = 0.8f;
  }
  const Image<float> depth = measure(sensor, image, camera, 1);
  int left = 0, right = 0;
  for (int x = 0; x < 150; ++x) left += depth(x, 100) == 0;
  for (int x = 150; x < 320; ++x) right += depth(x, 100) == 0;
  EXPECT_NEAR(left, 525 * 0.075 * (1 / 0.8 - 1 / 1.0), 1.5);  // 9.8 px
  EXPECT_EQ(right, 0);
}

TEST(KinectV1, ReadingsOutsideTheRangeAreMissing) {
  EXPECT_EQ(measure(without_effects(), wall(0.3f), camera, 1)(5, 5), 0);
  EXPECT_EQ(measure(without_effects(), wall(9.0f), camera, 1)(5, 5), 0);
}

TEST(KinectV1, TheSeedAloneDecidesTheNoise) {
  const Image<float> a = measure({}, wall(1), camera, 1), b = measure({}, wall(1), camera, 1),
                     c = measure({}, wall(1), camera, 2);
  int equal_c = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      ASSERT_EQ(a(x, y), b(x, y));
      equal_c += a(x, y) == c(x, y);
    }
  }
  EXPECT_LT(equal_c, 320 * 240 / 2);
}

}  // namespace
}  // namespace facet
