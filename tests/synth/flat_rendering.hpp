#pragma once

#include <cmath>

#include "synth/render.hpp"

namespace facet {

inline constexpr Camera test_camera{525, 525, 159.5f, 119.5f};

/// A wall of 320 x 240 pixels, `depth_m` away in the middle, turned about the vertical by `tilt_rad`.
inline Rendering wall(float depth_m, float tilt_rad = 0) {
  Rendering image;
  image.depth_m = Image<float>({320, 240}, depth_m);
  image.normals = Image<Vec3>({320, 240}, Vec3{std::sin(tilt_rad), 0, -std::cos(tilt_rad)});
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const float u = (static_cast<float>(x) - test_camera.cx) / test_camera.fx;
      image.depth_m(x, y) = depth_m / (1 - u * std::tan(tilt_rad));
    }
  }
  return image;
}

/// The wall with a nearer rectangle in front: columns 150 ... 199, rows 60 ... 179.
inline Rendering wall_with_plate(float wall_m, float plate_m) {
  Rendering image = wall(wall_m);
  for (int y = 60; y < 180; ++y) {
    for (int x = 150; x < 200; ++x) image.depth_m(x, y) = plate_m;
  }
  return image;
}

struct Spread {
  double mean = 0, deviation = 0;
};

/// Of the readings that are not missing.
inline Spread spread_of(const Image<float>& depth) {
  double n = 0, sum = 0, squares = 0;
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      const double z = depth(x, y);
      if (z > 0) ++n, sum += z, squares += z * z;
    }
  }
  return {sum / n, std::sqrt(squares / n - sum / n * (sum / n))};
}

}  // namespace facet
