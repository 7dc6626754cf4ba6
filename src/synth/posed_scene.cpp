#include "synth/posed_scene.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "synth/hull_overlap.hpp"
#include "synth/intersect.hpp"

namespace facet {
namespace {

constexpr Rgb table_colour{176, 142, 104}, floor_colour{96, 98, 104}, wall_colour{188, 190, 186};

/// Horizontal or vertical rectangle with the corner `origin` and the sides u and v; its front is towards u x
/// v.
Patch rectangle(Vec3d origin, Vec3d u, Vec3d v) {
  Patch patch{.corner_count = 4, .front_surface = 0};
  patch.frame = {normalized(u), normalized(v), normalized(cross(u, v)), origin};
  patch.corners = {Vec3d{}, {norm(u), 0, 0}, {norm(u), norm(v), 0}, {0, norm(v), 0}};
  return patch;
}

}  // namespace

std::array<Vec3d, 8> bounding_corners(const Patch& patch) {
  Vec3d low{1e9, 1e9, 0}, high{-1e9, -1e9, 0};
  if (patch.shape == PatchShape::polygon) {
    for (int k = 0; k < patch.corner_count; ++k) {
      const Vec3d& c = patch.corners[k];
      low = {std::min(low.x, c.x), std::min(low.y, c.y), 0};
      high = {std::max(high.x, c.x), std::max(high.y, c.y), 0};
    }
  } else {
    const double radius = std::max(patch.radius_m, patch.end_radius_m);
    low = {-radius, -radius, patch.low_m};
    high = {radius, radius, patch.shape == PatchShape::frustum ? patch.height_m : patch.high_m};
  }
  std::array<Vec3d, 8> corners;
  for (int k = 0; k < 8; ++k) {
    corners[k] = patch.frame.apply({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  }
  return corners;
}

PosedScene::PosedScene(const Scene& scene, const RigidMotion& T_world_camera) {
  const RigidMotion T_camera_world = T_world_camera.inverse();
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const SceneObject& object = scene.objects[k];
    const RigidMotion T_camera_object = T_camera_world * object.pose;
    const std::uint16_t first = first_face_id(scene, k);
    for (const Hull& hull : posed_hulls(object)) {
      if (!hulls_overlap(hull, {{T_world_camera.origin}}, 1e-6)) continue;
      throw Error(ErrorKind::config,
                  "camera: it lies inside object " + std::to_string(k + 1) + ", a " + object.shape);
    }
    for (const Patch& patch : object.patches) {
      Patch posed = patch;
      posed.frame = T_camera_object * patch.frame;
      const int back = patch.back_surface < 0 ? patch.front_surface : patch.back_surface;
      add(posed, {.front_id = static_cast<std::uint16_t>(first + patch.front_surface),
                  .back_id = static_cast<std::uint16_t>(first + back),
                  .object_id = static_cast<std::uint16_t>(k + 1),
                  .colour = object.colour});
    }
  }
  if (scene.has_table && T_world_camera.origin.z <= 0) {
    throw Error(ErrorKind::config, "camera: it must be above the table top");
  }
  add_surroundings(scene, T_camera_world);
}

void PosedScene::add(const Patch& patch, const PosedPatch& ids) {
  PosedPatch posed = ids;
  posed.patch = patch;
  patches_.push_back(posed);
  const auto corners = bounding_corners(patch);
  const Vec3d centre = 0.5 * (corners[0] + corners[7]);
  bounds_.push_back({centre, norm(corners[7] - centre) + 1e-9});
}

void PosedScene::add_surroundings(const Scene& scene, const RigidMotion& T_camera_world) {
  const auto add_rectangle = [&](Vec3d origin, Vec3d u, Vec3d v, std::uint16_t id, Rgb colour) {
    Patch patch = rectangle(origin, u, v);
    patch.frame = T_camera_world * patch.frame;
    add(patch, {.front_id = id, .back_id = id, .object_id = 0, .colour = colour});
  };
  if (scene.has_table) {
    const double x = scene.table_half_width_m, y = scene.table_half_depth_m, slab = -0.03;
    const Rgb rim{120, 94, 66};
    add_rectangle({-x, -y, 0}, {2 * x, 0, 0}, {0, 2 * y, 0}, table_surface_id, table_colour);
    add_rectangle({-x, -y, slab}, {2 * x, 0, 0}, {0, 0, -slab}, 0, rim);
    add_rectangle({x, -y, slab}, {0, 2 * y, 0}, {0, 0, -slab}, 0, rim);
    add_rectangle({x, y, slab}, {-2 * x, 0, 0}, {0, 0, -slab}, 0, rim);
    add_rectangle({-x, y, slab}, {0, -2 * y, 0}, {0, 0, -slab}, 0, rim);
  }
  if (scene.has_room) {
    const double far = 8, floor = scene.floor_z_m, wall = scene.wall_y_m;
    add_rectangle({-far, wall - 2 * far, floor}, {2 * far, 0, 0}, {0, 2 * far, 0}, 0, floor_colour);
    add_rectangle({-far, wall, floor}, {2 * far, 0, 0}, {0, 0, far}, 0, wall_colour);
  }
}

std::optional<SceneHit> PosedScene::cast_from(Vec3d origin, Vec3d direction, double limit) const {
  const double length2 = dot(direction, direction);
  std::optional<SceneHit> best;
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const Vec3d to_centre = bounds_[k].centre - origin;
    const double along = dot(to_centre, direction), radius = bounds_[k].radius_m;
    if (dot(to_centre, to_centre) - along * along / length2 > radius * radius) continue;
    const RigidMotion& frame = patches_[k].patch.frame;
    const auto hit = intersect(patches_[k].patch, frame.unapply(origin), frame.unrotate(direction), limit);
    if (!hit) continue;
    limit = hit->distance;
    best = SceneHit{.depth_m = hit->distance, .patch = k, .front = hit->front};
  }
  if (!best) return best;
  const PosedPatch& posed = patches_[best->patch];
  best->surface_id = best->front ? posed.front_id : posed.back_id;
  best->object_id = posed.object_id;
  best->point = origin + best->depth_m * direction;
  const Vec3d normal =
      posed.patch.frame.rotate(front_normal(posed.patch, posed.patch.frame.unapply(best->point)));
  best->normal = best->front ? normal : -normal;
  return best;
}

std::optional<SceneHit> PosedScene::cast(const Camera& camera, double x_px, double y_px,
                                         double limit_m) const {
  return cast_from({}, ray_direction(camera, x_px, y_px), limit_m);
}

}  // namespace facet
