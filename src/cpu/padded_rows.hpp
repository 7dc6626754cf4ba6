#pragma once

#include <algorithm>
#include <array>

#include "core/image_view.hpp"

namespace facet {

/// Rows from `radius` above to `radius` below a row; [0] of each is the first pixel of a piece.
template <int radius>
using RowsAround = std::array<const float*, 2 * radius + 1>;

/// The rows around a row of an image, a piece of them, in the first-level cache: for windows of that radius,
/// whose rows come one after the other. Beyond the image its nearest pixels stand, so that no window needs a
/// border test.
template <int radius>
class PaddedRows {
 public:
  static constexpr int side = 2 * radius + 1;
  static constexpr int most = 640;  ///< pixels of a piece
  static constexpr int pitch = most + 2 * radius;

  /// The pixels begin ... end - 1 of an image's rows.
  PaddedRows(ImageView<const float> image, int begin, int end) : image_(image), begin_(begin), end_(end) {}

  /// What the windows of row y reach; asked for row by row, from the first of a band on.
  RowsAround<radius> around(int y) {
    const int last = std::min(y + radius, image_.height - 1);
    const int first = loaded_ < 0 ? std::max(y - radius, 0) : loaded_ + 1;
    for (int i = first; i <= last; ++i) load_row(i);
    loaded_ = last;
    RowsAround<radius> rows;
    for (std::size_t j = 0; j < rows.size(); ++j)
      rows[j] = slots_[std::clamp(y + static_cast<int>(j) - radius, 0, image_.height - 1) % side] + radius;
    return rows;
  }

 private:
  void load_row(int y) {
    const float* from = image_.row(y);
    float* to = slots_[y % side];
    const int first = begin_ - radius, behind = end_ + radius;
    const int left = std::max(first, 0), right = std::min(behind, image_.width);
    to = std::fill_n(to, left - first, from[0]);
    to = std::copy(from + left, from + right, to);
    std::fill_n(to, behind - right, from[image_.width - 1]);
  }

  ImageView<const float> image_;
  int begin_, end_;
  int loaded_ = -1;
  float slots_[side][pitch];
};

}  // namespace facet
