#include "synth/stereo_camera.hpp"

#include <algorithm>
#include <cmath>

#include "synth/noise_field.hpp"
#include "synth/sensor_effects.hpp"

namespace facet {
namespace {

enum Stream : std::uint64_t { window_stream = 301, wide_stream, radius_stream };

/// Unit variance. Most of the error is shared by windows that overlap; the shares and widths follow the
/// residuals on planes in frames of a RealSense-like camera.
Image<float> matching_noise(Size size, std::uint64_t seed) {
  constexpr float window_share = 0.3f, wide_share = 0.7f;
  Image<float> noise = noise_field(size, 15, seed, window_stream);
  const Image<float> wide = noise_field(size, 41, seed, wide_stream);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      noise(x, y) = std::sqrt(window_share) * noise(x, y) + std::sqrt(wide_share) * wide(x, y);
    }
  }
  return noise;
}

/// Within half a window of a jump the nearer surface wins: it has the stronger texture in common.
Image<float> fattened(const Image<float>& depth, std::uint64_t seed) {
  constexpr int largest_radius = 5;
  const Image<std::uint8_t> affected = near_jump(depth, largest_radius + 1);
  const Image<float> wobble = noise_field(depth.size(), 9, seed, radius_stream);
  Image<float> out = depth;
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      if (affected(x, y) == 0) continue;
      const float radius = std::clamp(4.5f + 0.5f * wobble(x, y), 3.5f, 5.5f);  // windows of 7 to 11 px
      const int r = static_cast<int>(radius);
      float nearest = depth(x, y) > 0 ? depth(x, y) : 1e9f;
      for (int dy = -r; dy <= r; ++dy) {
        for (int dx = -r; dx <= r; ++dx) {
          if (static_cast<float>(dx * dx + dy * dy) > radius * radius ||
              !depth.size().contains(x + dx, y + dy))
            continue;
          const float other = depth(x + dx, y + dy);
          if (other > 0 && other < 0.98f * nearest) nearest = other;
        }
      }
      out(x, y) = nearest < 1e9f ? nearest : 0;
    }
  }
  return out;
}

/// Mean over 9 px in the row and then in the column, without crossing a jump.
Image<float> smoothed(const Image<float>& depth, int step_x, int step_y) {
  constexpr int radius = 4;
  Image<float> out(depth.size());
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      const float here = depth(x, y);
      float sum = 0;
      int count = 0;
      for (int r = -radius; r <= radius; ++r) {
        const int sx = x + r * step_x, sy = y + r * step_y;
        if (here <= 0 || !depth.size().contains(sx, sy)) continue;
        const float there = depth(sx, sy);
        if (std::abs(there - here) > 0.02f * here) continue;
        sum += 1 / there;  // disparity is linear over a plane
        ++count;
      }
      out(x, y) = count > 0 ? static_cast<float>(count) / sum : 0;
    }
  }
  return out;
}

}  // namespace

Image<float> measure(const StereoCamera& sensor, const Rendering& scene, const Camera& camera,
                     std::uint64_t seed) {
  const float fb = camera.fx * sensor.baseline_m;
  Image<float> depth = sensor.fattening ? fattened(scene.depth_m, seed) : scene.depth_m;
  if (sensor.occlusion) drop_hidden_from_right(sensor.baseline_m, camera, depth);
  if (sensor.smoothing) depth = smoothed(smoothed(depth, 1, 0), 0, 1);
  const Image<float> noise = matching_noise(depth.size(), seed);
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      float& z = depth(x, y);
      if (z <= 0) continue;
      if (sensor.occlusion && static_cast<float>(x) < fb / z) {
        z = 0;  // left of the second imager's field of view
        continue;
      }
      if (sensor.disparity_noise)
        z = fb / std::max(1e-3f, fb / z + sensor.scale * sensor.sigma_px * noise(x, y));
      if (sensor.quantisation) z = std::round(z * 1000) / 1000;
      if (z < sensor.nearest_m || z > sensor.farthest_m) z = 0;
    }
  }
  return depth;
}

}  // namespace facet
