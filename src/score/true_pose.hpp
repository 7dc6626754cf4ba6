#pragma once

#include "surface/pose.hpp"
#include "truth/true_pose.hpp"

namespace facet {

/// The pose that a perfect method finds: on the plane, by the convention of pose_on_plane(). Flat surfaces
/// only.
inline SurfacePose pose_of(const TruePose& truth) {
  return pose_on_plane(*truth.plane, truth.centroid_m);
}

}  // namespace facet
