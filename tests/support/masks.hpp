#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/awkward_frames.hpp"

namespace facet {

using Mask = Image<std::uint8_t>;

/// 0/1 mask drawn with characters, '#' = 1; all rows of equal length.
inline Mask drawn_mask(const std::vector<std::string>& rows) {
  const Size size{static_cast<int>(rows[0].size()), static_cast<int>(rows.size())};
  return make_image<std::uint8_t>(size, [&](int x, int y) {
    return rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#' ? 1 : 0;
  });
}

/// Every pixel set with the given probability.
inline Mask random_mask(Size size, std::uint64_t seed, float density) {
  return make_image<std::uint8_t>(size, [&](int x, int y) { return noise_at(seed, x, y) < density ? 1 : 0; });
}

/// Smooth blobs with holes: interpolated noise above its mean.
inline Mask blob_mask(Size size, std::uint64_t seed, int period_px = 9) {
  return make_image<std::uint8_t>(size, [&](int x, int y) {
    const int cx = x / period_px, cy = y / period_px;
    const float u = static_cast<float>(x % period_px) / static_cast<float>(period_px);
    const float v = static_cast<float>(y % period_px) / static_cast<float>(period_px);
    const float top = (1 - u) * noise_at(seed, cx, cy) + u * noise_at(seed, cx + 1, cy);
    const float bottom = (1 - u) * noise_at(seed, cx, cy + 1) + u * noise_at(seed, cx + 1, cy + 1);
    return (1 - v) * top + v * bottom > 0.5f ? 1 : 0;
  });
}

/// Lines of one pixel: the borders between irregular cells, with gaps and stray pixels, as an edge map has
/// them.
inline Mask line_mask(Size size, std::uint64_t seed) {
  const Mask blobs = blob_mask(size, seed, 17);
  return make_image<std::uint8_t>(size, [&](int x, int y) {
    const bool border =
        blobs(x, y) != blobs(x > 0 ? x - 1 : x, y) || blobs(x, y) != blobs(x, y > 0 ? y - 1 : y);
    return (border && noise_at(seed + 1, x, y) > 0.02f) || noise_at(seed + 2, x, y) < 0.005f ? 1 : 0;
  });
}

inline int count_set(const Mask& mask) {
  int count = 0;
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x) count += mask(x, y) != 0;
  return count;
}

/// visit(mask) for every awkward size: noise, blobs, lines, nothing set, all set.
template <class Visit>
void for_each_awkward_mask(const Visit& visit) {
  for (const Size size : awkward_sizes) {
    SCOPED_TRACE(std::to_string(size.width) + "x" + std::to_string(size.height));
    visit(random_mask(size, 3, 0.4f));
    visit(blob_mask(size, 4));
    visit(line_mask(size, 5));
    visit(random_mask(size, 1, 0.0f));
    visit(random_mask(size, 1, 1.0f));
  }
}

}  // namespace facet
