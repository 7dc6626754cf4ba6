#pragma once

#include <cmath>

#include "core/host_device.hpp"

namespace facet {

inline constexpr float degrees_per_radian = 57.295779513f;

/// Distance of two unit vectors at this angle.
inline float chord_of(float deg) {
  return 2 * std::sin(deg / 2 / degrees_per_radian);
}

/// Angle of (x, y) in (-pi, pi] from + - * / alone, so that it is the same to the bit on every back end; a
/// minimax polynomial of degree 11 on [0, 1], absolute error below 1e-5 rad. (0, 0) gives 0.
FACET_HD inline float arctangent2(float y, float x) {
  const float ax = x < 0 ? -x : x;
  const float ay = y < 0 ? -y : y;
  const float larger = ax > ay ? ax : ay;
  const float smaller = ax > ay ? ay : ax;
  const float t = smaller / (larger > 0 ? larger : 1.0f);
  const float s = t * t;
  float angle = -0.01172120f;
  angle = angle * s + 0.05265332f;
  angle = angle * s - 0.11643287f;
  angle = angle * s + 0.19354346f;
  angle = angle * s - 0.33262347f;
  angle = (angle * s + 0.99997726f) * t;
  angle = ay > ax ? 1.57079633f - angle : angle;
  angle = x < 0 ? 3.14159265f - angle : angle;
  return y < 0 ? -angle : angle;
}

}  // namespace facet
