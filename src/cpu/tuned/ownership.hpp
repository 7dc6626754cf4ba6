#pragma once

#include "core/depth_noise.hpp"
#include "cpu/executor.hpp"

namespace facet {

/// Same result as the generic give_back_pixels; each pass looks only at pixels beside those that the last one
/// gave back.
void give_back_pixels(CpuExecutor& executor, float jump_ratio, float noise_sigmas, const DepthNoise& noise,
                      ImageView<const float> depth_m, ImageView<std::uint16_t> label,
                      ImageView<std::uint8_t> open, ImageView<std::uint16_t> choice);

}  // namespace facet
