#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cuda/cuda_pipeline.hpp"

namespace facet {

/// What computes the per-pixel stages of the pipeline. Results are the same to the bit.
enum class Backend { cpu, cuda };
std::string_view backend_name(Backend backend);

/// A back end, and why it was taken.
struct BackendChoice {
  Backend backend = Backend::cpu;
  std::string reason;  ///< one clause
};

/// What `asked`, which is "cpu", "cuda" or "auto", means with this program on this machine: "auto" is CUDA
/// where that can run. Throws Error{not_measured} where "cuda" cannot, Error{usage} for another word.
BackendChoice choose_backend(std::string_view asked);

/// CUDA on this machine: looked for, and tried on a small frame against the CPU, once.
const CudaSupport& cuda_support();

/// `count` pipelines that take turns with the frames of one sequence. `threads`: inside one frame, for what
/// is done on the CPU. Throws as make_cpu_pipelines() and make_cuda_pipelines() do.
std::vector<std::unique_ptr<Pipeline>> make_pipelines(Backend backend, int count,
                                                      const PipelineParams& params, std::uint64_t seed,
                                                      int threads);

}  // namespace facet
