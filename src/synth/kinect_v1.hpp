#pragma once

#include <cstdint>

#include "synth/render.hpp"

namespace facet {

/// Kinect v1: structured light, 75 mm baseline, projector to the right of the camera. Every effect has a
/// switch; `scale` multiplies the size of the random errors (0: none) but not the disparity step. Sources:
/// Khoshelham and Elberink, Sensors 12(2), 2012; Nguyen, Izadi and Lovell, 3DIMPVT 2012.
struct KinectV1 {
  float scale = 1;                    ///< factor on axial and lateral noise and on the dropout rate, >= 0
  bool quantisation = true;           ///< disparity in steps of 1/8 px
  bool axial_noise = true;            ///< sigma of Nguyen et al., correlated over a few pixels
  bool lateral_noise = true;          ///< outlines displaced by about 0.8 px
  bool shadow = true;                 ///< points that the projector does not reach are missing
  bool dropouts = true;               ///< missing readings at grazing incidence and at random
  float focal_baseline_px_m = 43.2f;  ///< f b of the depth camera [px m]
  float baseline_m = 0.075f;
  float dropout_share = 0.002f;               ///< share of readings lost at random, 0..1
  float nearest_m = 0.5f, farthest_m = 5.0f;  ///< range
};

/// Depth [m] as the sensor reports it, 0 = missing. Depends on the arguments alone; frames of a sequence
/// differ by `seed`.
Image<float> measure(const KinectV1& sensor, const Rendering& scene, const Camera& camera,
                     std::uint64_t seed);

}  // namespace facet
