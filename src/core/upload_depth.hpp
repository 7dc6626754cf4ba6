#pragma once

#include <optional>

#include "core/depth_counts.hpp"

namespace facet {

/// Takes a depth image from host memory to the executor's. `counts`, where there are any, are the same depth:
/// metres_of() each is `depth_m` to the bit. A back end may take them instead.
template <class Executor>
void upload_depth(Executor& executor, ImageView<const float> depth_m, const std::optional<DepthCounts>&,
                  ImageView<float> image) {
  executor.upload(depth_m, image);
}

}  // namespace facet
