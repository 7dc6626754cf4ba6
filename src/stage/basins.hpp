#pragma once

#include <cstdint>

#include "core/crease_strength.hpp"
#include "core/image_view.hpp"
#include "core/neighbours.hpp"
#include "core/pixel_forest.hpp"

namespace facet {

/// The strength where it is known: farther than the guard from the nearest depth edge; unknown_strength
/// elsewhere.
struct KnownStrengthOp {
  static constexpr int radius = 0;
  ImageView<const float> strength;
  ImageView<const std::uint8_t> distance_px;
  int guard_px;
  ImageView<float> known;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    known(x, y) = distance_px(x, y) > guard_px ? strength(x, y) : unknown_strength;
  }
};

/// Height of the landscape that water runs down: the crease strength where it is known; where a depth edge is
/// too near for it, above every known strength and falling away from the edge, so that such pixels are
/// reached last and from the inside. Barriers (depth edges, missing pixels) are infinitely high. What lies
/// below the floor, the noise of the fits, is level ground.
struct CreaseHeight {
  static constexpr float unknown = 4.0f;  ///< above the largest chord, 2
  static constexpr float barrier = 1e9f;
  ImageView<const float> strength;
  ImageView<const std::uint8_t> distance_px;
  int guard_px;
  float floor;

  FACET_HD float operator()(int x, int y) const {
    const int distance = distance_px(x, y);
    if (distance == 0) return barrier;
    if (distance <= guard_px) return unknown + static_cast<float>(guard_px - distance);
    return strength(x, y) > floor ? strength(x, y) : 0.0f;
  }
};

/// Level ground, the bottom of the large basins: 1 off it, 0 on it, which makes its connected parts regions.
struct OffFloorOp {
  static constexpr int radius = 0;
  CreaseHeight height;
  ImageView<std::uint8_t> off_floor;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    off_floor(x, y) = height(x, y) > 0;
  }
};

/// Points every pixel off the floor at the lowest of its 4-neighbours if that is lower (of equal heights, the
/// earlier pixel is lower), so that following the pointers ends in a local minimum or on the floor. -1 on
/// barriers.
struct DescendOp {
  static constexpr int radius = 0;
  CreaseHeight height;
  ImageView<std::int32_t> next;  ///< holds the floor's regions already, -1 off the floor

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    float lowest = height(x, y);
    if (!(lowest > 0) || lowest >= CreaseHeight::barrier) return;
    std::int32_t target = y * next.width + x;
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

/// Catchment basins of the crease strength: a watershed by steepest descent, every pixel on its own, then
/// pointer chasing. `root` holds, on entry, the connected parts of the floor as label_components names them
/// (-1 elsewhere) and receives the raster index that names each pixel's basin, -1 on barriers. Basins meet on
/// the ridges, so the lines between them are closed, which Canny's are not.
template <class Executor>
void crease_basins(Executor& executor, const CreaseHeight& height, ImageView<std::int32_t> root) {
  executor.for_each_pixel(root.size(), DescendOp{height, root});
  executor.for_each_pixel(root.size(), FlattenForestOp{{root}});
}

template <class Executor>
void mark_off_floor(Executor& executor, const CreaseHeight& height, ImageView<std::uint8_t> off_floor) {
  executor.for_each_pixel(off_floor.size(), OffFloorOp{height, off_floor});
}

template <class Executor>
void known_strength(Executor& executor, const CreaseHeight& height, ImageView<float> known) {
  executor.for_each_pixel(known.size(),
                          KnownStrengthOp{height.strength, height.distance_px, height.guard_px, known});
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
void region_borders(Executor& executor, ImageView<const std::int32_t> region,
                    ImageView<std::uint8_t> border) {
  executor.for_each_pixel(border.size(), RegionBorderOp{region, border});
}

}  // namespace facet
