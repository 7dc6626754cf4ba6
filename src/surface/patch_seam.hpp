#pragma once

#include <array>
#include <cstddef>

#include "surface/patch_fit.hpp"

namespace facet {

/// By how much two patches may differ where they meet and still be one smooth surface.
struct SeamTolerance {
  double angle_rad = 0;   ///< between their normals
  double step_ratio = 0;  ///< between their depths, relative to depth [m/m]
  double sigmas = 0;      ///< in deviations of the difference of the two fits, added in squares
};

/// Where two patches meet: points relative to the principal point [px].
struct Seam {
  static constexpr int most_points = 12;
  int count = 0;
  std::array<float, most_points> x{}, y{};

  /// The seam has room for another point.
  void add(float at_x, float at_y) {
    x[static_cast<std::size_t>(count)] = at_x, y[static_cast<std::size_t>(count)] = at_y;
    ++count;
  }
};

/// Difference of two patches along their seam: the larger one of the root mean squares of the angle and of
/// the step, over what is tolerated.
struct SeamDifference {
  double excess = 0;    ///< over the tolerance and the noise of the fits: above 1, the two are surfaces
  double expected = 0;  ///< with the noise of the fits added to it, over the tolerance alone
};
/// `seam`: at least one point; `focal_px`: of the camera.
SeamDifference seam_difference(const PatchFit& a, const PatchFit& b, const Seam& seam, double focal_px,
                               const SeamTolerance& tolerance);

}  // namespace facet
