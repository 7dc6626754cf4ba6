#include "cpu/tuned/edge_distance.hpp"

#include <algorithm>

#include "core/clones.hpp"

namespace facet {
namespace {

/// Distances along the columns to the barriers above; `above`: those of the row before.
FACET_CPU_CLONES void scan_down(const float* depth_m, const std::uint8_t* edge, const std::uint8_t* above,
                                int cap, int begin, int end, std::uint8_t* distance_px) {
  for (int x = begin; x < end; ++x) {
    const bool open = (depth_m[x] > 0) & (edge[x] == 0);
    const int next = std::min(above[x] + 1, cap);
    distance_px[x] = static_cast<std::uint8_t>(open ? next : 0);
  }
}

/// The same to those above or below, whichever is nearer.
FACET_CPU_CLONES void scan_up(const std::uint8_t* below, int begin, int end, std::uint8_t* distance_px) {
  for (int x = begin; x < end; ++x)
    distance_px[x] = static_cast<std::uint8_t>(std::min<int>(distance_px[x], below[x] + 1));
}

/// Chessboard distances from those along the columns.
FACET_CPU_CLONES void scan_across(const std::uint8_t* along_columns, int cap, int width,
                                  std::uint8_t* distance_px) {
  std::copy_n(along_columns, width, distance_px);
  for (int k = 1; k < cap; ++k) {
    const auto most = static_cast<std::uint8_t>(k);
    const int begin = std::min(k, width), end = std::max(width - k, begin);
    for (int x = 0; x < begin; ++x) distance_px[x] = std::min(distance_px[x], most);
    for (int x = end; x < width; ++x) distance_px[x] = std::min(distance_px[x], most);
    for (int x = begin; x < end; ++x) {
      const std::uint8_t nearer = std::min(along_columns[x - k], along_columns[x + k]);
      distance_px[x] = std::min(distance_px[x], std::max(nearer, most));
    }
  }
}

}  // namespace

void edge_distance(CpuExecutor& executor, ImageView<const float> depth_m,
                   ImageView<const std::uint8_t> depth_edge, int cap, ImageView<std::uint8_t> distance_px,
                   ImageView<std::uint8_t> scratch) {
  if (scratch.size().empty()) return;
  const int width = scratch.width, last = scratch.height - 1;
  executor.for_each_band(width, [&](int begin, int end) {  // outside the image the distance is 0
    std::fill(scratch.row(0) + begin, scratch.row(0) + end, std::uint8_t{0});
    for (int y = 0; y <= last; ++y)
      scan_down(depth_m.row(y), depth_edge.row(y), scratch.row(std::max(y - 1, 0)), cap, begin, end,
                scratch.row(y));
    for (int x = begin; x < end; ++x) scratch(x, last) = std::min(scratch(x, last), std::uint8_t{1});
    for (int y = last - 1; y >= 0; --y) scan_up(scratch.row(y + 1), begin, end, scratch.row(y));
  });
  executor.for_each_row(scratch.height,
                        [&](int y) { scan_across(scratch.row(y), cap, width, distance_px.row(y)); });
}

}  // namespace facet
