#pragma once

#include "core/host_device.hpp"

namespace facet {

/// Standard deviation of one depth reading as a function of depth [m]: a + b (z - z0)^2.
struct DepthNoise {
  float a_m = 0.0012f;      ///< noise at the reference depth [m]
  float b_per_m = 0.0019f;  ///< quadratic growth [1/m]
  float z0_m = 0.4f;        ///< reference depth [m]
  /// Pixels per independent reading: by how much the mean over squares of 16 to 24 px varies more than that
  /// of independent pixels would, since neighbours share matching windows.
  float pixels_per_reading = 20;

  FACET_HD float sigma_m(float depth_m) const {
    const float d = depth_m - z0_m;
    return a_m + b_per_m * d * d;
  }
};

/// Kinect v1: axial noise of Nguyen, Izadi and Lovell, 3DIMPVT 2012; readings shared as on table-tops of OSD
/// (16 to 33 px).
FACET_HD inline DepthNoise kinect_v1_noise() {
  return {0.0012f, 0.0019f, 0.4f, 20.0f};
}
/// Azure Kinect, NFOV: assumption 0.6 mm + 0.5 mm z^2, under the data sheet's 17 mm at every range it gives;
/// readings shared as in a frame of one (73 px).
FACET_HD inline DepthNoise azure_kinect_noise() {
  return {0.0006f, 0.0005f, 0.0f, 70.0f};
}
/// Active stereo, 50 mm baseline, f = 613 px, sub-pixel error 0.08 px: sigma = 0.08 z^2 / (f b) = 0.0026 z^2;
/// readings shared as in frames of a RealSense-like camera (97 to 122 px).
FACET_HD inline DepthNoise stereo_noise() {
  return {0.0002f, 0.0026f, 0.0f, 100.0f};
}

}  // namespace facet
