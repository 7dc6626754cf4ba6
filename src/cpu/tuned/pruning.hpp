#pragma once

#include "cpu/executor.hpp"
#include "stage/pruning.hpp"

namespace facet {

/// Same result as the generic pruning; follows lists of end points instead of looking at every edge pixel per
/// pass.
void prune(CpuExecutor& executor, const PruningParams& params, ImageView<const float> depth_m,
           ImageView<std::uint8_t> edge, const PruningScratch& scratch);

}  // namespace facet
