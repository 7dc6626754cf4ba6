#pragma once

#include <array>
#include <string_view>

#include "core/depth_noise.hpp"

namespace facet {

/// Sensors whose depth noise is known. `automatic` takes what the data set declares, and Kinect v1 (the
/// paper's own test sensor) where it declares nothing.
enum class Sensor { automatic, kinect_v1, azure_kinect, stereo };

/// Their names, in order of the values, as configs and data sets spell them.
inline constexpr std::array<std::string_view, 4> sensor_names{"auto", "kinect_v1", "azure_kinect", "stereo"};

FACET_HD inline DepthNoise noise_of(Sensor sensor) {
  switch (sensor) {
    case Sensor::azure_kinect:
      return azure_kinect_noise();
    case Sensor::stereo:
      return stereo_noise();
    default:
      return kinect_v1_noise();
  }
}

/// How far near outlines reach beyond the surface at least [px]: half a matching window, which has 7 px or
/// more, for stereo. Structured light and time of flight add nothing beyond their lateral noise.
inline float fattening_px_of(Sensor sensor) {
  return sensor == Sensor::stereo ? 3.5f : 0.0f;
}

}  // namespace facet
