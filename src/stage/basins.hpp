#pragma once

#include <cstdint>

#include "core/image_view.hpp"
#include "core/neighbours.hpp"
#include "core/pixel_forest.hpp"

namespace facet {

/// Height of the landscape that water runs down: the crease strength where it is known; where a depth edge is too
/// near for it, above every known strength and falling away from the edge, so that such pixels are reached last and
/// from the inside. Barriers (depth edges, missing pixels) are infinitely high.
struct CreaseHeight {
  static constexpr float unknown = 4.0f;  ///< above the largest chord, 2
  static constexpr float barrier = 1e9f;
  ImageView<const float> strength;
  ImageView<const std::uint8_t> distance_px;
  int guard_px;

  FACET_HD bool known(int x, int y) const { return distance_px(x, y) > guard_px; }
  FACET_HD float operator()(int x, int y) const {
    const int distance = distance_px(x, y);
    if (distance == 0) return barrier;
    return distance > guard_px ? strength(x, y) : unknown + static_cast<float>(guard_px - distance);
  }
};

/// Points every pixel at the lowest of its 4-neighbours if that is lower (of equal heights, the earlier pixel is
/// lower), so that following the pointers ends in a local minimum. -1 on barriers.
struct DescendOp {
  static constexpr int radius = 0;
  CreaseHeight height;
  ImageView<std::int32_t> next;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    float lowest = height(x, y);
    std::int32_t target = y * next.width + x;
    if (lowest >= CreaseHeight::barrier) {
      next(x, y) = -1;
      return;
    }
    for (int i = 0; i < 8; i += 2) {
      const int nx = x + neighbour8(i).dx, ny = y + neighbour8(i).dy;
      if (!next.size().contains(nx, ny)) continue;
      const float h = height(nx, ny);
      const std::int32_t index = ny * next.width + nx;
      if (h < lowest || (h == lowest && index < target)) lowest = h, target = index;
    }
    next(x, y) = target;
  }
};

/// Catchment basins of the crease strength (a watershed by steepest descent: every pixel on its own, then pointer
/// chasing). `root` receives the raster index of the basin's minimum, -1 on barriers. Basins meet on the ridges, so
/// the lines between them are closed, which Canny's are not.
template <class Executor>
void crease_basins(Executor& executor, const CreaseHeight& height, ImageView<std::int32_t> root) {
  executor.for_each_pixel(root.size(), DescendOp{height, root});
  executor.for_each_pixel(root.size(), FlattenForestOp{{root}});
}

/// Marks, of every two 4-neighbours in different regions, the upper or left one: a closed line.
struct RegionBorderOp {
  static constexpr int radius = 1;
  ImageView<const std::int32_t> region;
  ImageView<std::uint8_t> border;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const std::int32_t own = region(x, y);
    const std::int32_t right = access.clamped(region, x + 1, y), below = access.clamped(region, x, y + 1);
    border(x, y) = own >= 0 && ((right >= 0 && right != own) || (below >= 0 && below != own));
  }
};

template <class Executor>
void region_borders(Executor& executor, ImageView<const std::int32_t> region, ImageView<std::uint8_t> border) {
  executor.for_each_pixel(border.size(), RegionBorderOp{region, border});
}

}  // namespace facet
