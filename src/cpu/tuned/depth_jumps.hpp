#pragma once

#include "cpu/executor.hpp"
#include "stage/depth_edges.hpp"

namespace facet {

/// Same result as the generic jumps, to the bit: inverse depths are taken once, and pixels beside each other
/// are judged together.
void depth_jumps(CpuExecutor& executor, const DepthEdgeParams& params, const DepthNoise& noise,
                 ImageView<const float> depth_m, ImageView<std::uint8_t> edge);

}  // namespace facet
