#pragma once

#include <cstdint>

#include "core/image_view.hpp"
#include "core/pixel_forest.hpp"

namespace facet {

/// Every region pixel starts as its own component, named by its raster index; edges and holes are -1.
struct InitComponentsOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m;
  ImageView<const std::uint8_t> edge;
  ImageView<std::int32_t> root;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    root(x, y) = depth_m(x, y) > 0 && !edge(x, y) ? y * root.width + x : -1;
  }
};

/// Joins each pixel with its left and its upper neighbour.
struct MergeComponentsOp {
  static constexpr int radius = 0;
  PixelForest forest;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const int i = y * forest.root.width + x;
    if (forest.root(x, y) < 0) return;
    if (x > 0 && forest.root(x - 1, y) >= 0) forest.unite(i, i - 1);
    if (y > 0 && forest.root(x, y - 1) >= 0) forest.unite(i, i - forest.root.width);
  }
};

/// 4-connected components of the measured pixels off the 8-connected edge map: whatever the edges do, these
/// regions are closed. `root` receives the raster index of the component's first pixel, -1 on edges and
/// holes.
template <class Executor>
void label_components(Executor& executor, ImageView<const float> depth_m, ImageView<const std::uint8_t> edge,
                      ImageView<std::int32_t> root) {
  executor.for_each_pixel(root.size(), InitComponentsOp{depth_m, edge, root});
  executor.for_each_pixel(root.size(), MergeComponentsOp{{root}});
  executor.for_each_pixel(root.size(), FlattenForestOp{{root}});
}

}  // namespace facet
