#pragma once

#include "cpu/executor.hpp"
#include "stage/edge_kind.hpp"

namespace facet {

/// Same result as the generic stage; depth edges are told from creases 64 pixels at a time.
void edge_kind(CpuExecutor& executor, const EdgeKindParams& params, const Camera& camera,
               ImageView<const float> depth_m, ImageView<const float> gx, ImageView<const float> gy,
               ImageView<const std::uint8_t> depth_edge, ImageView<std::uint8_t> edge,
               ImageView<std::uint8_t> code);

}  // namespace facet
