#pragma once

#include "cuda/stream_executor.cuh"
#include "cuda/tuned/labelling.hpp"

namespace facet {

// The stages that run better otherwise on a device, by the names under which the pipeline calls them.

template <class Kernels>
void label_components(StreamExecutor<Kernels>& executor, ImageView<const float> depth_m,
                      ImageView<const std::uint8_t> edge, ImageView<std::int32_t> root) {
  label_runs(executor, depth_m, edge, root);
}

}  // namespace facet
