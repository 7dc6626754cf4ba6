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

}  // namespace facet
