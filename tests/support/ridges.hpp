#pragma once

#include <cstdint>

#include "support/masks.hpp"

namespace facet {

/// Ridges as non-maximum suppression leaves them: a third of the pixels weak (1), one in two hundred strong
/// (2).
inline Mask random_ridges(Size size, std::uint64_t seed) {
  return make_image<std::uint8_t>(size, [&](int x, int y) {
    const float u = noise_at(seed, x, y);
    return u < 0.005f ? 2 : u < 0.33f ? 1 : 0;
  });
}

/// A line of one pixel that winds inwards from the corner (0, 0), with gaps of one pixel between its turns.
inline Mask spiral_mask(int side_px) {
  Mask mask(Size{side_px, side_px});
  int x = 0, y = 0, dx = 1, dy = 0;
  const auto is_free = [&](int px, int py) { return !mask.size().contains(px, py) || mask(px, py) == 0; };
  for (int turns = 0; turns < 2;) {
    mask(x, y) = 1;
    const bool blocked = !mask.size().contains(x + dx, y + dy) || !is_free(x + 2 * dx, y + 2 * dy);
    if (!blocked) {
      x += dx, y += dy, turns = 0;
      continue;
    }
    const int old_dx = dx;
    dx = -dy, dy = old_dx, ++turns;
  }
  return mask;
}

}  // namespace facet
