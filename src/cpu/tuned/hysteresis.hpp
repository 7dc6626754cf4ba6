#pragma once

#include "cpu/executor.hpp"

namespace facet {

/// Same result as the generic hysteresis, 64 pixels at a time, in sweeps down and up the image.
void hysteresis(CpuExecutor& executor, ImageView<std::uint8_t> ridge, ImageView<std::uint8_t> edge);

}  // namespace facet
