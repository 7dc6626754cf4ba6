#pragma once

#include "synth/scene.hpp"

namespace facet {

/// Bodies in their own frame (z up, resting on z = 0, centred on the z axis). All lengths in metres.
/// Sizes must be positive; Error{config} otherwise.
SceneObject make_box(Vec3d size_m);
SceneObject make_cylinder(double radius_m, double height_m);

}  // namespace facet
