#pragma once

#include "cpu/executor.hpp"
#include "pipeline/crease_by_normals.hpp"

namespace facet {

/// Same strength and direction as the generic stage gives, to the bit. The strength of a row is found as soon
/// as the normals around it are; `scratch` does not hold the normals alone afterwards.
void crease_by_normals(CpuExecutor& executor, const CreaseParams& params, const Camera& camera,
                       ImageView<const std::int32_t> inverse_depth, ImageView<const std::uint8_t> distance_px,
                       const NormalViews<float>& scratch, ImageView<float> strength,
                       ImageView<std::uint8_t> direction);

}  // namespace facet
