#pragma once

#include <cmath>

#include "core/host_device.hpp"

namespace facet {

/// 3-vector of floats, usable in device code. Camera frame: x right, y down, z along the optical axis,
/// metres.
struct Vec3 {
  float x = 0, y = 0, z = 0;

  FACET_HD friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  FACET_HD friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  FACET_HD friend Vec3 operator*(float s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
  FACET_HD friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

FACET_HD inline float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
FACET_HD inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
FACET_HD inline float norm(Vec3 a) {
  return sqrtf(dot(a, a));
}
/// Unit vector along `a`; the zero vector stays zero.
FACET_HD inline Vec3 normalized(Vec3 a) {
  const float length = norm(a);
  return length > 0 ? Vec3{a.x / length, a.y / length, a.z / length} : Vec3{};
}

}  // namespace facet
