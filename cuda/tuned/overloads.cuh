#pragma once

#include "core/upload_depth.hpp"
#include "cuda/stream_executor.cuh"
#include "cuda/tuned/labelling.hpp"
#include "cuda/tuned/upload_depth.hpp"
#include "pipeline/number_regions.hpp"

namespace facet {

// The stages that run better otherwise on a device, by the names under which the pipeline calls them.

template <class Kernels>
void label_components(StreamExecutor<Kernels>& executor, ImageView<const float> depth_m,
                      ImageView<const std::uint8_t> edge, ImageView<std::int32_t> root) {
  label_runs(executor, depth_m, edge, root);
}

template <class Kernels>
int number_regions(StreamExecutor<Kernels>& executor, Buffers<StreamExecutor<Kernels>>& b,
                   const PipelineParams& params, const Camera& camera, RegionNumbering& numbering,
                   Image<std::uint16_t>& numbered, std::vector<RejectedRegion>& rejected) {
  label_components(executor, b.depth.view(), b.edge.view(), b.root.view());
  int count = 0;
  executor.scratch().regions.number(executor, b.root.view(), b.depth.view(), b.filled.view(), b.label.view(),
                                    [&](std::span<const RegionStatistics> components) {
                                      count = numbering.choose(components, b.root.size().width, camera,
                                                               params.validation, rejected);
                                      return numbering.labels();
                                    });
  if (params.contours.mode == ContourMode::edge_map) executor.download(b.label.view(), numbered.view());
  return count;
}

/// Half the bytes travel where the frame came in whole units.
template <class Kernels>
void upload_depth(StreamExecutor<Kernels>& executor, ImageView<const float> depth_m,
                  const std::optional<DepthCounts>& counts, ImageView<float> image) {
  if (!counts) return executor.upload(depth_m, image);
  DeviceImage<std::uint16_t>& counts_there = executor.scratch().counts;
  counts_there.resize(image.size());
  executor.upload(counts->counts, counts_there.view());
  executor.for_each_pixel(image.size(), MetresOfCountsOp{{counts_there.view(), counts->unit_m}, image});
}

}  // namespace facet
