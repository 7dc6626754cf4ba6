#include "synth/kinect_v1.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "synth/noise_field.hpp"
#include "synth/sensor_effects.hpp"

namespace facet {
namespace {

enum Stream : std::uint64_t { axial_window, axial_near, axial_white, dots };
constexpr float right_angle = 1.5707963f,
                steepest = 1.5f;  // the terms of Nguyen et al. have a pole at 90 deg

float axial_sigma_m(const KinectV1& sensor, float z, float angle) {
  switch (sensor.axial_noise) {
    case AxialNoise::none:
      return 0;
    case AxialNoise::khoshelham:
      return 0.001425f * z * z;
    case AxialNoise::measured:
      return 0.079f / sensor.focal_baseline_px_m * z * z;
    case AxialNoise::nguyen:
      break;
  }
  const float base = 0.0012f + 0.0019f * (z - 0.4f) * (z - 0.4f);
  constexpr float steep = 1.0472f;  // 60 deg
  if (angle < steep) return base;
  const float t = std::min(angle, steepest);
  return base + 0.0001f / std::sqrt(z) * t * t / ((right_angle - t) * (right_angle - t));
}

float lateral_sigma_px(float angle) {
  const float t = std::min(angle, steepest);
  return 0.8f + 0.035f * t / (right_angle - t);
}

/// Unit variance. The shares follow the correlation of residuals on planes in OSD frames at 1, 3 and 6 px.
Image<float> matching_noise(Size size, std::uint64_t seed) {
  constexpr float window_share = 0.8f, near_share = 0.15f, white_share = 0.05f;
  Image<float> noise = noise_field(size, 9, seed, axial_window);
  const Image<float> near = noise_field(size, 3, seed, axial_near),
                     white = noise_field(size, 1, seed, axial_white);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      noise(x, y) = std::sqrt(window_share) * noise(x, y) + std::sqrt(near_share) * near(x, y) +
                    std::sqrt(white_share) * white(x, y);
    }
  }
  return noise;
}

/// What the dots of the window around a pixel say: the share of them that agrees with the pixel's disparity,
/// and the mean disparity of the others that see anything.
struct Vote {
  float agreeing = 0, others = 0, other_disparity = 0;
};

Vote vote_of_window(const Image<float>& depth, const KinectV1& sensor, int x, int y) {
  constexpr int radius = 4;
  constexpr float agreement_px = 1.0f;
  constexpr std::uint64_t pattern = 0xD07;  // the projector's pattern is the same for every frame
  const float own = depth(x, y) > 0 ? sensor.focal_baseline_px_m / depth(x, y) : -1e3f;
  Vote vote;
  float total = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      const int sx = x + dx, sy = y + dy;
      if (!depth.size().contains(sx, sy)) continue;
      const std::uint64_t index =
          static_cast<std::uint64_t>(sy) * static_cast<std::uint64_t>(depth.width()) + sx;
      if (random_uniform(pattern, dots, index) > 0.3f) continue;  // no dot here
      const float weight = 1.0f / static_cast<float>(1 + dx * dx + dy * dy);
      total += weight;
      if (depth(sx, sy) <= 0) continue;
      const float disparity = sensor.focal_baseline_px_m / depth(sx, sy);
      if (std::abs(disparity - own) < agreement_px) {
        vote.agreeing += weight;
      } else {
        vote.others += weight;
        vote.other_disparity += weight * disparity;
      }
    }
  }
  if (vote.others > 0) vote.other_disparity /= vote.others;
  const float scale = total > 0 ? 1 / total : 0;
  vote.agreeing *= scale;
  vote.others *= scale;
  return vote;
}

void match_windows(const KinectV1& sensor, Image<float>& depth) {
  constexpr float majority = 0.55f;
  const Image<float> before = depth;
  const Image<std::uint8_t> affected = near_jump(before, 4);
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      if (affected(x, y) == 0) continue;
      const Vote vote = vote_of_window(before, sensor, x, y);
      if (vote.agreeing >= majority) continue;
      depth(x, y) = vote.others >= majority ? sensor.focal_baseline_px_m / vote.other_disparity : 0;
    }
  }
}

/// Disparity with noise, rounded to 1/8 px, back to depth; 0 outside the range.
float reading(const KinectV1& sensor, float z, float angle, float noise) {
  const float fb = sensor.focal_baseline_px_m;
  float disparity = fb / z + sensor.scale * noise * axial_sigma_m(sensor, z, angle) * fb / (z * z);
  if (sensor.quantisation) disparity = std::round(8.0f * disparity) / 8.0f;
  const float value = disparity > 0 ? fb / disparity : 0;
  return value >= sensor.nearest_m && value <= sensor.farthest_m ? value : 0;
}

/// Rows and columns that OSD's frames lack because they are mapped to the colour camera: 48 rows on top (52
/// at the left), 6 columns on the left, 64 on the right (72 at the bottom), 2 rows at the bottom; in shares
/// of 640x480.
void drop_registration_border(Image<float>& depth) {
  const float w = static_cast<float>(depth.width()) / 640, h = static_cast<float>(depth.height()) / 480;
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      const float u = static_cast<float>(x) / w, v = static_cast<float>(y) / h;
      const bool inside = v >= 53 - u / 125 && v < 478 && u >= 6 && u < 577 - v / 50;
      if (!inside) depth(x, y) = 0;
    }
  }
}

}  // namespace

Image<float> measure(const KinectV1& sensor, const Rendering& scene, const Camera& camera,
                     std::uint64_t seed) {
  const Size size = scene.depth_m.size();
  const Image<float> angles = incidence_angles(scene, camera);
  Image<float> depth = scene.depth_m;
  if (sensor.lateral_noise) {
    Image<float> sigma(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) sigma(x, y) = sensor.scale * lateral_sigma_px(angles(x, y));
    }
    depth = displaced_outlines(scene.depth_m, sigma, seed);
  }
  if (sensor.shadow) drop_hidden_from_right(sensor.baseline_m, camera, depth);
  if (sensor.window_matching) match_windows(sensor, depth);
  const Image<float> noise =
      sensor.axial_noise == AxialNoise::none ? Image<float>(size, 0) : matching_noise(size, seed);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (depth(x, y) > 0) depth(x, y) = reading(sensor, depth(x, y), angles(x, y), noise(x, y));
    }
  }
  if (sensor.dropouts) drop_readings(sensor.scale * sensor.dropout_share, angles, seed, depth);
  if (sensor.registration_border) drop_registration_border(depth);
  return depth;
}

}  // namespace facet
