#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "synth/scene.hpp"

namespace facet {

/// Throws Error{config} unless all lengths are positive.
void require_positive(std::initializer_list<double> lengths_m, const char* shape);

/// A face of a polyhedron: 3 to 5 corners, counter-clockwise seen from outside.
struct PolyhedronFace {
  std::string name;
  std::vector<Vec3d> corners;
};
/// A convex solid with one patch per face and one curve per edge.
SceneObject make_polyhedron(const char* shape, const std::vector<PolyhedronFace>& faces);

/// Disc about the z axis at height z_m, its front up or down.
Patch disc_patch(double radius_m, double z_m, bool up, int face);
/// Circle about the z axis at height z_m between two patches.
Curve circle(double radius_m, double z_m, int patch_a, int patch_b);
/// Points on the circle about the z axis at height z_m, for hulls.
void add_ring(Hull& hull, double radius_m, double z_m);

}  // namespace facet
