#include "core/depth_noise.hpp"

#include <gtest/gtest.h>

#include "core/sensor.hpp"

namespace facet {
namespace {

// Nguyen, Izadi and Lovell 2012, equation 3: sigma_z = 0.0012 + 0.0019 (z - 0.4)^2.
TEST(DepthNoise, OfKinectV1FollowsThePublishedModel) {
  EXPECT_NEAR(kinect_v1_noise().sigma_m(0.4f), 0.0012, 1e-8);
  EXPECT_NEAR(kinect_v1_noise().sigma_m(1.0f), 0.001884, 1e-7);
  EXPECT_NEAR(kinect_v1_noise().sigma_m(3.0f), 0.014044, 1e-6);
}

TEST(DepthNoise, OfStereoGrowsWithTheSquareOfDepth) {
  const DepthNoise stereo = stereo_noise();
  const float floor_m = stereo.sigma_m(0);
  EXPECT_NEAR(stereo.sigma_m(4) - floor_m, 4 * (stereo.sigma_m(2) - floor_m), 1e-6);
}

TEST(DepthNoise, OfAzureKinectStaysBelowItsDataSheet) {
  for (float z = 0.5f; z <= 3.86f; z += 0.1f) EXPECT_LT(azure_kinect_noise().sigma_m(z), 0.017f);
}

TEST(Sensor, ThatIsNotDeclaredIsTakenAsKinectV1) {
  EXPECT_EQ(noise_of(Sensor::automatic).sigma_m(2), kinect_v1_noise().sigma_m(2));
  EXPECT_EQ(noise_of(Sensor::kinect_v1).sigma_m(2), kinect_v1_noise().sigma_m(2));
  EXPECT_EQ(noise_of(Sensor::azure_kinect).sigma_m(2), azure_kinect_noise().sigma_m(2));
  EXPECT_EQ(noise_of(Sensor::stereo).sigma_m(2), stereo_noise().sigma_m(2));
}

}  // namespace
}  // namespace facet
