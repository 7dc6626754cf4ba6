#pragma once

#include "cpu/executor.hpp"
#include "stage/basins.hpp"

namespace facet {

/// Same result as the generic basins: heights are computed once per pixel, the lowest neighbour is chosen
/// without branches.
void crease_basins(CpuExecutor& executor, const CreaseHeight& height, ImageView<std::int32_t> root);

}  // namespace facet
