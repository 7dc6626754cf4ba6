#pragma once

#include "synth/scene.hpp"

namespace facet {

/// Bodies in their own frame: z up, resting on z = 0, centred on the z axis. All lengths in metres and
/// positive; Error{config} otherwise.
SceneObject make_box(Vec3d size_m);
/// Triangular prism: the box of that size cut along the diagonal from its upper back edge to its lower front
/// edge.
SceneObject make_wedge(Vec3d size_m);
/// A roof: two faces of size_m.x / 2 each way from a ridge along y, their normals `crease_rad` apart;
/// size_m.z is the height of its eaves above the table.
SceneObject make_ridge(Vec3d size_m, double crease_rad);
SceneObject make_cylinder(double radius_m, double height_m);
SceneObject make_ball(double radius_m);
/// Spherical shell without thickness between a flat base and an open rim; base_radius_m < rim_radius_m.
SceneObject make_bowl(double base_radius_m, double rim_radius_m, double height_m);
/// Conical shell without thickness, open at the top, with a strap handle towards +x.
SceneObject make_cup(double base_radius_m, double rim_radius_m, double height_m, bool has_handle);

/// The same body standing on what was its top: turned about x by 180 degrees, resting on z = 0 again.
RigidMotion upside_down(double height_m);
/// The same cylinder lying along y.
RigidMotion lying(double radius_m, double height_m);

}  // namespace facet
