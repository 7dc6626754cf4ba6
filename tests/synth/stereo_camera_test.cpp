#include "synth/stereo_camera.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "synth/flat_rendering.hpp"

namespace facet {
namespace {

StereoCamera without_effects() {
  StereoCamera sensor;
  sensor.disparity_noise = sensor.fattening = sensor.occlusion = sensor.smoothing = sensor.quantisation =
      false;
  return sensor;
}

TEST(StereoCamera, WithoutEffectsTheReadingIsExact) {
  EXPECT_EQ(measure(without_effects(), wall(1.5f), test_camera, 1)(17, 3), wall(1.5f).depth_m(17, 3));
}

TEST(StereoCamera, DisparityNoiseHasTheGivenDeviation) {
  StereoCamera sensor = without_effects();
  sensor.disparity_noise = true;
  for (const float z : {0.6f, 1.0f, 1.5f}) {
    double squares = 0;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {  // the noise is correlated: one frame says little
      const Image<float> depth = measure(sensor, wall(z), test_camera, seed);
      for (int y = 0; y < 240; y += 10) {
        for (int x = 0; x < 320; x += 10) squares += std::pow(depth(x, y) - z, 2) / (30 * 24 * 32);
      }
    }
    const double expected = 0.08 * z * z / (525 * 0.05);
    EXPECT_NEAR(std::sqrt(squares), expected, 0.06 * expected) << z;
  }
}

TEST(StereoCamera, NearObjectsGrowByHalfAMatchingWindow) {
  StereoCamera sensor = without_effects();
  sensor.fattening = true;
  const Image<float> depth = measure(sensor, wall_with_plate(1.2f, 0.8f), test_camera, 1);
  double grown = 0;
  for (int y = 80; y < 160; ++y) {
    int width = 0;
    for (int x = 0; x < 320; ++x) width += depth(x, y) < 1;
    ASSERT_GE(width, 50 + 6);
    ASSERT_LE(width, 50 + 11);
    grown += (width - 50) / 2.0 / 80;
  }
  EXPECT_NEAR(grown, 4.3, 0.8);
}

TEST(StereoCamera, TheOcclusionBandLiesOnTheLeftSideAlone) {
  StereoCamera sensor = without_effects();
  sensor.occlusion = true;
  const Image<float> depth = measure(sensor, wall_with_plate(1.2f, 0.8f), test_camera, 1);
  int left = 0, right = 0, border = 0;
  for (int x = 60; x < 150; ++x) left += depth(x, 100) == 0;
  for (int x = 150; x < 320; ++x) right += depth(x, 100) == 0;
  for (int x = 0; x < 60; ++x) border += depth(x, 20) == 0;
  EXPECT_NEAR(left, 525 * 0.05 * (1 / 0.8 - 1 / 1.2), 1.5);
  EXPECT_EQ(right, 0);
  EXPECT_NEAR(border, 525 * 0.05 / 1.2, 1);
}

TEST(StereoCamera, CreasesAreSmoothedAndPlanesAreNot) {
  StereoCamera sensor = without_effects();
  sensor.smoothing = true;
  const Image<float> plane = measure(sensor, wall(1, 0.6f), test_camera, 1);
  EXPECT_NEAR(plane(160, 120), wall(1, 0.6f).depth_m(160, 120), 1e-5);
  Rendering crease = wall(1);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      crease.depth_m(x, y) = 1 / (1 - std::abs(static_cast<float>(x) - test_camera.cx) / test_camera.fx);
    }
  }
  EXPECT_GT(measure(sensor, crease, test_camera, 1)(159, 120), crease.depth_m(159, 120) + 0.002f);
}

TEST(StereoCamera, ReadingsAreWholeMillimetres) {
  const Image<float> depth = measure(StereoCamera{}, wall(1), test_camera, 1);
  for (int x = 60; x < 320; ++x) EXPECT_NEAR(depth(x, 120) * 1000, std::round(depth(x, 120) * 1000), 1e-3);
}

}  // namespace
}  // namespace facet
