#pragma once

#include "synth/scene.hpp"

namespace facet {

/// The two convex bodies come closer than `margin_m` (which may be negative: they overlap by more than its
/// size). Bodies in the same frame. Gilbert, Johnson and Keerthi, IEEE J. Robotics and Automation 4(2), 1988.
bool hulls_overlap(const Hull& a, const Hull& b, double margin_m);

/// Any convex part of one object overlaps one of the other, both posed in the world.
bool objects_overlap(const SceneObject& a, const SceneObject& b, double margin_m);

/// The hulls of an object in the world frame.
std::vector<Hull> posed_hulls(const SceneObject& object);

}  // namespace facet
