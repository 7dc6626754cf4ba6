#include "synth/shapes.hpp"

#include <initializer_list>

#include "core/error.hpp"

namespace facet {
namespace {

void require_positive(std::initializer_list<double> lengths, const char* shape) {
  for (double length : lengths) {
    if (!(length > 0)) throw Error(ErrorKind::config, std::string(shape) + ": every length must be positive");
  }
}

/// Flat patch through `corners`, which turn counter-clockwise seen from outside.
Patch flat_patch(std::initializer_list<Vec3d> corners, int face) {
  Patch patch{.shape = PatchShape::polygon, .front_surface = face};
  const Vec3d* c = corners.begin();
  patch.frame.ex = normalized(c[1] - c[0]);
  patch.frame.ez = normalized(cross(c[1] - c[0], c[2] - c[0]));
  patch.frame.ey = cross(patch.frame.ez, patch.frame.ex);
  patch.frame.origin = c[0];
  for (const Vec3d& corner : corners) patch.corners[patch.corner_count++] = patch.frame.unapply(corner);
  return patch;
}

/// Disc about the z axis at height z, its front up or down.
Patch disc_patch(double radius_m, double z_m, bool up, int face) {
  Patch patch{.shape = PatchShape::disc, .radius_m = radius_m, .front_surface = face};
  if (!up) patch.frame = rotation({1, 0, 0}, M_PI);
  patch.frame.origin = {0, 0, z_m};
  return patch;
}

}  // namespace

SceneObject make_box(Vec3d size_m) {
  require_positive({size_m.x, size_m.y, size_m.z}, "box");
  const double x = size_m.x / 2, y = size_m.y / 2, z = size_m.z;
  SceneObject box{.shape = "box"};
  box.faces = {{"top"}, {"bottom"}, {"front"}, {"back"}, {"left"}, {"right"}};
  box.patches = {flat_patch({{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}}, 0),
                 flat_patch({{-x, y, 0}, {x, y, 0}, {x, -y, 0}, {-x, -y, 0}}, 1),
                 flat_patch({{-x, -y, 0}, {x, -y, 0}, {x, -y, z}, {-x, -y, z}}, 2),
                 flat_patch({{x, y, 0}, {-x, y, 0}, {-x, y, z}, {x, y, z}}, 3),
                 flat_patch({{-x, y, 0}, {-x, -y, 0}, {-x, -y, z}, {-x, y, z}}, 4),
                 flat_patch({{x, -y, 0}, {x, y, 0}, {x, y, z}, {x, -y, z}}, 5)};
  return box;
}

SceneObject make_cylinder(double radius_m, double height_m) {
  require_positive({radius_m, height_m}, "cylinder");
  SceneObject cylinder{.shape = "cylinder"};
  cylinder.faces = {{"top"}, {"bottom"}, {"side", true}};
  cylinder.patches = {disc_patch(radius_m, height_m, true, 0),
                      disc_patch(radius_m, 0, false, 1),
                      {.shape = PatchShape::frustum,
                       .radius_m = radius_m,
                       .end_radius_m = radius_m,
                       .height_m = height_m,
                       .front_surface = 2}};
  return cylinder;
}

}  // namespace facet
