#pragma once

#include <opencv2/imgproc.hpp>

#include "support/mat.hpp"

namespace facet {

/// Number of 8-connected components of the set pixels, and of 4-connected components of the rest (the
/// surroundings of the image are one of them).
struct Topology {
  int lines = 0, regions = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

inline Topology topology_of(const Image<std::uint8_t>& mask) {
  const cv::Mat padded = padded_mat(mask, 1);
  cv::Mat labels;
  return {cv::connectedComponents(padded, labels, 8) - 1,
          cv::connectedComponents(padded == 0, labels, 4) - 1};
}

/// Number of 4-connected regions that the set pixels and the image border bound.
inline int count_regions(const Image<std::uint8_t>& mask) {
  cv::Mat labels;
  return cv::connectedComponents(padded_mat(mask, 0) == 0, labels, 4) - 1;
}

/// Number of 2x2 blocks of set pixels.
inline int count_blocks(const Image<std::uint8_t>& mask) {
  int count = 0;
  for (int y = 0; y + 1 < mask.height(); ++y)
    for (int x = 0; x + 1 < mask.width(); ++x)
      count += mask(x, y) && mask(x + 1, y) && mask(x, y + 1) && mask(x + 1, y + 1);
  return count;
}

}  // namespace facet
