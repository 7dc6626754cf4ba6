#pragma once

#include <cstdint>

#include "core/camera.hpp"
#include "core/image_view.hpp"
#include "core/normal_views.hpp"
#include "core/vec.hpp"

namespace facet {

/// Inverse depth in fixed point, so that sums over windows are exact in any order: unit 2^-22 per metre, that
/// is 0.24 um at 1 m; depths below 2 cm are taken as 2 cm. 0 = missing.
struct InverseDepthOp {
  static constexpr int radius = 0;
  static constexpr float units_per_inverse_metre = 4194304.0f;
  ImageView<const float> depth_m;
  ImageView<std::int32_t> inverse_depth;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const float z = depth_m(x, y);
    const float safe = z > 0.02f ? z : 0.02f;
    const auto q = static_cast<std::int32_t>(units_per_inverse_metre / safe + 0.5f);
    inverse_depth(x, y) = z > 0 ? q : 0;
  }
};

/// Sums of a plane fit q = c + a dx + b dy over a full square window centred on the pixel; exact integers
/// before they were rounded to float.
struct WindowSums {
  float q = 0, dx_q = 0, dy_q = 0;
};

/// Unit normal, towards the camera, of the plane whose inverse depth has these window sums. Over a plane n .
/// P = d inverse depth is affine in pixels, and n ~ (a fx, b fy, c - a (x - cx) - b (y - cy)) (method: 1/z =
/// n . K^-1 p / d).
FACET_HD inline Vec3 normal_from_sums(const WindowSums& sums, int half_side, int x, int y,
                                      const Camera& camera) {
  const float side = static_cast<float>(2 * half_side + 1);
  const float spread = side * side * static_cast<float>(half_side * (half_side + 1)) / 3.0f;  // sum of dx^2
  const float a = sums.dx_q / spread;
  const float b = sums.dy_q / spread;
  const float c = sums.q / (side * side);
  const Vec3 away{a * camera.fx, b * camera.fy,
                  c - a * (static_cast<float>(x) - camera.cx) - b * (static_cast<float>(y) - camera.cy)};
  return normalized(-away);
}

/// Half side of the fit window: as large as asked for, but within the pixel's own side of every depth edge.
/// Windows smaller than 5x5 give no normal: on one Kinect frame a 3x3 fit is off by 26 degrees rms at 1 m.
FACET_HD inline int fit_half_side(int distance_px, int radius_px) {
  const int free_px = distance_px - 1;
  const int half = free_px < radius_px ? free_px : radius_px;
  const int least = radius_px < 2 ? radius_px : 2;
  return half >= least ? half : 0;
}

/// Normal from a plane fit in a window around the pixel; the zero vector where no window fits.
struct NormalOp {
  static constexpr int radius = 0;
  ImageView<const std::int32_t> inverse_depth;
  ImageView<const std::uint8_t> distance_px;
  int radius_px;
  Camera camera;
  NormalViews<float> normal;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const int half = fit_half_side(distance_px(x, y), radius_px);
    std::int64_t sum = 0, dx_sum = 0, dy_sum = 0;
    for (int dy = -half; dy <= half; ++dy)
      for (int dx = -half; dx <= half; ++dx) {
        const std::int64_t q = inverse_depth(x + dx, y + dy);
        sum += q;
        dx_sum += dx * q;
        dy_sum += dy * q;
      }
    const WindowSums sums{static_cast<float>(sum), static_cast<float>(dx_sum), static_cast<float>(dy_sum)};
    normal.set(x, y, half > 0 ? normal_from_sums(sums, half, x, y, camera) : Vec3{});
  }
};

template <class Executor>
void inverse_depth(Executor& executor, ImageView<const float> depth_m,
                   ImageView<std::int32_t> inverse_depth) {
  executor.for_each_pixel(depth_m.size(), InverseDepthOp{depth_m, inverse_depth});
}

/// Surface normals by plane fits in inverse depth over windows that shrink near depth edges (`distance_px`:
/// capped chessboard distance to the nearest depth edge, missing pixel or image edge, cap > radius_px).
template <class Executor>
void fit_normals(Executor& executor, int radius_px, const Camera& camera,
                 ImageView<const std::int32_t> inverse_depth, ImageView<const std::uint8_t> distance_px,
                 const NormalViews<float>& normal) {
  executor.for_each_pixel(normal.size(), NormalOp{inverse_depth, distance_px, radius_px, camera, normal});
}

}  // namespace facet
