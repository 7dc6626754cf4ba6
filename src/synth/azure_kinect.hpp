#pragma once

#include <cstdint>

#include "synth/render.hpp"

namespace facet {

inline Size azure_kinect_size() {
  return {640, 576};
}
inline Camera azure_kinect_camera() {
  return {504.0f, 504.0f, 319.5f, 287.5f};
}

/// Azure Kinect, NFOV unbinned. Range and bounds of the errors from Microsoft's hardware specification
/// (random deviation <= 17 mm, systematic error < 11 mm + 0.1 %); the growth with distance is an assumption.
struct AzureKinect {
  float scale = 1;               ///< factor on the random error, >= 0
  float reflectivity = 0.6f;     ///< of every surface, > 0..1
  bool random_error = true;      ///< min(17 mm, 0.6 mm + 0.5 mm z^2) / sqrt(reflectivity cos(incidence))
  bool systematic_error = true;  ///< smooth over the image, the same for all frames with one `run_seed`
  bool flying_pixels =
      true;                  ///< at jumps half of the readings lie between both sides, the others are missing
  bool multipath = true;     ///< concave corners are rounded by some millimetres
  bool mask = true;          ///< hexagonal field of the illumination
  bool quantisation = true;  ///< whole millimetres
  std::uint64_t run_seed = 1;
  float nearest_m = 0.5f, farthest_m = 3.86f;
};

/// Depth [m] as the sensor reports it, 0 = missing.
Image<float> measure(const AzureKinect& sensor, const Rendering& scene, const Camera& camera,
                     std::uint64_t seed);

/// Standard deviation of a reading [m].
float random_error_m(const AzureKinect& sensor, float depth_m, float incidence_rad);

}  // namespace facet
