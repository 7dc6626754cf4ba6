#pragma once

#include <cstdint>

#include "cpu/executor.hpp"

namespace facet {

/// Same result as the generic distance: along columns first, by one scan down and one up, then along rows.
void edge_distance(CpuExecutor& executor, ImageView<const float> depth_m,
                   ImageView<const std::uint8_t> depth_edge, int cap, ImageView<std::uint8_t> distance_px,
                   ImageView<std::uint8_t> scratch);

}  // namespace facet
