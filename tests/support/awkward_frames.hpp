#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "core/image.hpp"
#include "core/random.hpp"

namespace facet {

/// Empty, a single pixel, narrower and wider than a warp, and one whose rows are padded (631 of 640).
inline constexpr std::array<Size, 5> awkward_sizes{{{0, 0}, {1, 1}, {31, 7}, {33, 9}, {631, 479}}};

/// Image of value(x, y). The padding of its rows is set to a value that no stage should ever see.
template <class T, class Value>
Image<T> make_image(Size size, const Value& value) {
  Image<T> image(size);
  image.fill(std::numeric_limits<T>::has_quiet_NaN ? std::numeric_limits<T>::quiet_NaN()
                                                   : static_cast<T>(0xEE));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) image(x, y) = static_cast<T>(value(x, y));
  return image;
}

/// Uniform in [0, 1), a function of seed and position.
inline float noise_at(std::uint64_t seed, int x, int y) {
  return random_uniform(seed, static_cast<std::uint64_t>(y), static_cast<std::uint64_t>(x));
}

/// Depth of 0.5-3 m in square patches with a slope and 2 mm of noise, without holes.
inline Image<float> random_depth_without_holes(Size size, std::uint64_t seed) {
  return make_image<float>(size, [&](int x, int y) {
    const float patch_m = 0.5f + 2.5f * noise_at(seed, x / 12, y / 12);
    return patch_m + 0.001f * static_cast<float>(x % 12) + 0.002f * noise_at(seed + 1, x, y);
  });
}

/// The same with single missing pixels and with missing blocks.
inline Image<float> random_depth(Size size, std::uint64_t seed) {
  const Image<float> whole = random_depth_without_holes(size, seed);
  return make_image<float>(size, [&](int x, int y) {
    const bool missing = noise_at(seed + 2, x, y) < 0.05f || noise_at(seed + 3, x / 5, y / 5) < 0.1f;
    return missing ? 0.0f : whole(x, y);
  });
}

/// A tilted table, a frontal box before it, the shadow beside the box, and a round hole.
inline Image<float> table_scene(Size size) {
  return make_image<float>(size, [&](int x, int y) {
    const float u = static_cast<float>(x) / static_cast<float>(size.width);
    const float v = static_cast<float>(y) / static_cast<float>(size.height);
    if (u > 0.3f && u < 0.6f && v > 0.25f && v < 0.7f) return 0.8f;
    if (u >= 0.6f && u < 0.66f && v > 0.25f && v < 0.7f) return 0.0f;
    if ((u - 0.8f) * (u - 0.8f) + (v - 0.5f) * (v - 0.5f) < 0.01f) return 0.0f;
    return 1.0f / (0.6f + 0.4f * v);
  });
}

/// visit(depth_m) for every awkward size: random depth with holes, the table scene, and no depth at all.
template <class Visit>
void for_each_awkward_depth(const Visit& visit) {
  for (const Size size : awkward_sizes) {
    SCOPED_TRACE(std::to_string(size.width) + "x" + std::to_string(size.height));
    visit(random_depth(size, 7));
    visit(table_scene(size));
    visit(make_image<float>(size, [](int, int) { return 0; }));
  }
}

}  // namespace facet
