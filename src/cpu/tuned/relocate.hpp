#pragma once

#include "cpu/executor.hpp"

namespace facet {

/// Same result as the generic relocation: walks the edge pixels and moves each, instead of asking every
/// pixel.
void relocate_to_occluding_side(CpuExecutor& executor, ImageView<const float> depth_m,
                                ImageView<const std::uint8_t> direction, ImageView<const std::uint8_t> edge,
                                ImageView<std::uint8_t> out);

}  // namespace facet
