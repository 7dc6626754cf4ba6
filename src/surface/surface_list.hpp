#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image_view.hpp"
#include "surface/regions.hpp"
#include "surface/surface.hpp"
#include "surface/validation.hpp"

namespace facet {

/// Fills area, touches_border and graspable of every surface. A surface is graspable here if a graspable edge
/// lies on its own outline.
void describe_surfaces(const RegionPixels& pixels, Size size, ImageView<const std::uint8_t> edges,
                       std::vector<Surface>& surfaces);

/// Drops the surfaces that fail the validation, with their reasons, and numbers the rest anew from 1, in the
/// same order, in `surfaces` (parents and children too), in `labels` and in `pixels.points`.
void drop_invalid_surfaces(const ValidationParams& params, RegionPixels& pixels,
                           ImageView<std::uint16_t> labels, std::vector<Surface>& surfaces,
                           std::vector<RejectedRegion>& rejected);

/// One sentence for a frame without surfaces.
std::string why_nothing_was_found(ImageView<const float> depth_m,
                                  const std::vector<RejectedRegion>& rejected);

}  // namespace facet
