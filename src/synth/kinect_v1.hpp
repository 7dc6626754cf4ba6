#pragma once

#include <cstdint>

#include "synth/render.hpp"

namespace facet {

/// Random error along the line of sight, one standard deviation.
enum class AxialNoise {
  none,
  khoshelham,  ///< 1.425 mm z^2: Khoshelham and Elberink, Sensors 12(2), 2012
  nguyen,      ///< 1.2 mm + 1.9 mm (z - 0.4)^2, more beyond 60 deg: Nguyen, Izadi and Lovell, 3DIMPVT 2012
  measured,    ///< 0.079 px of disparity (1.83 mm z^2 before rounding): fitted to frames of OSD, 0.6 to 1.7 m
};

/// Kinect v1: structured light, 75 mm baseline, projector to the right of the camera. Every effect has a
/// switch; `scale` multiplies the size of the random errors (0: none) but neither the disparity step nor what
/// geometry hides.
struct KinectV1 {
  float scale = 1;  ///< factor on axial and lateral noise and on the dropout rate, >= 0
  AxialNoise axial_noise = AxialNoise::measured;  ///< correlated over the 9x9 window of the matching
  bool quantisation = true;                       ///< disparity in steps of 1/8 px
  bool lateral_noise = true;                      ///< outlines displaced by about 0.8 px (Nguyen et al.)
  bool shadow = true;                             ///< points that the projector does not reach are missing
  bool window_matching = true;  ///< near a jump the 9x9 window of dots decides: either side, or missing
  bool dropouts = true;         ///< missing readings at grazing incidence and at random
  bool registration_border =
      true;  ///< missing top rows and right columns of frames mapped to the colour camera
  float focal_baseline_px_m = 43.2f;  ///< f b of the depth camera [px m]
  float baseline_m = 0.075f;
  float dropout_share = 0.0005f;              ///< share of readings lost at random, 0..1
  float nearest_m = 0.5f, farthest_m = 5.0f;  ///< range
};

/// Depth [m] as the sensor reports it, 0 = missing. Depends on the arguments alone; frames of a sequence
/// differ by `seed`.
Image<float> measure(const KinectV1& sensor, const Rendering& scene, const Camera& camera,
                     std::uint64_t seed);

}  // namespace facet
