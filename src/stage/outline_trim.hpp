#pragma once

#include "core/image_view.hpp"
#include "core/sensor.hpp"

namespace facet {

/// Sensors that match windows see near objects too large: within half a window of its outline the nearer
/// surface wins.
struct OutlineParams {
  float fattening_px = -1;  ///< how far near outlines reach beyond the surface [px], 0..8; -1 = as the sensor
  float jump_ratio = 0.03f;  ///< least jump at an outline, relative to depth [m/m], 0..1: 76 degrees of slope
};

inline float fattening_px(const OutlineParams& params, Sensor sensor) {
  return params.fattening_px < 0 ? fattening_px_of(sensor) : params.fattening_px;
}

/// Drops a reading where a surface behind begins within the radius. `background_m`: the readings with their
/// holes filled from behind, since an outline may border on missing depth.
struct TrimOutlineOp {
  int radius;  ///< [px]
  float squared_radius;
  float jump_ratio;
  ImageView<const float> background_m;
  ImageView<float> depth_m;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    float farthest = 0;
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        const bool inside = static_cast<float>(dx * dx + dy * dy) <= squared_radius;
        const float z = inside ? access.clamped(background_m, x + dx, y + dy) : 0.0f;
        farthest = z > farthest ? z : farthest;
      }
    const float z = depth_m(x, y);
    depth_m(x, y) = farthest > z + jump_ratio * z ? 0.0f : z;
  }
};

/// Makes missing what the sensor has added to near outlines; what is filled later comes from behind.
template <class Executor>
void trim_outlines(Executor& executor, float radius_px, float jump_ratio, ImageView<const float> background_m,
                   ImageView<float> depth_m) {
  executor.for_each_pixel(depth_m.size(), TrimOutlineOp{static_cast<int>(radius_px), radius_px * radius_px,
                                                        jump_ratio, background_m, depth_m});
}

}  // namespace facet
