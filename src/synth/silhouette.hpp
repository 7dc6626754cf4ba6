#pragma once

#include <vector>

#include "synth/curve.hpp"
#include "synth/patch.hpp"

namespace facet {

/// Curves on a round patch where the line of sight from `eye` only touches it; patch and eye in the same
/// frame. Two generators of a cylinder or cone, a circle of a sphere; parts outside the patch's trim may be
/// included for a sphere. Flat patches have none. `patch_a` of the result is `patch_index`.
std::vector<Curve> silhouettes(const Patch& patch, Vec3d eye, int patch_index);

}  // namespace facet
