#pragma once

#include <cstdint>

#include "core/camera.hpp"
#include "core/crease_strength.hpp"
#include "core/image_view.hpp"

namespace facet {

/// The over-segmentation into basins and what it was made from.
struct BasinLandscape {
  ImageView<const std::int32_t> basin;          ///< raster index of a pixel of it, -1 = none
  ImageView<const std::int32_t> inverse_depth;  ///< fixed point, as stage/normals.hpp makes it; unit below
  double inverse_depth_unit = 1;                ///< 1/m per step
  ImageView<const float> strength;              ///< crease strength, chord of the angle, or unknown_strength
  float floor = 0;                              ///< differences of strength below this are noise
  Camera camera;

  double q(int x, int y) const { return inverse_depth_unit * inverse_depth(x, y); }  ///< inverse depth [1/m]
};

}  // namespace facet
