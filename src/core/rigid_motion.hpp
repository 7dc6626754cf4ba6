#pragma once

#include <cmath>

#include "core/vec.hpp"

namespace facet {

/// 3-vector of doubles: scenes and their truth are computed in double precision.
struct Vec3d {
  double x = 0, y = 0, z = 0;

  friend Vec3d operator+(Vec3d a, Vec3d b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3d operator-(Vec3d a, Vec3d b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3d operator-(Vec3d a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3d operator*(double s, Vec3d a) { return {s * a.x, s * a.y, s * a.z}; }
  friend bool operator==(const Vec3d&, const Vec3d&) = default;
};

inline double dot(Vec3d a, Vec3d b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3d cross(Vec3d a, Vec3d b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Vec3d a) {
  return std::sqrt(dot(a, a));
}
/// Unit vector along `a`, which must not be zero.
inline Vec3d normalized(Vec3d a) {
  return (1.0 / norm(a)) * a;
}
inline Vec3 to_float(Vec3d a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

/// Rigid motion: an orthonormal right-handed basis and an origin, both in the parent's frame.
struct RigidMotion {
  Vec3d ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};
  Vec3d origin{};

  Vec3d rotate(Vec3d v) const { return v.x * ex + v.y * ey + v.z * ez; }
  Vec3d unrotate(Vec3d v) const { return {dot(v, ex), dot(v, ey), dot(v, ez)}; }
  Vec3d apply(Vec3d p) const { return origin + rotate(p); }
  Vec3d unapply(Vec3d p) const { return unrotate(p - origin); }
  RigidMotion inverse() const {
    return {{ex.x, ey.x, ez.x}, {ex.y, ey.y, ez.y}, {ex.z, ey.z, ez.z}, -unrotate(origin)};
  }
  /// First `b`, then `a`.
  friend RigidMotion operator*(const RigidMotion& a, const RigidMotion& b) {
    return {a.rotate(b.ex), a.rotate(b.ey), a.rotate(b.ez), a.apply(b.origin)};
  }
};

inline RigidMotion translation(Vec3d t) {
  return {.origin = t};
}
/// Rotation about a unit axis through the origin, right-handed.
inline RigidMotion rotation(Vec3d axis, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  const auto turn = [&](Vec3d v) { return c * v + s * cross(axis, v) + ((1 - c) * dot(axis, v)) * axis; };
  return {turn({1, 0, 0}), turn({0, 1, 0}), turn({0, 0, 1}), {}};
}

}  // namespace facet
