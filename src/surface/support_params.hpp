#pragma once

namespace facet {

struct SupportParams {
  bool enabled = true;
  /// Most that the support's normal leans from the camera's up, -Y [deg], 0..180: a camera that looks down by
  /// 0 to 90 degrees, and 5 more.
  float max_tilt_deg = 95;
  /// Unevenness of support and sensor at 1 m; grows with depth squared [mm], 0..1000. A book of 1 cm is none.
  float flatness_mm = 3;
  float noise_sigmas = 3;  ///< allowance for the noise of a piece's plane [standard deviations], 0..100
};

}  // namespace facet
