#pragma once

#include <string_view>
#include <vector>

#include "core/image.hpp"
#include "surface/contours.hpp"

namespace facet {

/// Label image drawn as rows of characters: '.' is no label, '1' ... '9' are labels.
inline Image<std::uint16_t> label_map(const std::vector<std::string_view>& rows) {
  Image<std::uint16_t> labels({static_cast<int>(rows[0].size()), static_cast<int>(rows.size())});
  for (int y = 0; y < labels.height(); ++y)
    for (int x = 0; x < labels.width(); ++x) {
      const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      labels(x, y) = c == '.' ? std::uint16_t{0} : static_cast<std::uint16_t>(c - '0');
    }
  return labels;
}

inline std::uint16_t largest_label(const Image<std::uint16_t>& labels) {
  std::uint16_t largest = 0;
  for (int y = 0; y < labels.height(); ++y)
    for (int x = 0; x < labels.width(); ++x) largest = std::max(largest, labels(x, y));
  return largest;
}

inline std::vector<PixelBox> boxes_of(const Image<std::uint16_t>& labels) {
  std::vector<PixelBox> boxes(largest_label(labels));
  for (int y = 0; y < labels.height(); ++y)
    for (int x = 0; x < labels.width(); ++x)
      if (labels(x, y) > 0) boxes[labels(x, y) - std::size_t{1}].add(x, y);
  return boxes;
}

/// One surface per label, with nothing but its id.
inline std::vector<Surface> numbered_surfaces(std::size_t count) {
  std::vector<Surface> surfaces(count);
  for (std::size_t i = 0; i < count; ++i) surfaces[i].id = static_cast<int>(i) + 1;
  return surfaces;
}

}  // namespace facet
