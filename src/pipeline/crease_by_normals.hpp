#pragma once

#include <cstdint>

#include "stage/crease_edges.hpp"
#include "stage/normals.hpp"

namespace facet {

/// Crease strength from fitted normals [chord length, 2 sin(angle / 2)], section 3.2. `distance_px`: see
/// fit_normals. `scratch` is overwritten.
template <class Executor>
void crease_by_normals(Executor& executor, const CreaseParams& params, const Camera& camera,
                       ImageView<const std::int32_t> inverse_depth, ImageView<const std::uint8_t> distance_px,
                       const NormalViews<float>& scratch, ImageView<float> strength,
                       ImageView<std::uint8_t> direction) {
  fit_normals(executor, params.radius_px, camera, inverse_depth, distance_px, scratch);
  normal_change(executor, params, scratch, distance_px, strength, direction);
}

}  // namespace facet
