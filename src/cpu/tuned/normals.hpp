#pragma once

#include "core/camera.hpp"
#include "core/vec.hpp"
#include "cpu/executor.hpp"

namespace facet {

/// Same result as the generic normal fit, to the bit: the window sums are integers, so summed-area tables
/// give them exactly, at a cost that does not depend on the window.
void fit_normals(CpuExecutor& executor, int radius_px, const Camera& camera,
                 ImageView<const std::int32_t> inverse_depth, ImageView<const std::uint8_t> distance_px,
                 ImageView<Vec3> normal);

}  // namespace facet
