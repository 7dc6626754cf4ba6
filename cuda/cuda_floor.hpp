#pragma once

#include <array>

#include "pipeline/frame_input.hpp"
#include "pipeline/params.hpp"
#include "pipeline/stage_id.hpp"

namespace facet {

/// What no stage can be faster than on this device, measured on it.
struct CudaFloor {
  double copy_bytes_per_s = 0;    ///< within the device; bytes read and bytes written both count
  double upload_bytes_per_s = 0;  ///< from pinned host memory
  double download_bytes_per_s = 0;
  double launch_us = 0;      ///< a kernel that does nothing, among many of a graph
  double round_trip_us = 0;  ///< a kernel that does nothing, waited for
};

/// Throws Error{not_measured} where there is no device.
CudaFloor measure_cuda_floor();

/// Kernels and copies that each stage gives to the device for the frame, without what the host reads; times
/// are not taken. Throws as make_cuda_pipelines() does.
std::array<int, stage_count> count_cuda_work(const PipelineParams& params, const FrameInput& frame);

}  // namespace facet
