#pragma once

#include <cstdint>

#include "core/launch.hpp"
#include "stage/labelling.hpp"

namespace facet {

/// Part of a row that is looked at together: what a warp of the per-pixel launch covers.
inline constexpr int run_segment_px = Launch::block_width;

/// Every region pixel starts below the first pixel of its run, as far as that lies in its segment of the row;
/// edges and holes are -1.
struct InitRunsOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m;
  ImageView<const std::uint8_t> edge;
  ImageView<std::int32_t> root;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (!is_region(x, y)) {
      root(x, y) = -1;
      return;
    }
    int first = x;
    while (first % run_segment_px != 0 && is_region(first - 1, y)) --first;
    root(x, y) = y * root.width + first;
  }

 private:
  FACET_HD bool is_region(int x, int y) const { return depth_m(x, y) > 0 && !edge(x, y); }
};

/// Joins what InitRunsOp left apart: runs across the ends of segments, and runs below each other, these by
/// the first of the pixels they share.
struct MergeRunsOp {
  static constexpr int radius = 0;
  PixelForest forest;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (!is_region(x, y)) return;
    const int width = forest.root.width, i = y * width + x;
    const bool starts_segment = x % run_segment_px == 0;
    if (starts_segment && x > 0 && is_region(x - 1, y)) forest.unite(i, i - 1);
    if (y == 0 || !is_region(x, y - 1)) return;
    const bool left_shares = !starts_segment && is_region(x - 1, y) && is_region(x - 1, y - 1);
    if (!left_shares) forest.unite(i, i - width);
  }

 private:
  FACET_HD bool is_region(int x, int y) const { return forest.root(x, y) >= 0; }
};

/// Same result as the generic labelling, by the runs of rows: where that joins every pixel with two
/// neighbours, which on a device go all at once and leave paths through whole rows, here of an open 640 x 480
/// image one pixel in 16 is joined.
template <class Executor>
void label_runs(Executor& executor, ImageView<const float> depth_m, ImageView<const std::uint8_t> edge,
                ImageView<std::int32_t> root) {
  executor.for_each_pixel(root.size(), InitRunsOp{depth_m, edge, root});
  executor.for_each_pixel(root.size(), MergeRunsOp{{root}});
  executor.for_each_pixel(root.size(), FlattenForestOp{{root}});
}

}  // namespace facet
