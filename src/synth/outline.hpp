#pragma once

#include <cstdint>
#include <vector>

#include "core/image.hpp"
#include "core/image_point.hpp"

namespace facet {

/// Outlines of the pixels with the value `id`, along the borders between pixels (half-integer coordinates):
/// one polygon per 4-connected part. Holes are cut open by a slit of zero width, so that the even-odd rule,
/// pixel centres inside, gives exactly these pixels back.
std::vector<ImagePath> outlines(const Image<std::uint16_t>& ids, std::uint16_t id);

}  // namespace facet
