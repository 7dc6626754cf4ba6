#pragma once

namespace facet {

struct ValidationParams {
  bool enabled = true;
  int min_area_px = 30;          ///< least area of a surface [px], 0..1000000
  float min_size_mm = 12.0f;     ///< least side of a square of the same area at the surface's depth [mm], 0..1000
  float min_valid_share = 0.5f;  ///< least share of pixels with measured depth, 0..1
};

}  // namespace facet
