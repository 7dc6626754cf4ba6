#pragma once

#include "cuda/kernels.cuh"
#include "cuda/stream_executor.cuh"

namespace facet {

/// The executor of the CUDA back end.
using CudaExecutor = StreamExecutor<CudaKernels>;

}  // namespace facet
