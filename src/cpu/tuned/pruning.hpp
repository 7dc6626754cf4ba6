#pragma once

#include "cpu/executor.hpp"
#include "stage/pruning.hpp"

namespace facet {

/// Same result as the generic pruning, 64 pixels at a time; passes skip rows where nothing can have changed.
void prune(CpuExecutor& executor, const PruningParams& params, ImageView<const float> depth_m,
           ImageView<std::uint8_t> edge, const PruningScratch& scratch);

}  // namespace facet
