#include "synth/azure_kinect.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "synth/noise_field.hpp"
#include "synth/sensor_effects.hpp"

namespace facet {
namespace {

enum Stream : std::uint64_t { random_stream = 201, bias_stream, flying_stream, mixing_stream };

bool same_surface(float a, float b) {
  return a > 0 && b > 0 && std::abs(a - b) < 0.02f * std::min(a, b);
}

/// Mean depth of the pixels at -r ... +r along one axis, as far as no jump comes between; the pixel itself at
/// a jump.
float mean_along(const Image<float>& depth, int x, int y, int step_x, int step_y, int radius) {
  float sum = depth(x, y), before = sum, after = sum;
  int count = 1;
  for (int r = 1; r <= radius; ++r) {
    const int ax = x - r * step_x, ay = y - r * step_y, bx = x + r * step_x, by = y + r * step_y;
    if (!depth.size().contains(ax, ay) || !depth.size().contains(bx, by)) break;
    if (!same_surface(before, depth(ax, ay)) || !same_surface(after, depth(bx, by))) break;
    before = depth(ax, ay), after = depth(bx, by);
    sum += before + after;
    count += 2;
  }
  return sum / static_cast<float>(count);
}

/// Light that bounces between the walls of a concave corner pulls it towards the camera. Depth is a convex
/// function over a plane and at a convex edge, so that there the mean is never nearer.
Image<float> rounded_corners(const Image<float>& depth, const Camera& camera) {
  constexpr float reach_m = 0.015f;
  Image<float> out(depth.size());
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      const float z = depth(x, y);
      if (z <= 0) {
        out(x, y) = 0;
        continue;
      }
      const int radius = static_cast<int>(reach_m * camera.fx / z + 0.5f);
      const float mean =
          std::min(mean_along(depth, x, y, 1, 0, radius), mean_along(depth, x, y, 0, 1, radius));
      out(x, y) = std::min(z, mean);
    }
  }
  return out;
}

void add_flying_pixels(const Image<float>& depth, std::uint64_t seed, Image<float>& out) {
  for (int y = 1; y + 1 < depth.height(); ++y) {
    for (int x = 1; x + 1 < depth.width(); ++x) {
      const float around[] = {depth(x, y), depth(x - 1, y), depth(x + 1, y), depth(x, y - 1),
                              depth(x, y + 1)};
      const auto [near, far] = std::minmax_element(std::begin(around), std::end(around));
      if (*near <= 0 || same_surface(*near, *far)) continue;
      const std::uint64_t index =
          static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(depth.width()) + x;
      const float mix = random_uniform(seed, mixing_stream, index);
      const bool flies = random_uniform(seed, flying_stream, index) < 0.5f;
      out(x, y) = flies ? mix * *near + (1 - mix) * *far : 0;
    }
  }
}

/// Uniform values in [-1, 1) on a grid of 80 px, interpolated linearly.
float smooth_field(std::uint64_t seed, int x, int y) {
  constexpr int cell = 80;
  const auto at = [&](int i, int j) {
    return 2 * random_uniform(seed, bias_stream, static_cast<std::uint64_t>(j) * 64 + i) - 1;
  };
  const int i = x / cell, j = y / cell;
  const float u = static_cast<float>(x % cell) / cell, v = static_cast<float>(y % cell) / cell;
  return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
         v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
}

/// Vertical sides in the middle fifth of the height, from there slanted to three fifths of the width.
bool illuminated(Size size, int x, int y) {
  const float u = std::abs(2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(size.width) - 1);
  const float v = std::abs(2 * (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height) - 1);
  return u <= 1 - 0.5f * std::max(0.0f, v - 0.2f);
}

}  // namespace

float random_error_m(const AzureKinect& sensor, float depth_m, float incidence_rad) {
  const float base = std::min(0.017f, 0.0006f + 0.0005f * depth_m * depth_m);
  const float returned = sensor.reflectivity * std::max(0.05f, std::cos(incidence_rad));
  return sensor.scale * base / std::sqrt(returned);
}

Image<float> measure(const AzureKinect& sensor, const Rendering& scene, const Camera& camera,
                     std::uint64_t seed) {
  const Size size = scene.depth_m.size();
  const Image<float> angles = incidence_angles(scene, camera);
  Image<float> depth = sensor.multipath ? rounded_corners(scene.depth_m, camera) : scene.depth_m;
  if (sensor.flying_pixels) add_flying_pixels(scene.depth_m, seed, depth);
  const Image<float> noise = noise_field(size, 1, seed, random_stream);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      float& z = depth(x, y);
      if (z <= 0) continue;
      const float exact = z;
      if (sensor.systematic_error) z += smooth_field(sensor.run_seed, x, y) * (0.011f + 0.001f * exact);
      if (sensor.random_error) z += noise(x, y) * random_error_m(sensor, exact, angles(x, y));
      if (sensor.quantisation) z = std::round(z * 1000) / 1000;
      const bool seen = !sensor.mask || illuminated(size, x, y);
      if (!seen || z < sensor.nearest_m || z > sensor.farthest_m) z = 0;
    }
  }
  return depth;
}

}  // namespace facet
