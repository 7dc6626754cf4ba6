#pragma once

#include <cstdint>
#include <vector>

#include "core/image_view.hpp"
#include "core/sparse_row.hpp"

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

}  // namespace facet
