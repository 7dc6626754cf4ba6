#pragma once

#include <cstdint>
#include <optional>

#include "core/camera.hpp"
#include "core/image.hpp"

namespace facet {

/// A point on the plane at z = 1 of a camera.
struct RayPoint {
  double x = 0, y = 0;
};

/// A camera whose lens distorts by the rational model with six radial and two tangential coefficients, as the
/// Azure Kinect's cameras are calibrated.
struct LensModel {
  Camera camera;                      ///< without the lens [px]
  double k[6]{};                      ///< radial: numerator r^2, r^4, r^6, then denominator
  double p1 = 0, p2 = 0;              ///< tangential
  double centre_x = 0, centre_y = 0;  ///< of distortion, at z = 1
  bool halved_cross_terms = false;    ///< 6KT: p x y where Brown and Conrady have 2 p x y
  double largest_radius = 0;          ///< the model holds up to here, at z = 1; 0 = everywhere

  /// Where the lens shows what lies at `ideal`; nothing outside the model's reach.
  std::optional<RayPoint> distort(RayPoint ideal) const;
};

/// For every pixel of the camera without lens, the pixel of the recorded image (row * width + column) that
/// shows its ray, the nearest one, as depth must not be mixed; -1 where there is none.
Image<std::int32_t> undistortion_map(const LensModel& lens, Size size);

}  // namespace facet
