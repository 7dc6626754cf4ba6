#include "synth/sensor_effects.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "synth/noise_field.hpp"

namespace facet {
namespace {

enum Stream : std::uint64_t { displacement_x = 101, displacement_y, dropout };
constexpr float jump_share = 0.02f;

bool jumps(float a, float b) {
  return std::abs(a - b) > jump_share * std::min(a, b);
}

}  // namespace

Image<float> incidence_angles(const Rendering& scene, const Camera& camera) {
  Image<float> angles(scene.depth_m.size());
  for (int y = 0; y < angles.height(); ++y) {
    for (int x = 0; x < angles.width(); ++x) {
      const Vec3 ray = normalized(camera.back_project(static_cast<float>(x), static_cast<float>(y), 1));
      angles(x, y) = std::acos(std::clamp(-dot(ray, scene.normals(x, y)), 0.0f, 1.0f));
    }
  }
  return angles;
}

void drop_hidden_from_right(float baseline_m, const Camera& camera, Image<float>& depth) {
  const float shift = camera.fx * baseline_m;
  constexpr float margin_px = 0.75f;
  for (int y = 0; y < depth.height(); ++y) {
    float* row = depth.row(y);
    float leftmost = 1e9f;  // place in the second view reached so far, going from right to left
    for (int x = depth.width() - 1; x >= 0; --x) {
      if (row[x] <= 0) continue;
      const float place = static_cast<float>(x) - shift / row[x];
      if (place > leftmost + margin_px) row[x] = 0;
      leftmost = std::min(leftmost, place);
    }
  }
}

Image<float> displaced_outlines(const Image<float>& depth, const Image<float>& sigma_px, std::uint64_t seed) {
  constexpr int window_px = 5;
  const Size size = depth.size();
  const Image<float> dx = noise_field(size, window_px, seed, displacement_x);
  const Image<float> dy = noise_field(size, window_px, seed, displacement_y);
  Image<float> out(size);
  const auto source = [](int at, float offset, int end) {
    return std::clamp(static_cast<int>(std::lround(static_cast<float>(at) + offset)), 0, end - 1);
  };
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float here = depth(x, y), sigma = sigma_px(x, y);
      const float there =
          depth(source(x, sigma * dx(x, y), size.width), source(y, sigma * dy(x, y), size.height));
      out(x, y) = jumps(here, there) ? there : here;
    }
  }
  return out;
}

void drop_readings(float share, const Image<float>& angles, std::uint64_t seed, Image<float>& depth) {
  constexpr float grazing = 1.309f, invisible = 1.536f;
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      const float t = std::clamp((angles(x, y) - grazing) / (invisible - grazing), 0.0f, 1.0f);
      const std::uint64_t index =
          static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(depth.width()) + x;
      if (random_uniform(seed, dropout, index) < share + t * t) depth(x, y) = 0;
    }
  }
}

Image<std::uint8_t> near_jump(const Image<float>& depth, int radius_px) {
  Image<std::uint8_t> out(depth.size(), 0);
  const auto mark = [&](int x, int y, int step_x, int step_y) {
    for (int k = 1 - radius_px; k <= radius_px; ++k) {
      const int mx = x + k * step_x, my = y + k * step_y;
      if (depth.size().contains(mx, my)) out(mx, my) = 1;
    }
  };
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      if (x + 1 < depth.width() && jumps(depth(x, y), depth(x + 1, y))) mark(x, y, 1, 0);
      if (y + 1 < depth.height() && jumps(depth(x, y), depth(x, y + 1))) mark(x, y, 0, 1);
    }
  }
  return out;
}

}  // namespace facet
