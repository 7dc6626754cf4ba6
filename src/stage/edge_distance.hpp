#pragma once

#include <cstdint>
#include <utility>

#include "core/image_view.hpp"

namespace facet {

/// Pixels no fit may reach across: depth edges and missing depth get distance 0, all others the cap.
struct BarrierOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m;
  ImageView<const std::uint8_t> depth_edge;
  std::uint8_t cap;
  ImageView<std::uint8_t> distance_px;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const bool open = (depth_m(x, y) > 0) & !depth_edge(x, y);
    distance_px(x, y) = open ? cap : std::uint8_t{0};
  }
};

/// One relaxation: at most one more than the smallest neighbour; outside the image the distance is 0.
struct RelaxDistanceOp {
  static constexpr int radius = 1;
  ImageView<const std::uint8_t> in;
  ImageView<std::uint8_t> out;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    std::uint8_t smallest = 255;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const auto d = static_cast<std::uint8_t>(access.or_zero(in, x + dx, y + dy));
        smallest = d < smallest ? d : smallest;
      }
    const auto next = static_cast<std::uint8_t>(smallest + 1);
    const std::uint8_t own = in(x, y);
    out(x, y) = own < next ? own : next;
  }
};

/// Chessboard distance [px] to the nearest depth edge, missing pixel or pixel outside the image, capped at
/// `cap`: a square window of half side distance - 1 around the pixel is free of them. `scratch` is
/// overwritten.
template <class Executor>
void edge_distance(Executor& executor, ImageView<const float> depth_m,
                   ImageView<const std::uint8_t> depth_edge, int cap, ImageView<std::uint8_t> distance_px,
                   ImageView<std::uint8_t> scratch) {
  ImageView<std::uint8_t> from = distance_px, to = scratch;
  if (cap % 2 == 1) std::swap(from, to);  // so that the last pass ends in distance_px
  executor.for_each_pixel(from.size(), BarrierOp{depth_m, depth_edge, static_cast<std::uint8_t>(cap), from});
  for (int pass = 0; pass < cap; ++pass) {
    executor.for_each_pixel(from.size(), RelaxDistanceOp{from, to});
    std::swap(from, to);
  }
}

}  // namespace facet
