#include "dataset/lens.hpp"

#include <cmath>

namespace facet {

std::optional<RayPoint> LensModel::distort(RayPoint ideal) const {
  const double x = ideal.x - centre_x, y = ideal.y - centre_y;
  const double r2 = x * x + y * y, r4 = r2 * r2, r6 = r4 * r2;
  if (largest_radius > 0 && r2 > largest_radius * largest_radius) return std::nullopt;
  const double below = 1 + k[3] * r2 + k[4] * r4 + k[5] * r6;
  const double radial = (1 + k[0] * r2 + k[1] * r4 + k[2] * r6) / below;
  if (!(radial > 0) || !std::isfinite(radial)) return std::nullopt;
  const double cross = halved_cross_terms ? x * y : 2 * x * y;
  return RayPoint{x * radial + p2 * (r2 + 2 * x * x) + p1 * cross + centre_x,
                  y * radial + p1 * (r2 + 2 * y * y) + p2 * cross + centre_y};
}

Image<std::int32_t> undistortion_map(const LensModel& lens, Size size) {
  Image<std::int32_t> map(size);
  const Camera& camera = lens.camera;
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      map(u, v) = -1;
      const auto seen =
          lens.distort({(u - double{camera.cx}) / camera.fx, (v - double{camera.cy}) / camera.fy});
      if (!seen) continue;
      const double x = std::floor(seen->x * camera.fx + camera.cx + 0.5);
      const double y = std::floor(seen->y * camera.fy + camera.cy + 0.5);
      if (!(x >= 0 && y >= 0 && x < size.width && y < size.height)) continue;
      map(u, v) = static_cast<std::int32_t>(y) * size.width + static_cast<std::int32_t>(x);
    }
  }
  return map;
}

}  // namespace facet
