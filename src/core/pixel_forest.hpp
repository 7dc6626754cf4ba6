#pragma once

#include <cstdint>

#include "core/atomic.hpp"
#include "core/image_view.hpp"

namespace facet {

/// Union-find over the pixels of an image: each pixel holds the raster index of another pixel of its set,
/// roots hold their own, -1 = in no set.
struct PixelForest {
  ImageView<std::int32_t> root;

  FACET_HD std::int32_t* cell(int i) const { return &root(i % root.width, i / root.width); }
  FACET_HD int find(int i) const {
    for (int next = *cell(i); next != i; next = *cell(i)) i = next;
    return i;
  }
  /// Hangs the later root below the earlier one, so that a set ends up named by its first pixel.
  FACET_HD void unite(int a, int b) const {
    while (true) {
      a = find(a);
      b = find(b);
      if (a == b) return;
      const int low = a < b ? a : b, high = a < b ? b : a;
      const int seen = fetch_min(cell(high), low);
      if (seen == high) return;
      a = low, b = seen;  // another thread moved it meanwhile: join with what stood there
    }
  }
};

/// Replaces every pointer by its root. Threads may see each other's results: both old and new lead to the
/// root.
struct FlattenForestOp {
  static constexpr int radius = 0;
  PixelForest forest;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (forest.root(x, y) >= 0) forest.root(x, y) = forest.find(y * forest.root.width + x);
  }
};

}  // namespace facet
