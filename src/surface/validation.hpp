#pragma once

#include <string_view>

#include "core/camera.hpp"
#include "surface/surface.hpp"

namespace facet {

struct ValidationParams {
  bool enabled = true;
  int min_area_px = 30;  ///< least area of a surface [px], 0..1000000
  float min_size_mm =
      12.0f;  ///< least side of a square of the same area at the surface's depth [mm], 0..1000
  float min_width_px = 3.0f;     ///< least mean width, twice the area over the perimeter [px], 0..1000
  float min_valid_share = 0.5f;  ///< least share of pixels with measured depth, 0..1
};

/// Reasons for dropping a region.
namespace reject_reason {
inline constexpr std::string_view too_small = "too_small";  ///< fewer pixels than a surface needs
inline constexpr std::string_view too_many = "too_many";    ///< the label image holds 65535 surfaces
inline constexpr std::string_view open_contour =
    "open_contour";                                   ///< no closed contour of the edge map bounds it
inline constexpr std::string_view sliver = "sliver";  ///< narrower than the sensor resolves
inline constexpr std::string_view missing_depth = "missing_depth";  ///< mostly made-up depth
}  // namespace reject_reason

/// Least area [px] of a surface seen at `depth_m`: the larger of the two limits.
float least_area_px(const ValidationParams& params, const Camera& camera, float depth_m);

/// Validation of an outlined surface (Table 3 of the paper names the step without defining it). Returns the
/// reason to drop it, or an empty string. `valid_share`: share of its pixels with measured depth.
std::string_view validate_surface(const ValidationParams& params, const Surface& surface, float valid_share);

}  // namespace facet
