#include "synth/kinect_v1.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "synth/noise_field.hpp"

namespace facet {
namespace {

enum Stream : std::uint64_t { axial, lateral_x, lateral_y, dropout };
constexpr int noise_window_px = 3, outline_window_px = 7;

/// Angle between the normal and the optical axis [rad] (Nguyen et al.).
float incidence(Vec3 normal) {
  return std::acos(std::clamp(-normal.z, 0.0f, 1.0f));
}

float axial_sigma_m(float z, float angle) {
  const float base = 0.0012f + 0.0019f * (z - 0.4f) * (z - 0.4f);
  constexpr float steep = 1.0472f, limit = 1.5f,
                  right = 1.5707963f;  // 60 deg; their term has a pole at 90 deg
  if (angle < steep) return base;
  const float t = std::min(angle, limit);
  return base + 0.0001f / std::sqrt(z) * t * t / ((right - t) * (right - t));
}

float lateral_sigma_px(float angle) {
  constexpr float limit = 1.5f, right = 1.5707963f;
  const float t = std::min(angle, limit);
  return 0.8f + 0.035f * t / (right - t);
}

/// A reading is lost where a nearer point of its row, displaced by its disparity, hides it from the
/// projector.
void drop_shadow(const KinectV1& sensor, const Camera& camera, Image<float>& depth) {
  const float shift = camera.fx * sensor.baseline_m;
  constexpr float margin_px = 0.75f;
  for (int y = 0; y < depth.height(); ++y) {
    float* row = depth.row(y);
    float nearest = 1e9f;  // leftmost place in the projector's image reached so far, from right to left
    for (int x = depth.width() - 1; x >= 0; --x) {
      if (row[x] <= 0) continue;
      const float place = static_cast<float>(x) - shift / row[x];
      if (place > nearest + margin_px) row[x] = 0;
      nearest = std::min(nearest, place);
    }
  }
}

Image<float> displace_outlines(const KinectV1& sensor, const Rendering& scene, std::uint64_t seed) {
  const Size size = scene.depth_m.size();
  const Image<float> dx = noise_field(size, outline_window_px, seed, lateral_x);
  const Image<float> dy = noise_field(size, outline_window_px, seed, lateral_y);
  Image<float> out(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float sigma = sensor.scale * lateral_sigma_px(incidence(scene.normals(x, y)));
      const int sx = std::clamp(static_cast<int>(std::lround(static_cast<float>(x) + sigma * dx(x, y))), 0,
                                size.width - 1);
      const int sy = std::clamp(static_cast<int>(std::lround(static_cast<float>(y) + sigma * dy(x, y))), 0,
                                size.height - 1);
      // Only outlines move: over a smooth surface the reading stays that of the pixel itself.
      const bool jump = std::abs(scene.depth_m(sx, sy) - scene.depth_m(x, y)) > 0.02f * scene.depth_m(x, y);
      out(x, y) = jump ? scene.depth_m(sx, sy) : scene.depth_m(x, y);
    }
  }
  return out;
}

/// Disparity with noise, rounded to 1/8 px, back to depth.
float reading(const KinectV1& sensor, float z, float angle, float noise) {
  const float fb = sensor.focal_baseline_px_m;
  float disparity = fb / z;
  if (sensor.axial_noise) disparity += sensor.scale * noise * axial_sigma_m(z, angle) * fb / (z * z);
  if (sensor.quantisation) disparity = std::round(8.0f * disparity) / 8.0f;
  return disparity > 0 ? fb / disparity : 0;
}

/// Chance of losing a reading: constant, and rising to 1 between 75 and 88 degrees of incidence.
float dropout_chance(const KinectV1& sensor, float angle) {
  const float grazing = std::clamp((angle - 1.309f) / (1.536f - 1.309f), 0.0f, 1.0f);
  return std::min(1.0f, sensor.scale * sensor.dropout_share + grazing * grazing);
}

}  // namespace

Image<float> measure(const KinectV1& sensor, const Rendering& scene, const Camera& camera,
                     std::uint64_t seed) {
  const Size size = scene.depth_m.size();
  Image<float> depth = sensor.lateral_noise ? displace_outlines(sensor, scene, seed) : scene.depth_m;
  if (sensor.shadow) drop_shadow(sensor, camera, depth);
  const Image<float> noise = noise_field(size, noise_window_px, seed, axial);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      float& z = depth(x, y);
      if (z <= 0) continue;
      const Vec3 ray = normalized(camera.back_project(static_cast<float>(x), static_cast<float>(y), 1));
      const float grazing = std::acos(std::clamp(-dot(ray, scene.normals(x, y)), 0.0f, 1.0f));
      const std::uint64_t index = static_cast<std::uint64_t>(y) * size.width + x;
      const bool lost =
          sensor.dropouts && random_uniform(seed, dropout, index) < dropout_chance(sensor, grazing);
      const float value = lost ? 0 : reading(sensor, z, incidence(scene.normals(x, y)), noise(x, y));
      z = value >= sensor.nearest_m && value <= sensor.farthest_m ? value : 0;
    }
  }
  return depth;
}

}  // namespace facet
