#pragma once

#include <cmath>
#include <optional>

#include "core/camera.hpp"
#include "core/image_point.hpp"
#include "surface/surface.hpp"
#include "surface/vec2.hpp"

namespace facet {

/// Coordinates in a plane [m] about a point of it. Turning from x to y looks the same way round as in the
/// image.
class PlaneFrame {
 public:
  PlaneFrame(const Plane& plane, const Camera& camera, Vec3 origin_m)
      : plane_(plane),
        camera_(camera),
        origin_(origin_m - plane.signed_distance_m(origin_m) * plane.normal),
        x_axis_(x_axis_of(plane.normal)),
        y_axis_(cross(x_axis_, plane.normal)) {}

  const Plane& plane() const { return plane_; }
  const Camera& camera() const { return camera_; }
  Vec3 origin_m() const { return origin_; }

  /// Where the ray through an image point meets the plane; nothing where it does so at a grazing angle or
  /// behind the camera.
  std::optional<Vec2> from_image(Vec2 px) const {
    const Vec3 ray = camera_.back_project(static_cast<float>(px.x), static_cast<float>(px.y), 1);
    const float along = dot(plane_.normal, ray);
    if (!(along < -0.02f * norm(ray))) return std::nullopt;
    return from_space((-plane_.d_m / along) * ray);
  }
  /// Of the foot of a point on the plane.
  Vec2 from_space(Vec3 p) const { return {dot(p - origin_, x_axis_), dot(p - origin_, y_axis_)}; }
  Vec3 to_space(Vec2 p) const {
    return origin_ + static_cast<float>(p.x) * x_axis_ + static_cast<float>(p.y) * y_axis_;
  }

 private:
  static Vec3 x_axis_of(Vec3 normal) {
    const Vec3 across = std::fabs(normal.x) < 0.9f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return normalized(across - dot(across, normal) * normal);
  }

  Plane plane_;
  Camera camera_;
  Vec3 origin_, x_axis_, y_axis_;
};

/// Pixel coordinates of a point in front of the camera.
inline Vec2 image_of(const Camera& camera, Vec3 p) {
  return {static_cast<double>(p.x / p.z * camera.fx + camera.cx),
          static_cast<double>(p.y / p.z * camera.fy + camera.cy)};
}

}  // namespace facet
