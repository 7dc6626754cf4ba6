#pragma once

#include "core/image_view.hpp"
#include "core/vec.hpp"

namespace facet {

/// Pinhole intrinsics in pixels; pixel centres at integer coordinates.
struct Camera {
  float fx = 0, fy = 0;  ///< focal lengths [px]
  float cx = 0, cy = 0;  ///< principal point [px]

  /// P = z K^-1 [x, y, 1]^T [m] (paper section 4.2.4, whose printed form lacks the factor z outside).
  FACET_HD Vec3 back_project(float x_px, float y_px, float depth_m) const {
    return {(x_px - cx) / fx * depth_m, (y_px - cy) / fy * depth_m, depth_m};
  }
  friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace facet
