#include "synth/silhouette.hpp"

namespace facet {
namespace {

/// n . (p - eye) = 0 with n = (cos t, sin t, rise) and p = radius_m (cos t, sin t) at z = 0, for all points
/// of the generator at angle t.
std::vector<Curve> generators(const Patch& patch, Vec3d eye, int patch_index) {
  const double rise = (patch.radius_m - patch.end_radius_m) / patch.height_m;
  const double across = std::hypot(eye.x, eye.y), cosine = (patch.radius_m - rise * eye.z) / across;
  if (!(std::abs(cosine) < 1)) return {};  // the eye sees all of it, or nothing
  std::vector<Curve> out;
  for (const double sign : {-1.0, 1.0}) {
    const double angle = std::remainder(std::atan2(eye.y, eye.x) + sign * std::acos(cosine), 2 * M_PI);
    if (std::abs(angle) > patch.half_angle_rad) continue;
    const double c = std::cos(angle), s = std::sin(angle);
    Curve curve{.patch_a = patch_index};
    curve.start = patch.frame.apply({patch.radius_m * c, patch.radius_m * s, 0});
    curve.end = patch.frame.apply({patch.end_radius_m * c, patch.end_radius_m * s, patch.height_m});
    out.push_back(curve);
  }
  return out;
}

/// p . (p - eye) = 0: a circle in the plane p . eye = radius^2.
std::vector<Curve> sphere_circle(const Patch& patch, Vec3d eye, int patch_index) {
  const double distance = norm(eye), radius = patch.radius_m;
  if (distance <= radius) return {};
  const Vec3d axis = (1 / distance) * eye;
  const Vec3d side = normalized(cross(axis, std::abs(axis.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0}));
  Curve curve{.is_arc = true, .patch_a = patch_index};
  curve.frame = {side, cross(axis, side), axis, (radius * radius / distance) * axis};
  curve.radius_m = radius * std::sqrt(1 - radius * radius / (distance * distance));
  return {curve.moved(patch.frame)};
}

}  // namespace

std::vector<Curve> silhouettes(const Patch& patch, Vec3d eye, int patch_index) {
  const Vec3d local = patch.frame.unapply(eye);
  if (patch.shape == PatchShape::frustum) return generators(patch, local, patch_index);
  if (patch.shape == PatchShape::sphere) return sphere_circle(patch, local, patch_index);
  return {};
}

}  // namespace facet
