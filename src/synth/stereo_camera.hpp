#pragma once

#include <cstdint>

#include "synth/render.hpp"

namespace facet {

inline Size stereo_camera_size() {
  return {640, 480};
}
inline Camera stereo_camera() {
  return {613.0f, 613.0f, 319.5f, 239.5f};
}

/// Active stereo camera in the manner of a RealSense D4xx: 50 mm baseline, block matching, second imager to
/// the right.
struct StereoCamera {
  float scale = 1;              ///< factor on the disparity noise, >= 0
  bool disparity_noise = true;  ///< sub-pixel error of `sigma_px`, correlated over the matching windows
  bool fattening = true;        ///< near objects grow by half a window of 7 to 11 px
  bool occlusion = true;  ///< what the second imager does not see is missing, with a band at the left border
  bool smoothing = true;  ///< disparities are averaged over a window within a surface
  bool quantisation = true;  ///< whole millimetres
  float baseline_m = 0.05f;
  float sigma_px = 0.08f;  ///< deviation of the disparity [px]
  float nearest_m = 0.25f, farthest_m = 6.0f;
};

/// Depth [m] as the camera reports it, 0 = missing.
Image<float> measure(const StereoCamera& sensor, const Rendering& scene, const Camera& camera,
                     std::uint64_t seed);

}  // namespace facet
