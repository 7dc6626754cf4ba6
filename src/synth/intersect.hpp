#pragma once

#include <optional>

#include "synth/patch.hpp"

namespace facet {

/// Where a ray meets a patch: at origin + distance * direction, on its front or on its back.
struct PatchHit {
  double distance = 0;
  bool front = true;
};

/// A point of the patch's plane, cylinder, cone or sphere lies on the patch itself; in the frame of the
/// patch.
bool within_trim(const Patch& patch, Vec3d point);

/// Nearest intersection with 0 < distance < limit of a ray given in the frame of the patch. Backs of patches
/// that belong to solids are passed through.
std::optional<PatchHit> intersect(const Patch& patch, Vec3d origin, Vec3d direction, double limit);

}  // namespace facet
