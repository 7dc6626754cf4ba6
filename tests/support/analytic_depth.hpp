#pragma once

#include <algorithm>
#include <cmath>

#include "core/camera.hpp"
#include "support/awkward_frames.hpp"

namespace facet {

/// Depth along the optical axis of the plane normal . P = offset_m; 0 where the ray does not meet it.
inline Image<float> plane_depth(Size size, const Camera& camera, Vec3 normal, double offset_m) {
  return make_image<float>(size, [&](int x, int y) {
    const double along = normal.x * (x - static_cast<double>(camera.cx)) / camera.fx +
                         normal.y * (y - static_cast<double>(camera.cy)) / camera.fy + normal.z;
    const double z = offset_m / along;
    return z > 0 && std::isfinite(z) ? z : 0.0;
  });
}

/// Depth of the front of a sphere; 0 beside it.
inline Image<float> sphere_depth(Size size, const Camera& camera, Vec3 centre, double radius_m) {
  return make_image<float>(size, [&](int x, int y) {
    const double u = (x - static_cast<double>(camera.cx)) / camera.fx;
    const double v = (y - static_cast<double>(camera.cy)) / camera.fy;
    const double a = u * u + v * v + 1, b = u * centre.x + v * centre.y + centre.z;
    const double c = static_cast<double>(dot(centre, centre)) - radius_m * radius_m;
    const double root = b * b - a * c;
    return root > 0 ? (b - std::sqrt(root)) / a : 0.0;
  });
}

/// Of two depth images, the farther value of every pixel: planes bounding a convex body.
inline Image<float> farther_of(const Image<float>& a, const Image<float>& b) {
  return make_image<float>(a.size(), [&](int x, int y) { return std::max(a(x, y), b(x, y)); });
}
/// The nearer value of every pixel, missing ones (0) aside: bodies in one scene, or walls of a corner of a
/// room.
inline Image<float> nearer_of(const Image<float>& a, const Image<float>& b) {
  return make_image<float>(a.size(), [&](int x, int y) {
    if (a(x, y) == 0 || b(x, y) == 0) return a(x, y) + b(x, y);
    return std::min(a(x, y), b(x, y));
  });
}

/// Unit normal of a plane tilted by `tilt_deg` from frontal, away from the camera, its slope falling to the
/// direction `azimuth_deg` in the image.
inline Vec3 tilted_normal(double tilt_deg, double azimuth_deg) {
  const double tilt = tilt_deg * M_PI / 180, azimuth = azimuth_deg * M_PI / 180;
  return {static_cast<float>(std::sin(tilt) * std::cos(azimuth)),
          static_cast<float>(std::sin(tilt) * std::sin(azimuth)), static_cast<float>(std::cos(tilt))};
}

/// Two planes that meet in a straight crease through the centre of the image, 1 m away: each is tilted by
/// half of `turn_deg` to its side; the crease runs at right angles to `azimuth_deg`.
inline Image<float> crease_depth(Size size, const Camera& camera, double turn_deg, double azimuth_deg,
                                 bool convex) {
  const Vec3 right = tilted_normal(turn_deg / 2, azimuth_deg),
             left = tilted_normal(-turn_deg / 2, azimuth_deg);
  const Image<float> a = plane_depth(size, camera, right, static_cast<double>(right.z));
  const Image<float> b = plane_depth(size, camera, left, static_cast<double>(left.z));
  return convex ? farther_of(a, b) : nearer_of(a, b);
}

}  // namespace facet
