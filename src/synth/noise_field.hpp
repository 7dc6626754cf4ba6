#pragma once

#include <cstdint>

#include "core/image.hpp"

namespace facet {

/// Standard normal value at (seed, stream, index), by Box and Muller (1958).
float random_normal(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// Noise of unit variance at every pixel: white noise averaged over a square window of `window_px` (odd, >=
/// 1) and rescaled, so that its correlation falls linearly to zero at a distance of `window_px`.
Image<float> noise_field(Size size, int window_px, std::uint64_t seed, std::uint64_t stream);

}  // namespace facet
