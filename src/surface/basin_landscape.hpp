#pragma once

#include <cstdint>

#include "core/camera.hpp"
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
  const auto strength_of = [&](int x0, int y0, int x1, int y1) {
    const float here = landscape.known_strength(x0, y0), there = landscape.known_strength(x1, y1);
    return here > there ? here : there;
  };
  for (int y = 0; y < region.height; ++y) {
    const bool is_last = y + 1 == region.height;
    const std::int32_t *row = region.row(y), *below = region.row(is_last ? y : y + 1);
    for (int x = 0; x < region.width; ++x) {
      const std::int32_t here = row[x], right = x + 1 < region.width ? row[x + 1] : here;
      if (here < 0) continue;
      if (right != here && right >= 0) visit(here, right, x, y, false, strength_of(x, y, x + 1, y));
      if (below[x] != here && below[x] >= 0) visit(here, below[x], x, y, true, strength_of(x, y, x, y + 1));
    }
  }
}

}  // namespace facet
