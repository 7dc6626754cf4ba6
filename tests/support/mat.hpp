#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <type_traits>

#include "core/image.hpp"

namespace facet {

/// OpenCV's picture of an image: same memory, which must outlive it. Unsigned bytes, int32 and float.
template <class T>
cv::Mat_<T> as_mat(Image<T>& image) {
  if (image.empty()) return {};
  return cv::Mat_<T>(image.height(), image.width(), image.row(0),
                     sizeof(T) * static_cast<std::size_t>(image.stride()));
}
/// A copy, with `pad` zero pixels on each side.
inline cv::Mat padded_mat(const Image<std::uint8_t>& mask, int pad) {
  cv::Mat padded = cv::Mat::zeros(mask.height() + 2 * pad, mask.width() + 2 * pad, CV_8U);
  for (int y = 0; y < mask.height(); ++y)
    for (int x = 0; x < mask.width(); ++x) padded.at<std::uint8_t>(y + pad, x + pad) = mask(x, y);
  return padded;
}

}  // namespace facet
