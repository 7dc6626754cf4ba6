#pragma once

namespace facet {

enum class CreaseMode {
  normals,   ///< angle between the normals of plane fits on both sides of the pixel
  paper,     ///< eq. 6: gradient of the direction of the depth gradient
  gaussian,  ///< section 3.2: gradient of the Gaussian curvature
};
enum class CreaseAngle {
  atan2,  ///< full direction, differences wrapped to +-180 degrees
  atan,   ///< eq. 6 as printed: opposite gradients fold onto each other
};

struct CreaseParams {
  CreaseMode mode = CreaseMode::normals;
  CreaseAngle angle = CreaseAngle::atan2;  ///< paper mode only
  bool weighted = true;       ///< paper mode: damp directions whose gradient is below its own noise
  int radius_px = 4;          ///< normals: half side of the fit window [px], 1..16
  float high_deg = 25.0f;     ///< upper threshold on the change of direction across the pixel [deg], 0..180
  float low_deg = 12.0f;      ///< lower threshold [deg], 0..180
  int depth_guard_px = 3;     ///< no crease within this distance of a depth edge [px], 0..16
};

}  // namespace facet
