#pragma once

#include "cpu/executor.hpp"

namespace facet {

/// Same result as the generic hysteresis, in one flood from the strong ridges instead of repeated passes.
void hysteresis(CpuExecutor& executor, ImageView<std::uint8_t> ridge, ImageView<std::uint8_t> edge);

}  // namespace facet
