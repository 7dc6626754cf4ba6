#pragma once

#include <cstdint>

#include "core/camera.hpp"
#include "core/changes.hpp"
#include "core/image_view.hpp"

namespace facet {

/// Above every strength.
inline constexpr float unknown_strength = 9.0f;

/// The over-segmentation into basins and what it was made from.
struct BasinLandscape {
  ImageView<const std::int32_t> basin;          ///< raster index naming the basin, -1 = none
  ImageView<const std::int32_t> inverse_depth;  ///< fixed point, as stage/normals.hpp makes it; unit below
  double inverse_depth_unit = 1;                ///< 1/m per step
  ImageView<const float> strength;              ///< crease strength, chord of the angle
  ImageView<const std::uint8_t> distance_px;
  int guard_px = 0;  ///< strength is known where the distance is larger
  float floor = 0;   ///< differences of strength below this are noise
  Camera camera;

  double q(int x, int y) const { return inverse_depth_unit * inverse_depth(x, y); }  ///< inverse depth [1/m]
  /// unknown_strength where it is not known.
  float known_strength(int x, int y) const {
    return distance_px(x, y) > guard_px ? strength(x, y) : unknown_strength;
  }
};

/// Calls visit(a, b, x, y, down, strength) for every two 4-neighbours in different regions, a and b, in
/// raster order: (x, y) is in a, b lies below it or to its right, and the strength between them is that of
/// the stronger one.
template <class Visit>
void for_each_contact(const BasinLandscape& landscape, ImageView<const std::int32_t> region,
                      const Visit& visit) {
  for_each_change(region, [&](int x, int y, bool down) {
    const int other_x = down ? x : x + 1, other_y = down ? y + 1 : y;
    const std::int32_t a = region(x, y), b = region(other_x, other_y);
    if (a < 0 || b < 0) return;
    const float here = landscape.known_strength(x, y), there = landscape.known_strength(other_x, other_y);
    visit(a, b, x, y, down, here > there ? here : there);
  });
}

}  // namespace facet
