#pragma once

#include <cstdint>
#include <vector>

#include "core/image_view.hpp"
#include "core/neighbours.hpp"
#include "cpu/sparse_row.hpp"

namespace facet {

/// A pixel in a list: y in the upper 16 bits, x in the lower (images are smaller than 32768 pixels a side).
/// Taking it apart costs no division.
constexpr int listed(int x, int y) {
  return y << 16 | x;
}
constexpr int x_of(int pixel) {
  return pixel & 0xFFFF;
}
constexpr int y_of(int pixel) {
  return pixel >> 16;
}

/// The pixels set in a sparse mask, in raster order.
inline void list_set_pixels(ImageView<const std::uint8_t> mask, std::vector<int>& list) {
  list.clear();
  for (int y = 0; y < mask.height; ++y)
    for_each_set_in_row(mask.row(y), mask.width, [&](int x) { list.push_back(listed(x, y)); });
}

/// visit(x, y) for every set 8-neighbour of a listed pixel.
template <class Visit>
void for_each_set_neighbour(ImageView<const std::uint8_t> mask, int pixel, const Visit& visit) {
  const int x = x_of(pixel), y = y_of(pixel);
  const bool inside = x > 0 && y > 0 && x < mask.width - 1 && y < mask.height - 1;
  FACET_UNROLL for (int k = 0; k < 8; ++k) {
    const int nx = x + neighbour8(k).dx, ny = y + neighbour8(k).dy;
    if ((inside || mask.size().contains(nx, ny)) && mask(nx, ny)) visit(nx, ny);
  }
}

}  // namespace facet
