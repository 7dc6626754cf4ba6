#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/image_view.hpp"

namespace facet {

/// Calls visit(x, y, down) for every two 4-neighbours with different values, in raster order of the first
/// one, (x, y), which is in the rows begin_y ... end_y - 1; the second one lies to its right, or below it if
/// `down`. Like neighbours cost little: rows are compared as vectors, and eight pixels without a change are
/// passed at once.
template <class T, class Visit>
void for_each_change(ImageView<const T> image, int begin_y, int end_y, const Visit& visit) {
  static_assert(std::endian::native == std::endian::little);
  constexpr int piece = 256;
  constexpr std::uint8_t to_right = 1, to_below = 2;
  std::uint8_t changes[piece];
  for (int y = begin_y; y < end_y; ++y)
    for (int begin = 0; begin < image.width; begin += piece) {
      const int count = std::min(piece, image.width - begin);
      const T* row = image.row(y) + begin;
      const T* below = y + 1 < image.height ? image.row(y + 1) + begin : row;
      const int with_right = begin + count < image.width ? count : count - 1;
      for (int k = 0; k < with_right; ++k)
        changes[k] = static_cast<std::uint8_t>((row[k] != row[k + 1] ? to_right : 0) |
                                               (row[k] != below[k] ? to_below : 0));
      if (with_right < count) changes[with_right] = row[with_right] != below[with_right] ? to_below : 0;
      std::fill(changes + count, changes + (count + 7) / 8 * 8, std::uint8_t{0});
      for (int first = 0; first < count; first += 8) {
        std::uint64_t word;
        std::memcpy(&word, changes + first, sizeof word);
        while (word != 0) {
          const int bit = std::countr_zero(word), k = first + bit / 8;
          visit(begin + k, y, bit % 8 != 0);
          word &= word - 1;
        }
      }
    }
}

/// In all rows.
template <class T, class Visit>
void for_each_change(ImageView<const T> image, const Visit& visit) {
  for_each_change(image, 0, image.height, visit);
}

}  // namespace facet
