#include "cpu/tuned/relocate.hpp"

#include "cpu/tuned/edge_list.hpp"
#include "stage/depth_edges.hpp"

namespace facet {

void relocate_to_occluding_side(CpuExecutor& executor, ImageView<const float> depth_m,
                                ImageView<const std::uint8_t> direction, ImageView<const std::uint8_t> edge,
                                ImageView<std::uint8_t> out) {
  std::vector<int>& pixels = executor.scratch().list_a;
  list_set_pixels(edge, pixels);
  executor.fill(out, std::uint8_t{0});
  const OccludingSide occluding_side{depth_m, direction};
  for (const int i : pixels) {
    const int x = x_of(i), y = y_of(i);
    const Offset move = occluding_side(x, y);
    out(x + move.dx, y + move.dy) = 1;
  }
}

}  // namespace facet
