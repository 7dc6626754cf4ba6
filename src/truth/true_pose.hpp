#pragma once

#include <optional>

#include "surface/surface.hpp"

namespace facet {

/// Where a surface of the truth really is, from the geometry of a synthetic scene or a known model; camera
/// frame.
struct TruePose {
  int surface = 0;             ///< TruthSurface::number
  std::optional<Plane> plane;  ///< flat surfaces; normal towards the camera
  Vec3 centroid_m;             ///< mean of the visible points
};

}  // namespace facet
