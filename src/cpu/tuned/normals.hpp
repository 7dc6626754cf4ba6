#pragma once

#include "core/camera.hpp"
#include "cpu/executor.hpp"
#include "stage/normals.hpp"

namespace facet {

/// Same result as the generic normal fit, to the bit: the window sums are integers, exact in doubles, so the
/// sums of columns can be shared; the pixels whose windows are of one size are fitted side by side.
void fit_normals(CpuExecutor& executor, int radius_px, const Camera& camera,
                 ImageView<const std::int32_t> inverse_depth, ImageView<const std::uint8_t> distance_px,
                 const NormalViews<float>& normal);

}  // namespace facet
