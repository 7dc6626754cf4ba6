#pragma once

#include "cpu/executor.hpp"
#include "stage/morphology.hpp"

namespace facet {

/// Same result as the generic morphology, 64 pixels at a time.
void morphology(CpuExecutor& executor, const MorphologyParams& params, ImageView<std::uint8_t> edge,
                ImageView<std::uint8_t> scratch_a, ImageView<std::uint8_t> scratch_b);

}  // namespace facet
