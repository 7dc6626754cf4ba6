#include "surface/validation.hpp"

#include <algorithm>

namespace facet {

float least_area_px(const ValidationParams& params, const Camera& camera, float depth_m) {
  if (!params.enabled) return 1;
  const float least_m = params.min_size_mm / 1000;
  const float side_x_px = depth_m > 0 ? least_m * camera.fx / depth_m : 0;
  const float side_y_px = depth_m > 0 ? least_m * camera.fy / depth_m : 0;
  return std::max(static_cast<float>(params.min_area_px), side_x_px * side_y_px);
}

std::string_view validate_surface(const ValidationParams& params, const Surface& surface, float valid_share) {
  if (surface.contour.outer.empty()) return reject_reason::open_contour;
  if (!params.enabled) return {};
  std::size_t perimeter_px = surface.contour.outer.size();
  for (const Polyline& hole : surface.contour.holes) perimeter_px += hole.size();
  if (2.0f * static_cast<float>(surface.area_px) < params.min_width_px * static_cast<float>(perimeter_px))
    return reject_reason::sliver;
  if (valid_share < params.min_valid_share) return reject_reason::missing_depth;
  return {};
}

}  // namespace facet
