#pragma once

#include <vector>

namespace facet {

/// A point of the image plane [px]: pixel centres at integer coordinates, x right, y down.
struct ImagePoint {
  double x = 0, y = 0;
  friend bool operator==(const ImagePoint&, const ImagePoint&) = default;
};
/// A closed polygon or an open line, by its use.
using ImagePath = std::vector<ImagePoint>;

}  // namespace facet
