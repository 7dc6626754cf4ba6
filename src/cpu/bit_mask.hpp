#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "core/image_view.hpp"
#include "core/neighbour_rule.hpp"

namespace facet {

/// A 0/1 mask with 64 pixels to the word: bit i of word k of a row is the pixel 64 k + i. Around the image
/// there is one word to the left and right of each row, and a row above and below, that are zero, so that
/// rules on neighbourhoods need no border tests. Keeps its memory.
class BitMask {
 public:
  void resize(Size size);  ///< all pixels are clear afterwards
  /// Rows of zeros and ones, a byte for each pixel: to a row that is clear, and back.
  void pack_row(int y, const std::uint8_t* bytes);
  void write_row(int y, std::uint8_t* bytes) const;
  Size size() const { return size_; }
  int words() const { return pitch_ - 2; }
  /// Words from a row to the next. Rows lie one after the other, so that a pass over a block of them is one
  /// long loop from row(y)[-1] on, the words around them included.
  std::ptrdiff_t pitch() const { return pitch_; }
  /// Clears what lies around the image in the rows first ... behind - 1, which such a pass may have set.
  void clear_around(int first, int behind);
  /// -1 <= y <= height; words -1 ... words() can be read.
  std::uint64_t* row(int y) { return words_.data() + offset(y); }
  const std::uint64_t* row(int y) const { return words_.data() + offset(y); }
  /// The pixels of the image in the last word of a row.
  std::uint64_t last_word() const { return ~std::uint64_t{0} >> (words() * 64 - size_.width); }
  void swap(BitMask& other) noexcept;

 private:
  std::ptrdiff_t offset(int y) const { return (std::ptrdiff_t{y} + 1) * pitch_ + 1; }

  Size size_;
  int pitch_ = 2;
  std::vector<std::uint64_t> words_;
};

/// visit(x) for every pixel that is set in a row, from left to right; visit(x, y) for every pixel that is
/// set, in raster order.
template <class Visit>
void for_each_set_in_row(const BitMask& mask, int y, const Visit& visit) {
  for (int k = 0; k < mask.words(); ++k)
    for (std::uint64_t rest = mask.row(y)[k]; rest != 0; rest &= rest - 1)
      visit(k * 64 + std::countr_zero(rest));
}
template <class Visit>
void for_each_set(const BitMask& mask, const Visit& visit) {
  for (int y = 0; y < mask.size().height; ++y) for_each_set_in_row(mask, y, [&](int x) { visit(x, y); });
}

/// The neighbours of 64 pixels; the arguments point at the word of three rows.
[[gnu::always_inline]] inline Neighbours<std::uint64_t> neighbours_of(const std::uint64_t* above,
                                                                      const std::uint64_t* row,
                                                                      const std::uint64_t* below) {
  const auto from_left = [](const std::uint64_t* w) { return w[0] << 1 | w[-1] >> 63; };
  const auto from_right = [](const std::uint64_t* w) { return w[0] >> 1 | w[1] << 63; };
  return {{above[0], from_right(above), from_right(row), from_right(below), below[0], from_left(below),
           from_left(row), from_left(above)}};
}

/// Dilation and erosion by the 3x3 square, `steps` times, in place; `spare` is overwritten. The image
/// continues beyond its edge as on it.
void dilate_square(int steps, BitMask& mask, BitMask& spare);
void erode_square(int steps, BitMask& mask, BitMask& spare);

/// mask = mask and not other, and, or; the first one in the rows first ... behind - 1 alone.
void subtract(BitMask& mask, const BitMask& other, int first, int behind);
void subtract(BitMask& mask, const BitMask& other);
void intersect(BitMask& mask, const BitMask& other);
void unite(BitMask& mask, const BitMask& other);

}  // namespace facet
