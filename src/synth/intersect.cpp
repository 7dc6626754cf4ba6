#include "synth/intersect.hpp"

#include <utility>

namespace facet {
namespace {

bool inside_polygon(const Patch& patch, double x, double y) {
  for (int k = 0; k < patch.corner_count; ++k) {
    const Vec3d& a = patch.corners[k];
    const Vec3d& b = patch.corners[k + 1 == patch.corner_count ? 0 : k + 1];
    if ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) < 0) return false;
  }
  return true;
}

std::optional<PatchHit> intersect_flat(const Patch& patch, Vec3d origin, Vec3d direction, double limit) {
  const bool front = direction.z < 0;
  if (direction.z == 0 || (!front && patch.back_surface < 0)) return {};
  const double distance = -origin.z / direction.z;
  if (!(distance > 0) || distance >= limit || !within_trim(patch, origin + distance * direction)) return {};
  return PatchHit{distance, front};
}

/// a t^2 + 2 b t + c = 0 of the round shapes.
struct Quadratic {
  double a, b, c;
};

Quadratic quadratic_of(const Patch& patch, Vec3d o, Vec3d d) {
  if (patch.shape == PatchShape::sphere)
    return {dot(d, d), dot(o, d), dot(o, o) - patch.radius_m * patch.radius_m};
  const double slope = (patch.end_radius_m - patch.radius_m) / patch.height_m;
  const double radius = patch.radius_m + slope * o.z;  // of the cone at the height of the origin
  return {d.x * d.x + d.y * d.y - slope * slope * d.z * d.z, o.x * d.x + o.y * d.y - radius * slope * d.z,
          o.x * o.x + o.y * o.y - radius * radius};
}

std::optional<PatchHit> intersect_round(const Patch& patch, Vec3d origin, Vec3d direction, double limit) {
  const Quadratic q = quadratic_of(patch, origin, direction);
  const double discriminant = q.b * q.b - q.a * q.c;
  if (discriminant < 0 || q.a == 0) return {};
  const double root = std::sqrt(discriminant);
  double near = (-q.b - root) / q.a, far = (-q.b + root) / q.a;
  if (near > far) std::swap(near, far);
  for (const double distance : {near, far}) {
    if (!(distance > 0) || distance >= limit) continue;
    const Vec3d p = origin + distance * direction;
    if (!within_trim(patch, p)) continue;
    const bool front = dot(front_normal(patch, p), direction) < 0;
    if (front || patch.back_surface >= 0) return PatchHit{distance, front};
  }
  return {};
}

}  // namespace

bool within_trim(const Patch& patch, Vec3d p) {
  switch (patch.shape) {
    case PatchShape::polygon:
      return inside_polygon(patch, p.x, p.y);
    case PatchShape::disc:
      return p.x * p.x + p.y * p.y <= patch.radius_m * patch.radius_m;
    case PatchShape::sphere:
      return p.z >= patch.low_m && p.z <= patch.high_m;
    case PatchShape::frustum:
      return p.z >= 0 && p.z <= patch.height_m &&
             (patch.half_angle_rad > M_PI || std::abs(std::atan2(p.y, p.x)) <= patch.half_angle_rad);
  }
  return false;
}

std::optional<PatchHit> intersect(const Patch& patch, Vec3d origin, Vec3d direction, double limit) {
  const bool flat = patch.shape == PatchShape::polygon || patch.shape == PatchShape::disc;
  return flat ? intersect_flat(patch, origin, direction, limit)
              : intersect_round(patch, origin, direction, limit);
}

}  // namespace facet
