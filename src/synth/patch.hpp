#pragma once

#include <array>
#include <cstdint>

#include "core/rigid_motion.hpp"

namespace facet {

enum class PatchShape : std::uint8_t {
  polygon,  ///< convex polygon of 3 to 5 corners in the plane z = 0, counter-clockwise seen from +z
  disc,     ///< |(x, y)| <= radius_m in the plane z = 0
  frustum,  ///< side of a cylinder or cone about z: radius_m at z = 0, end_radius_m at z = height_m
  sphere,   ///< part of the sphere of radius_m about the origin with low_m <= z <= high_m
};

/// A piece of a plane, cylinder, cone or sphere in a frame of its own: what rays are intersected with.
/// Its front is the side of +z for flat patches and the outside for round ones. Metres.
struct Patch {
  PatchShape shape = PatchShape::polygon;
  RigidMotion frame{};             ///< patch -> object (in an object), patch -> camera (when rendering)
  std::array<Vec3d, 5> corners{};  ///< of a polygon
  int corner_count = 0;            ///< of a polygon
  double radius_m = 0;
  double end_radius_m = 0;
  double height_m = 0;
  double half_angle_rad = 4;     ///< a frustum reaches this far from +x to both sides; > pi: all round
  double low_m = 0, high_m = 0;  ///< of a sphere
  int front_surface = 0;         ///< surface seen from the front, an index within its object
  int back_surface = -1;         ///< surface seen from behind; -1: part of a solid, never seen from there
};

/// Unit normal of the patch's front at `p`; both in the frame of the patch. `p` lies on the patch.
inline Vec3d front_normal(const Patch& patch, Vec3d p) {
  switch (patch.shape) {
    case PatchShape::sphere:
      return normalized(p);
    case PatchShape::frustum: {
      const double rise = (patch.radius_m - patch.end_radius_m) / patch.height_m;
      const double radius = std::hypot(p.x, p.y);
      return normalized(Vec3d{p.x, p.y, rise * radius});
    }
    default:
      return {0, 0, 1};
  }
}

}  // namespace facet
