#include "core/error.hpp"
#include "synth/shape_parts.hpp"
#include "synth/shapes.hpp"

namespace facet {
namespace {

constexpr double floor_m = 0.004;  ///< the inside of a vessel ends this far above its base

/// A strap bent to half a circle whose ends stand on the wall of the cup.
void add_handle(SceneObject& cup, double base_radius_m, double rim_radius_m, double height_m) {
  const double radius = 0.3 * height_m, width = 0.012, half_angle = 0.5 * M_PI;
  Patch strap{.shape = PatchShape::frustum, .half_angle_rad = half_angle};
  strap.radius_m = strap.end_radius_m = radius;
  strap.height_m = width;
  // The strap's axis runs along the cup's -y, its middle points along the normal of the wall at +x.
  const Vec3d up = normalized(Vec3d{rim_radius_m - base_radius_m, 0, height_m});
  const double wall_radius = base_radius_m + 0.52 * (rim_radius_m - base_radius_m);
  strap.frame = {{up.z, 0, -up.x}, up, {0, -1, 0}, {wall_radius, width / 2, 0.52 * height_m}};
  const int face = static_cast<int>(cup.faces.size()), index = static_cast<int>(cup.patches.size());
  strap.front_surface = face;
  strap.back_surface = face + 1;
  cup.faces.push_back({"handle outside", true});
  cup.faces.push_back({"handle inside", true});
  cup.patches.push_back(strap);
  for (const double z : {0.0, width}) {
    Curve rim = circle(radius, z, index, -1);
    rim.from_rad = -half_angle, rim.to_rad = half_angle;
    cup.curves.push_back(rim.moved(strap.frame));
  }
  Hull hull;
  for (int k = 0; k <= 8; ++k) {
    const double angle = half_angle * (k / 4.0 - 1);
    for (const double z : {0.0, width}) {
      hull.points.push_back(strap.frame.apply({radius * std::cos(angle), radius * std::sin(angle), z}));
    }
  }
  cup.hulls.push_back(hull);
}

}  // namespace

SceneObject make_cylinder(double radius_m, double height_m) {
  require_positive({radius_m, height_m}, "cylinder");
  SceneObject cylinder{.shape = "cylinder"};
  cylinder.faces = {{"top"}, {"bottom"}, {"side", true}};
  Patch side{.shape = PatchShape::frustum, .radius_m = radius_m, .front_surface = 2};
  side.end_radius_m = radius_m;
  side.height_m = height_m;
  cylinder.patches = {disc_patch(radius_m, height_m, true, 0), disc_patch(radius_m, 0, false, 1), side};
  cylinder.curves = {circle(radius_m, height_m, 0, 2), circle(radius_m, 0, 1, 2)};
  Hull hull;
  add_ring(hull, radius_m, 0);
  add_ring(hull, radius_m, height_m);
  cylinder.hulls = {hull};
  return cylinder;
}

SceneObject make_ball(double radius_m) {
  require_positive({radius_m}, "ball");
  SceneObject ball{.shape = "ball", .faces = {{"surface", true}}};
  Patch patch{.shape = PatchShape::sphere, .radius_m = radius_m, .low_m = -radius_m, .high_m = radius_m};
  patch.frame.origin = {0, 0, radius_m};
  ball.patches = {patch};
  ball.hulls = {{{{0, 0, radius_m}}, radius_m}};
  return ball;
}

SceneObject make_bowl(double base_radius_m, double rim_radius_m, double height_m) {
  require_positive({base_radius_m, rim_radius_m - base_radius_m, height_m - floor_m}, "bowl");
  // Sphere about (0, 0, c) through both circles.
  const double b2 = base_radius_m * base_radius_m, r2 = rim_radius_m * rim_radius_m;
  const double c = (r2 - b2 + height_m * height_m) / (2 * height_m);
  if (c < height_m) throw Error(ErrorKind::config, "bowl: it must not narrow towards its rim");
  SceneObject bowl{.shape = "bowl", .faces = {{"outside", true}, {"inside", true}, {"base"}, {"bottom"}}};
  Patch wall{.shape = PatchShape::sphere, .low_m = -c, .high_m = height_m - c, .back_surface = 1};
  wall.radius_m = std::sqrt(b2 + c * c);
  wall.frame.origin = {0, 0, c};
  const double floor_radius = std::sqrt(wall.radius_m * wall.radius_m - (floor_m - c) * (floor_m - c));
  bowl.patches = {wall, disc_patch(base_radius_m, 0, false, 2), disc_patch(floor_radius, floor_m, true, 3)};
  bowl.curves = {circle(rim_radius_m, height_m, 0, -1), circle(base_radius_m, 0, 0, 1),
                 circle(floor_radius, floor_m, 0, 2)};
  Hull hull;
  for (int k = 0; k <= 4; ++k) {
    const double z = height_m * k / 4;
    add_ring(hull, std::sqrt(wall.radius_m * wall.radius_m - (z - c) * (z - c)), z);
  }
  bowl.hulls = {hull};
  return bowl;
}

SceneObject make_cup(double base_radius_m, double rim_radius_m, double height_m, bool has_handle) {
  require_positive({base_radius_m, rim_radius_m, height_m - floor_m}, "cup");
  SceneObject cup{.shape = "cup", .faces = {{"outside", true}, {"inside", true}, {"base"}, {"bottom"}}};
  Patch wall{.shape = PatchShape::frustum, .radius_m = base_radius_m, .back_surface = 1};
  wall.end_radius_m = rim_radius_m;
  wall.height_m = height_m;
  const double floor_radius = base_radius_m + floor_m / height_m * (rim_radius_m - base_radius_m);
  cup.patches = {wall, disc_patch(base_radius_m, 0, false, 2), disc_patch(floor_radius, floor_m, true, 3)};
  cup.curves = {circle(rim_radius_m, height_m, 0, -1), circle(base_radius_m, 0, 0, 1),
                circle(floor_radius, floor_m, 0, 2)};
  Hull hull;
  add_ring(hull, base_radius_m, 0);
  add_ring(hull, rim_radius_m, height_m);
  cup.hulls = {hull};
  if (has_handle) add_handle(cup, base_radius_m, rim_radius_m, height_m);
  return cup;
}

}  // namespace facet
